// SPDX-License-Identifier: MIT
// Checks written files against reports/schemas/ by programs for the schema languages.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/process/line_program.hpp"
#include "base/scratch_test.hpp"

namespace cyl {

/// A file that is removed with the object.
class ScratchFile : Scratch {
 public:
  explicit ScratchFile(const std::string& content) : path(write("file", content)) {}
  const std::filesystem::path path;
};

/// Skips a test without a Debian package, or fails it if CI=true.
#define SKIP_WITHOUT(package)                                                         \
  do {                                                                                \
    if (const char* ci = std::getenv("CI"); ci && ci == std::string("true"))          \
      FAIL() << "with CI=true nothing may be skipped: apt-get install " << (package); \
    GTEST_SKIP() << "apt-get install " << (package);                                  \
  } while (false)

/// Whether a shell command succeeds, its own words kept off the terminal.
inline bool succeeds(const std::string& command) {
  return std::system(("(" + command + ") >/dev/null 2>&1").c_str()) == 0;
}

/// A Python with the module jsonschema (Debian: python3-jsonschema), or empty.
inline std::string schema_python() {  // the system's own has the Debian package, another one may come first
  for (const char* name : {"/usr/bin/python3", "python3"})
    if (succeeds(std::string(name) + " -c 'import jsonschema'")) return name;
  return {};
}

/// Whether a JSON document keeps to a schema (of draft 7, in reports/schemas/), which is one itself. One
/// Python answers all questions of a process.
inline bool keeps_to(const std::string& schema, const std::string& document) {
  static LineProgram checker(schema_python() + R"( -u -c '
import json, sys, jsonschema
for line in sys.stdin:
    try:
        files = line.rstrip().split("\t")
        s, d = (json.load(open(f, encoding="utf-8")) for f in files)
        jsonschema.Draft7Validator.check_schema(s)
        jsonschema.Draft7Validator(s, resolver=jsonschema.RefResolver("file://" + files[0], s)).validate(d)
        print("it does")
    except (ValueError, jsonschema.ValidationError) as error:
        print("it does not")')",
                             DAYLIGHT_SOURCE_DIR "/reports/schemas");
  const ScratchFile file(document);
  checker.send(schema + '\t' + file.path.string() + '\n');
  std::string said;
  const LineProgram::Cap cap{std::chrono::minutes(1), std::chrono::minutes(5)};
  EXPECT_EQ(checker.receive(said, cap), LineProgram::Read::line);
  return said == "it does";
}

}  // namespace cyl
