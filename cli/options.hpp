// SPDX-License-Identifier: MIT
// The command line, as the commands describe it. Its parser, CLI11, is a large header that only options.cpp
// compiles. A variable that is bound to an option must live until Program::run() returns.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace cyl {

/// One option of a command. Each function demands something of it and returns the option itself; what is not
/// met is a usage error. Other options are named, and have to be there already.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}
  Option required() const;
  Option needs(const std::string& other) const;
  Option excludes(const std::string& other) const;
  Option one_each() const;  ///< one value each time it is given, not all words up to the next option
  Option separated_by(char separator) const;
  Option one_of(const std::vector<std::string>& words) const;
  Option within(double least, double most) const;
  Option not_empty(const std::string& error) const;
  Option existing_file() const;
  Option existing_folder() const;
  Option readable() const;  ///< a file that can be read, or "-"
  Option writable() const;  ///< a file that can be written: asked before the work, which may be long
  Option default_text(const std::string& text) const;  ///< shown by --help if the bound value has no default

 private:
  CLI::Option* option_;
};

/// One command. --help shows the defaults of strings and numbers: the values when they are bound.
class Command {
  template <class T>
  using Bound = std::reference_wrapper<T>;

 public:
  explicit Command(CLI::App& app, int& exit_code) : app_(&app), exit_code_(&exit_code) {}

  using Value = std::variant<Bound<std::string>, Bound<std::optional<std::string>>,
                             Bound<std::vector<std::string>>, Bound<std::vector<int>>, Bound<double>>;
  /// Puts the options that follow under this heading of --help.
  void section(const std::string& heading) { section_ = heading; }

  /// Adds an option "--name VALUE", whose value --help calls VALUE, or an argument "NAME".
  Option option(const std::string& declared, Value value, const std::string& help);
  Option flag(const std::string& name, bool& value, const std::string& help);

  using Integer =
      std::variant<Bound<std::uint64_t>, Bound<unsigned>, Bound<int>, Bound<std::optional<std::uint64_t>>>;
  /// Adds an option that holds a whole number from `least` to `most`: digits only, in base ten. (The parser's
  /// own conversion takes -1 for 2^64 - 1 and 010 for 8.)
  Option number(const std::string& declared, Integer value, const std::string& help, std::uint64_t least = 0,
                std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

  bool given(const std::string& name) const;  ///< whether the command line has this option

  /// Ends --help with these examples, the table of exit codes, and the remarks on both.
  void examples(const std::string& lines, const std::string& remarks = "");

  /// Sets the work of this command, which returns the exit code.
  void run(std::function<int()> work);

 private:
  CLI::App* app_;
  int* exit_code_;
  std::string section_ = "Options";
};

/// The program with all its commands.
class Program {
 public:
  Program(const std::string& name, const std::string& summary, const std::string& version);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Adds a command; --help lists the commands by group.
  Command command(const std::string& group, const std::string& name, const std::string& summary);
  /// Runs the command of the command line, and returns its exit code. Returns exit_usage, with the reason on
  /// standard error, if the command line cannot be parsed. Exceptions of the command pass through.
  int run(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
  int exit_code_ = 0;
};

}  // namespace cyl
