// SPDX-License-Identifier: MIT
// A program for a library's maintainers: it needs nothing but the library and asks it about one pair, by the
// same calls with the same settings as the method of that name does.
#pragma once

#include <string>
#include <string_view>

#include "oracles/trial/compare.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {

/// What a library is, and how a method asks it.
struct LibraryCall {
  std::string method;
  std::string library;   ///< "FCL"
  std::string call;      ///< "fcl::collide"
  std::string settings;  ///< "solver GST_LIBCCD, gjk_tolerance 1e-6"
  std::string flags;     ///< for the compiler, after the source
  std::string packages;  ///< Debian's, beside g++ and pkg-config
};

inline constexpr std::string_view compiler_options = "-std=c++17 -O2 -DNDEBUG -ffp-contract=off";

/// Returns nullptr where no program can be written for this method: it is none of FCL, Bullet, libccd, ODE,
/// MuJoCo.
const LibraryCall* find_library_call(std::string_view method);

/// Returns whether a program can show a finding of this kind.
bool program_shows(FindingKind kind);

/// Returns what a program prints where the answer is not right: within the claim that is no fault.
std::string_view judgement(const Finding& finding);

/// Returns the pair as the libraries get it: axes of unit length, rounded.
Pair as_given(const Pair& pair);

/// Returns one C++17 file, of a template in templates/. Solids are written as the adapters build them:
/// numbers in shortest decimals, the rotation as nine of them. It prints what the library says and what is
/// true, and exits with 1 where the answer is wrong in the way of the finding, 0 where it is right. `asked`
/// must hold a finding, of a kind that program_shows(), of a method with a LibraryCall.
std::string reproducing_program(const LibraryCall& call, const Trial& asked, const Method& method);

}  // namespace cyl
