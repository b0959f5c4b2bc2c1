// SPDX-License-Identifier: MIT
// Methods that are no part of this build: a shared library with the one function of plugin.h, or a program in
// any language that answers lines with lines (oracles/methods/guest_protocol.hpp; questions as pair_io has
// them). Nothing of a guest runs in a process that has more to do than to ask it.
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

/// Names a guest well enough to ask it again.
struct Guest {
  GuestKind kind;
  std::string name;                  ///< empty: as it says itself, else after its file
  std::string what;                  ///< the file, absolute; or the command, for /bin/sh
  std::string folder;                ///< where the command runs; of a plug-in empty
  std::string method = {};           ///< which of the methods of a plug-in's library; empty: all
  std::optional<double> claim = {};  ///< relative, in the place of its own
};

/// "NAME=WHAT" or "WHAT", as a command line has it, seen from the working directory; a name begins with a
/// small letter. NAME:METHOD=WHAT is one method of a plug-in's library. Throws UsageError on a name no method
/// can have, and on control characters.
Guest read_guest(GuestKind kind, const std::string& text);

/// One in a command or a path would forge a line of format_guests().
bool has_control_character(std::string_view text);

/// Returns the option that names it, as a shell takes it: --plugin mine=./libmine.so.
std::string options_for(const Guest& guest);

/// One line each, and back; the latter throws std::runtime_error on anything else.
std::string format_guests(const std::vector<Guest>& guests);
std::vector<Guest> parse_guests(std::string_view text);

struct OpenedGuest {
  Guest guest;  ///< one of the library's methods, with the name that it is called by
  std::unique_ptr<Method> method;
};

/// Loads the library, or asks the program about one easy pair, in a process of its own. Throws
/// std::runtime_error, which tells the user what is wrong, where it does not load, does not answer, or has no
/// name that will do.
std::vector<OpenedGuest> open_guest(const Guest& guest);

/// Returns a hash of the bytes of these files, eight digits. A guest that was changed is another version,
/// whatever it says.
std::string fingerprint(std::span<const std::string> files);

std::vector<OpenedGuest> open_plugins(const Guest& guest);  ///< as open_guest, with any name
OpenedGuest open_command(const Guest& guest);               ///< likewise

}  // namespace cyl
