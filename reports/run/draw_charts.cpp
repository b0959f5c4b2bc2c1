// SPDX-License-Identifier: MIT
#include "reports/run/draw_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "base/safe_text.hpp"
#include "reports/run/report_data.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// As one word that no program takes for an option.
std::string argument(const fs::path& path) { return shell_quoted(fs::absolute(path).string()); }

bool installed(const char* program) {
  return std::system(fmt::format("command -v {} >/dev/null 2>&1", program).c_str()) == 0;
}

/// What the script says on standard output is dropped: the folder tells what it wrote.
void draw(const std::string& script, const std::string& out, const std::string& report) {
  const std::string command = fmt::format("node {} {} >/dev/null", argument(script), argument(out));
  std::FILE* node = popen(command.c_str(), "w");
  if (node == nullptr) throw std::runtime_error("cannot run " + command);
  const bool written = std::fwrite(report.data(), 1, report.size(), node) == report.size();
  if (pclose(node) != 0 || !written) throw std::runtime_error("failed: " + command);
}

}  // namespace

std::vector<std::string> draw_charts(const std::string& run_folder, const std::string& out,
                                     const std::string& script) {
  if (!installed("node")) throw std::runtime_error("charts need Node.js: apt-get install nodejs");
  if (script.empty()) throw std::runtime_error("reports/web/chart.mjs is not beside this program");
  const auto began = fs::file_time_type::clock::now();
  draw(script, out, report_json(run_folder));
  const bool png = installed("rsvg-convert");
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(out)) {
    if (entry.path().extension() != ".svg" || entry.last_write_time() < began) continue;
    files.push_back(entry.path().string());
    if (!png) continue;
    const fs::path image = fs::path(entry.path()).replace_extension(".png");
    const std::string command =
        fmt::format("rsvg-convert --zoom 2 --output {} {}", argument(image), argument(entry.path()));
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
    files.push_back(image.string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace cyl
