// SPDX-License-Identifier: MIT
#include "reports/run/page_template.hpp"

#include <zlib.h>

#include <stdexcept>

// The assembler includes the template as bytes of this program.
asm(".pushsection .rodata\n"
    "daylight_page_template:\n"
    ".incbin \"" DAYLIGHT_PAGE_TEMPLATE
    "\"\n"
    "daylight_page_template_end:\n"
    ".byte 0\n"
    ".popsection\n");
extern "C" const char daylight_page_template[], daylight_page_template_end[];

namespace cyl {
namespace {

/// zlib's level. The default, 6, takes 1.7 times as long, and the page becomes 7 % smaller.
constexpr int page_compression = 4;

std::string compressed(std::string_view text) {
  uLongf size = compressBound(text.size());
  std::string bytes(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                text.size(), page_compression) != Z_OK)
    throw std::runtime_error("compressing the data of the page failed");
  bytes.resize(size);
  return bytes;
}

std::string base64(std::string_view bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned three = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      three = three << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0);
    for (int shift = 18; shift >= 0; shift -= 6) text += digits[three >> shift & 63];
  }
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  return text.replace(text.size() - missing, missing, missing, '=');
}

}  // namespace

std::string fill_template(std::string_view json) {
  constexpr std::string_view mark = "@@DAYLIGHT_REPORT_DATA@@";
  const std::string_view page(daylight_page_template,
                              static_cast<std::size_t>(daylight_page_template_end - daylight_page_template));
  std::string filled(page);
  return filled.replace(page.find(mark), mark.size(), base64(compressed(json)));
}

}  // namespace cyl
