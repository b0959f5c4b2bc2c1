// SPDX-License-Identifier: MIT
// oracles/guests/versions.py does the work. It lies beside the guests that it installs and beside
// compare.py, and judges engines with compare.py.
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "base/process/process.hpp"
#include "base/source_tree.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"

namespace cyl {
namespace {

struct VersionsOptions {
  std::string package, first, last = "latest", data, page;
  std::vector<std::string> plugins, commands;
  std::uint64_t pairs = 15'000;
};

[[noreturn]] void become_versions(const VersionsOptions& options) {
  const std::size_t local = options.plugins.size() + options.commands.size();
  if (options.package.empty() ? local < 2 : local > 0)
    throw UsageError(
        "give --npm PACKAGE, or two or more of --plugin and --command in the order of their versions");
  const std::string script = in_source_tree("oracles/guests/versions.py");
  if (script.empty())
    throw std::runtime_error("oracles/guests/versions.py is not here: install daylight again");
  std::vector<std::string> words{"python3", script};
  const auto add = [&](const std::string& option, const std::string& value) {
    if (!value.empty()) words.push_back(option + '=' + value);
  };
  add("--daylight", std::filesystem::read_symlink("/proc/self/exe"));
  add("--npm", options.package);
  add("--from", options.first);
  add("--to", options.last);
  for (const std::string& plugin : options.plugins) add("--plugin", plugin);
  for (const std::string& command : options.commands) add("--command", command);
  add("--pairs", std::to_string(options.pairs));
  add("--data", options.data);
  add("--page", options.page);
  try {
    become_program(words);
  } catch (const std::system_error& error) {
    throw std::runtime_error(error.what() + std::string("; install it: apt-get install python3"));
  }
}

}  // namespace

void add_versions(Program& program) {
  Command command = program.command(
      "Find", "versions",
      "Asks the versions of a library about the same pairs, and reports when faults came and went");
  auto options = std::make_shared<VersionsOptions>();
  command.section("Versions");
  command.option("--npm PACKAGE", options->package,
                 "npm package with a guest in oracles/guests; npm installs each version");
  command.option("--from VERSION", options->first, "first version, such as 0.11")
      .needs("--npm")
      .default_text("the first");
  command.option("--to VERSION", options->last, "last version: 0.19 includes 0.19.3").needs("--npm");
  command.option("--plugin FILE", options->plugins, "shared library of one version (oracles/plugin.h)")
      .one_each();
  command
      .option("--command COMMAND", options->commands, "program of one version; plug-ins come before programs")
      .one_each();
  command.section("Pairs");
  command.number("--pairs N", options->pairs, "number of drawn pairs, which follow the public cases", 2);
  command.section("Output");
  command
      .option("--data FILE", options->data, "kept results, one version a line; only new versions are asked")
      .writable()
      .default_text("in the user's cache folder");
  command.option("--page FILE", options->page, "also write all kept results as a page in Markdown")
      .writable();
  command.examples(
      "  daylight versions --npm @dimforge/rapier3d-compat --from 0.11 --to latest\n"
      "  daylight versions --plugin ./libmine-1.0.so --plugin ./libmine-1.1.so",
      "Exit code 2 of versions means that a version is wrong beyond its claim, and 3 that a version\n"
      "could not be asked.");
  command.run([options]() -> int { become_versions(*options); });
}

}  // namespace cyl
