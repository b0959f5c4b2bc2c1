// SPDX-License-Identifier: MIT
#include "reports/run/draw_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "base/process/child.hpp"
#include "reports/run/report_data.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// Runs a program and drops its standard output. Returns whether the program succeeded.
bool runs_well(const std::vector<std::string>& command, const std::string& input = {}) {
  return Child(command, {.input = input}).wait() == 0;
}

bool installed(const char* program) {
  return runs_well({"/bin/sh", "-c", "command -v \"$0\" >/dev/null 2>&1", program});
}

/// Runs a program on files. Their paths are absolute, so that it does not take them for options. Throws
/// std::runtime_error if the program fails.
void run(const std::vector<std::string>& options, const std::vector<fs::path>& files,
         const std::string& input = {}) {
  std::vector<std::string> command = options;
  for (const fs::path& file : files) command.push_back(fs::absolute(file).string());
  if (!runs_well(command, input))
    throw std::runtime_error(fmt::format("failed: {}", fmt::join(command, " ")));
}

}  // namespace

std::vector<std::string> draw_charts(const RunData& data, const std::string& out, const std::string& script,
                                     const std::function<void(std::size_t, std::size_t)>& on_picture) {
  if (!installed("node")) throw std::runtime_error("charts need Node.js: apt-get install nodejs");
  if (script.empty()) throw std::runtime_error("reports/web/chart.mjs is not beside this program");
  const auto began = fs::file_time_type::clock::now();
  run({"node"}, {script, out}, report_json(data));
  const bool png = installed("rsvg-convert");
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(out))
    if (entry.path().extension() == ".svg" && entry.last_write_time() >= began)
      files.push_back(entry.path().string());
  const std::size_t pictures = files.size();
  for (std::size_t i = 0; i < pictures && png; ++i) {
    const fs::path image = fs::path(files[i]).replace_extension(".png");
    run({"rsvg-convert", "--zoom", "2", "--output"}, {image, files[i]});
    files.push_back(image.string());
    on_picture(i + 1, pictures);
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace cyl
