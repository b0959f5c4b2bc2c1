// SPDX-License-Identifier: MIT
// Writes a program for the maintainers of a library. It needs only the library, and asks it about one pair by
// the same calls with the same settings as the method of that name.
#pragma once

#include <string>
#include <string_view>

#include "oracles/methods/guest.hpp"
#include "oracles/trial/compare.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {

/// Returns the file of that name in templates/, which is part of this program. Throws std::out_of_range if
/// there is none.
std::string_view template_text(std::string_view name);

/// Returns a literal of C++ that is this double: no integer that a type could be too small for, and -0 stays
/// it.
std::string literal(double x);

/// A library, and the call by which a method asks it.
struct LibraryCall {
  std::string method;
  std::string library;   ///< "FCL"
  std::string call;      ///< "fcl::collide"
  std::string settings;  ///< "solver GST_LIBCCD, gjk_tolerance 1e-6"
  std::string flags;     ///< for the compiler, after the source
  std::string packages;  ///< Debian's, beside g++ and pkg-config
};

inline constexpr std::string_view compiler_options = "-std=c++17 -O2 -DNDEBUG -ffp-contract=off";

/// Returns nullptr if no program can be written for this method, because its library is not FCL, Bullet,
/// libccd, ODE or MuJoCo.
const LibraryCall* find_library_call(std::string_view method);

/// Returns whether a program can show a finding of this kind.
bool program_shows(FindingKind kind);

/// Returns whether a program of the library ("ODE") can have both solids.
bool program_takes(std::string_view library, const Pair& pair);

/// Returns the pair as the libraries get it: axes of unit length, rounded.
Pair as_given(const Pair& pair);

/// Returns one C++17 file from a template in templates/. Solids are written as the adapters build them:
/// numbers in shortest decimals, the rotation as nine numbers. It prints the library's answer and the truth.
/// It exits with 1 if the answer is wrong as in the finding, and with 0 if it is right. `asked` must have a
/// finding of a kind that program_shows(), of a method with a LibraryCall.
std::string reproducing_program(const LibraryCall& call, const Trial& asked, const Method& method);

/// Returns a script that installs the library of a guest and asks the guest about case.jsonl. It exits with 1
/// if the verdict, or the distance, is wrong as in the finding. The text is empty if the guest does not state
/// how to install its library, or if the finding is of another kind.
std::string reproducing_script(const Upstream& upstream, const std::string& command, const Trial& asked,
                               const Claim& claim);

}  // namespace cyl
