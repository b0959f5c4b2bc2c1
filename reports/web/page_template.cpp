// SPDX-License-Identifier: MIT
#include "reports/web/page_template.hpp"

#include <stdexcept>

// The template as bytes of this program, by the assembler.
asm(".pushsection .rodata\n"
    "daylight_page_template:\n"
    ".incbin \"" DAYLIGHT_PAGE_TEMPLATE
    "\"\n"
    "daylight_page_template_end:\n"
    ".byte 0\n"
    ".popsection\n");
extern "C" const char daylight_page_template[], daylight_page_template_end[];

namespace cyl {

std::string fill_template(std::string_view json) {
  constexpr std::string_view mark = "@@DAYLIGHT_REPORT_DATA@@";  // stands where the data go, once
  const std::string_view page(daylight_page_template,
                              static_cast<std::size_t>(daylight_page_template_end - daylight_page_template));
  const std::size_t at = page.find(mark);
  if (at == page.npos) throw std::runtime_error("the template of the page has no place for data");
  std::string filled(page.substr(0, at));
  filled.reserve(page.size() + json.size());
  for (const char c : json) {
    if (c == '<') {
      filled += "\\u003c";
    } else {
      filled += c;
    }
  }
  filled += page.substr(at + mark.size());
  return filled;
}

}  // namespace cyl
