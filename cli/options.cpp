// SPDX-License-Identifier: MIT
#include "cli/options.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <concepts>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <type_traits>
#include <utility>

#include "base/number_text.hpp"
#include "base/spelling.hpp"
#include "cli/commands.hpp"

namespace cyl {
namespace {

/// The meaning of exit codes, the same for every command.
constexpr const char* exit_codes =
    "Exit codes:\n"
    "  0   nothing is wrong\n"
    "  1   daylight itself failed, for example because it could not write a file\n"
    "  2   a method gave a provably wrong answer beyond its claim, crashed or hung\n"
    "  3   nothing is wrong, but some pairs are undecided or were not tested\n"
    "  64  wrong usage, such as an unknown option or a missing file\n"
    "  65  bad input, such as a line that is not a pair\n"
    "A claim is the tolerance that a method states. docs/exit-codes.md has the codes of each command.";

/// Prints the name and value of each option for --help, then its description, and then its default.
class HelpFormat final : public CLI::Formatter {
 public:
  HelpFormat() { column_width(27); }
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override {
    const std::string text = Formatter::make_group(group, is_positional, std::move(options));
    return is_positional || group == "Options" ? text : text.substr(1);  // one empty line is enough
  }
  std::string make_option_opts(const CLI::Option* o) const override {
    return o->get_items_expected_max() == 0 || o->get_positional() ? "" : ' ' + o->get_type_name();
  }
  std::string make_option_desc(const CLI::Option* o) const override {
    const std::string standard = o->get_default_str();
    return o->get_description() + (standard.empty() ? "" : " (default: " + standard + ')');
  }
};

/// Returns the check without the words that the parser would put after the name of the value.
CLI::Validator unnamed(CLI::Validator check) { return check.description(""); }

struct NameAndValue {
  std::string name, value;
};
/// Splits "--name VALUE" into its two parts.
NameAndValue split(const std::string& declared) {
  const std::size_t space = declared.find(' ');
  if (space == declared.npos) return {declared, ""};
  return {declared.substr(0, space), declared.substr(space + 1)};
}

/// Reads a whole number. Throws the parser's error if `text` is not one from `least` to `most`.
std::uint64_t whole_number(const std::string& text, const std::string& name, std::uint64_t least,
                           std::uint64_t most) {
  if (const auto n = number_in<std::uint64_t>(text); n && *n >= least && *n <= most) return *n;
  throw CLI::ValidationError(name, "'" + text + "' is not a whole number from " + std::to_string(least) +
                                       " to " + std::to_string(most));
}

/// Returns ". Do you mean 'check'?". If no name is similar, returns the list of names.
std::string suggestion(const std::string& typed, const std::vector<std::string>& names) {
  std::size_t least = std::max<std::size_t>(1, typed.size() / 3);
  std::string best;
  for (const std::string& name : names) {
    const std::size_t errors = typing_errors(typed, name);
    if (errors < least || (errors == least && best.empty())) {
      least = errors;
      best = name;
    }
  }
  if (!best.empty()) return ". Do you mean '" + best + "'?";
  for (const std::string& name : names) best += (best.empty() ? "; there are " : ", ") + name;
  return best;
}

/// Describes the first word that the parser could not place.
std::string misplaced(const CLI::App& command) {
  const std::string first = command.remaining().front();
  if (!first.starts_with("-")) return command.get_name() + " does not take '" + first + "'";
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return command.get_name() + " has no option " + first + suggestion(first, names);
}

}  // namespace

Option Option::required() const { return Option(*option_->required()); }
Option Option::needs(const std::string& other) const { return Option(*option_->needs(other)); }
Option Option::excludes(const std::string& other) const { return Option(*option_->excludes(other)); }
Option Option::one_each() const { return Option(*option_->allow_extra_args(false)); }
Option Option::separated_by(char separator) const { return Option(*option_->delimiter(separator)); }
Option Option::one_of(const std::vector<std::string>& words) const {
  return Option(*option_->check(CLI::IsMember(words)));
}
Option Option::within(double least, double most) const {
  return Option(*option_->check(unnamed(CLI::Range(least, most))));
}
Option Option::not_empty(const std::string& error) const {
  return Option(*option_->check([error](const std::string& text) { return text.empty() ? error : ""; }));
}
Option Option::existing_file() const { return Option(*option_->check(unnamed(CLI::ExistingFile))); }
Option Option::readable() const {
  return Option(*option_->check([](const std::string& file) {
    const bool is_file = std::filesystem::exists(file) && !std::filesystem::is_directory(file);
    if (file == "-" || (is_file && access(file.c_str(), R_OK) == 0)) return std::string();
    return "'" + file + "' is not a readable file";
  }));
}
Option Option::writable() const {
  return Option(*option_->check([](const std::string& file) {
    const bool was_there = std::filesystem::exists(std::filesystem::symlink_status(file));
    if (!std::ofstream(file, std::ios::app)) throw std::runtime_error(file + " cannot be written");
    if (!was_there) std::filesystem::remove(file);
    return std::string();
  }));
}
Option Option::existing_folder() const { return Option(*option_->check(unnamed(CLI::ExistingDirectory))); }
Option Option::default_text(const std::string& text) const { return Option(*option_->default_str(text)); }

Option Command::option(const std::string& declared, Value value, const std::string& help) {
  const NameAndValue parts = split(declared);
  const auto add = [&]<class T>(std::reference_wrapper<T> bound) {
    CLI::Option* option =
        app_->add_option(parts.name, bound.get(), help)->type_name(parts.value)->group(section_);
    if constexpr (std::is_same_v<T, std::string> || std::is_same_v<T, double>) option->capture_default_str();
    return Option(*option);
  };
  return std::visit(add, value);
}
Option Command::flag(const std::string& name, bool& value, const std::string& help) {
  return Option(*app_->add_flag(name, value, help)->group(section_));
}

Option Command::number(const std::string& declared, Integer value, const std::string& help,
                       std::uint64_t least, std::uint64_t most) {
  const NameAndValue parts = split(declared);
  const auto add = [&]<class T>(std::reference_wrapper<T> bound) {
    std::uint64_t greatest = most;
    if constexpr (std::integral<T>) greatest = std::min<std::uint64_t>(most, std::numeric_limits<T>::max());
    const auto set = [&target = bound.get(), name = parts.name, least, greatest](const std::string& text) {
      target = static_cast<T>(whole_number(text, name, least, greatest));
    };
    CLI::Option* option = app_->add_option_function<std::string>(parts.name, set, help)
                              ->type_name(parts.value)
                              ->group(section_);
    if constexpr (std::integral<T>) option->default_str(std::to_string(bound.get()));
    return Option(*option);
  };
  return std::visit(add, value);
}

bool Command::given(const std::string& name) const { return app_->count(name) > 0; }

void Command::examples(const std::string& lines, const std::string& remarks) {
  app_->footer("Examples:\n" + lines + "\n\n" + exit_codes + (remarks.empty() ? "" : "\n\n") + remarks);
}

void Command::run(std::function<int()> work) {
  app_->callback([work = std::move(work), exit_code = exit_code_] { *exit_code = work(); });
}

Program::Program(const std::string& name, const std::string& summary, const std::string& version)
    : app_(std::make_unique<CLI::App>(summary, name)) {
  app_->formatter(std::make_shared<HelpFormat>());
  app_->require_subcommand(1);
  app_->set_version_flag("--version", version);
  app_->footer(name + " COMMAND --help shows the options of a command and examples.\n\n" + exit_codes);
}

Program::~Program() = default;

Command Program::command(const std::string& group, const std::string& name, const std::string& summary) {
  return Command(*app_->add_subcommand(name, summary)->group(group), exit_code_);
}

int Program::run(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    // The parser would take the next word as the value.
    const std::string_view word = argv[i];
    if (!word.starts_with("--") || word.find('=') != word.size() - 1) continue;
    std::cerr << app_->get_name() << ": " << word << " gives no value\n--help shows more\n";
    return exit_usage;
  }
  try {
    app_->parse(argc, argv);
    return exit_code_;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app_->exit(error);  // --help, --version
    std::cerr << app_->get_name() << ": ";
    if (argc < 2) {
      std::cerr << "no command given\n\n" << app_->help();
    } else if (app_->get_subcommands().empty()) {
      std::vector<std::string> names;
      for (const CLI::App* command : app_->get_subcommands({})) names.push_back(command->get_name());
      std::cerr << "no command '" << argv[1] << "'" << suggestion(argv[1], names) << "\n--help shows more\n";
    } else {
      const CLI::App& command = *app_->get_subcommands().front();
      const bool extra = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) &&
                         !command.remaining().empty();
      std::cerr << (extra ? misplaced(command) : error.what()) << "\n--help shows more\n";
    }
    return exit_usage;
  }
}

}  // namespace cyl
