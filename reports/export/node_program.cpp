// SPDX-License-Identifier: MIT
#include "reports/export/node_program.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <system_error>

#include "base/json.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Matches `import x from 'name'`, `import 'name'`, `import('name')` and `require('name')`.
const std::regex import_pattern(R"((?:from|import|require)\s*\(?\s*['"]([^'"]+)['"])");

/// Returns the version of each package that package.json in `folder` states. Empty if it states none.
nlohmann::json dependencies_of(const fs::path& folder) {
  const nlohmann::json package = nlohmann::json::parse(content_of(folder / "package.json"), nullptr, false);
  const bool stated = package.is_object() && package.contains("dependencies");
  return stated ? package["dependencies"] : nlohmann::json();
}

}  // namespace

NodeProgram node_program(const fs::path& file) {
  NodeProgram program{{file.filename().string()}, {}};
  const std::string kind = file.extension();
  if (kind != ".mjs" && kind != ".cjs" && kind != ".js") return program;
  const fs::path folder = file.parent_path();
  const nlohmann::json dependencies = dependencies_of(folder);
  const auto add = [](std::vector<std::string>& list, const std::string& entry) {
    if (std::find(list.begin(), list.end(), entry) == list.end()) list.push_back(entry);
  };
  for (std::size_t i = 0; i < program.files.size(); ++i) {
    const std::string text = content_of(folder / program.files[i]);
    const fs::path beside = fs::path(program.files[i]).parent_path();
    for (std::sregex_iterator found(text.begin(), text.end(), import_pattern), end; found != end; ++found) {
      const std::string name = (*found)[1];
      const std::string below = (beside / name).lexically_normal().string();
      std::error_code none;
      // A file above the folder is not sent, because it would be written outside of the folder that is sent.
      if (name.starts_with('.') && !below.starts_with("..") && fs::is_regular_file(folder / below, none))
        add(program.files, below);
      if (dependencies.contains(name) && dependencies[name].is_string())
        add(program.packages, name + '@' + dependencies[name].get<std::string>());
    }
  }
  return program;
}

}  // namespace cyl
