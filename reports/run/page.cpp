// SPDX-License-Identifier: MIT
#include "reports/run/page.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "reports/run/report_data.hpp"

// The templates as bytes of this program, by the assembler.
asm(".pushsection .rodata\n"
    "daylight_report_template:\n"
    ".incbin \"" DAYLIGHT_REPORT_TEMPLATE
    "\"\n"
    "daylight_report_template_end:\n"
    ".byte 0\n"
    "daylight_scene_template:\n"
    ".incbin \"" DAYLIGHT_SCENE_TEMPLATE
    "\"\n"
    "daylight_scene_template_end:\n"
    ".byte 0\n"
    ".popsection\n");
extern "C" const char daylight_report_template[], daylight_report_template_end[], daylight_scene_template[],
    daylight_scene_template_end[];

namespace cyl {
namespace {

std::string_view template_of(Template which) {
  const bool report = which == Template::report;
  const char* begin = report ? daylight_report_template : daylight_scene_template;
  const char* end = report ? daylight_report_template_end : daylight_scene_template_end;
  return {begin, static_cast<std::size_t>(end - begin)};
}

/// Stands in the template where the data goes, once.
constexpr std::string_view place_of_data = "@@DAYLIGHT_REPORT_DATA@@";

void write_whole(const std::string& file, const std::string& text) {
  const std::string unfinished = fmt::format("{}.{}", file, getpid());
  std::ofstream out(unfinished, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + unfinished);
  std::filesystem::rename(unfinished, file);
}

}  // namespace

std::string fill_template(Template which, std::string_view json) {
  const std::string_view page = template_of(which);
  const std::size_t at = page.find(place_of_data);
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
  filled += page.substr(at + place_of_data.size());
  return filled;
}

void write_page(const std::string& run_folder, const std::string& kill_matrix) {
  write_whole(run_folder + "/report.html",
              fill_template(Template::report, report_json(run_folder, kill_matrix)));
}

}  // namespace cyl
