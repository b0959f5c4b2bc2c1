// SPDX-License-Identifier: MIT
#include "reports/export/node_program.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>

#include "base/json.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// `import x from 'name'`, `import 'name'`, `import('name')` and `require('name')`.
const std::regex import_pattern(R"((?:from|import|require)\s*\(?\s*['"]([^'"]+)['"])");

}  // namespace

NodeProgram node_program(const fs::path& file) {
  NodeProgram program{{file.filename().string()}, {}};
  const std::string kind = file.extension();
  if (kind != ".mjs" && kind != ".cjs" && kind != ".js") return program;
  const fs::path folder = file.parent_path();
  const nlohmann::json package = nlohmann::json::parse(content_of(folder / "package.json"), nullptr, false);
  const auto add = [](std::vector<std::string>& list, const std::string& entry) {
    if (std::find(list.begin(), list.end(), entry) == list.end()) list.push_back(entry);
  };
  for (std::size_t i = 0; i < program.files.size(); ++i) {
    const std::string text = content_of(folder / program.files[i]);
    for (std::sregex_iterator found(text.begin(), text.end(), import_pattern), end; found != end; ++found) {
      const std::string name = (*found)[1];
      if (name.starts_with("./") && fs::is_regular_file(folder / name)) add(program.files, name.substr(2));
      const std::string version =
          package.is_object() && package.contains("dependencies") && package["dependencies"].is_object()
              ? package["dependencies"].value(name, "")
              : "";
      if (!version.empty()) add(program.packages, name + '@' + version);
    }
  }
  return program;
}

}  // namespace cyl
