// SPDX-License-Identifier: MIT
// Methods that are not part of this build. A guest is a shared library with the one function of plugin.h, or
// a program that answers each line with a line. The format of the questions is that of pair_io. The format of
// the answers is in guest_protocol.hpp. The code of a guest runs only in processes that do nothing else.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/methods/method.hpp"

namespace cyl {

enum class GuestKind : unsigned char { plugin, command };

/// How the maintainers of a program's library can run the program.
struct Upstream {
  std::string call;     ///< what it calls: "mj_geomDistance"
  std::string install;  ///< the command that installs the library into its folder; empty if unknown
  std::vector<std::string> files;  ///< of the program
};

/// Names a guest well enough to ask it again.
struct Guest {
  GuestKind kind;
  std::string name;                  ///< if empty, the guest's own name, else that of its file
  std::string what;                  ///< the absolute path of the file, or the command, for /bin/sh
  std::string folder;                ///< the working directory of the command; empty for a plug-in
  std::string method = {};           ///< one method of a plug-in's library; all if empty
  std::optional<double> claim = {};  ///< relative; replaces the guest's own claim
  Upstream upstream = {};            ///< known of an opened program whose hello states it
};

/// Reads "NAME=WHAT" or "WHAT" of a command line, relative to the working directory. A name begins with a
/// small letter. NAME:METHOD=WHAT is one method of a plug-in's library. Throws UsageError on a name that no
/// method can have, and on control characters.
Guest read_guest(GuestKind kind, const std::string& text);

/// A control character in a command or a path could forge a line of format_guests().
bool has_control_character(std::string_view text);

/// Returns the option that names the guest, quoted for a shell: --plugin mine=./libmine.so.
std::string options_for(const Guest& guest);

/// Writes one line for each guest, and reads it again. parse_guests() throws std::runtime_error on other
/// text.
std::string format_guests(const std::vector<Guest>& guests);
std::vector<Guest> parse_guests(std::string_view text);

struct OpenedGuest {
  Guest guest;  ///< one of the library's methods, with the name that it is called by
  std::unique_ptr<Method> method;
};

/// Loads the library, or asks the program about one easy pair, in a process of its own. Throws
/// std::runtime_error, with a message for the user, if it does not load, does not answer, or has no valid
/// name.
std::vector<OpenedGuest> open_guest(const Guest& guest);

/// Returns a hash of the bytes of these files, eight digits. A changed guest is another version, even if its
/// own version is the same.
std::string fingerprint(std::span<const std::string> files);

std::vector<OpenedGuest> open_plugins(const Guest& guest);  ///< as open_guest, with any name
OpenedGuest open_command(const Guest& guest);               ///< as open_guest

}  // namespace cyl
