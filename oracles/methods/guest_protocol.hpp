// SPDX-License-Identifier: MIT
// The answers of a program that reads pairs, one a line. It may send a hello first, then it sends one line
// for each pair. The questions are lines of pair_io.
//
//   {"name":"mine","version":"1.2","claim":{"relative":1e-6,"absolute":0,"source":"manual, section 3"},
//    "takes":["sphere","box"],"sizes":{"least":0.01,"greatest":100,"aspect":1000,"zero":false,
//    "coordinate":1e6,"gap":10},"depth":"at_most","call":"mine::meet","install":"npm install mine@1.2",
//    "files":["shared.mjs"]}
//   {"verdict":"disjoint","distance":0.5,"direction":[1,0,0]}
//   {"verdict":"intersecting","distance":-0.1,"point":[0,0,1]}
//   {"verdict":"disjoint","distance_at_least":0.5}
//   {"declined":"no disks"}
//   {"error":"no convergence"}
//
// All keys but the verdict are optional. Other keys are skipped. A coordinate of a point may be a pair of
// numbers, which stands for their exact sum.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "corpus/pairs/method_answer.hpp"
#include "corpus/pairs/size_range.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "oracles/methods/guest.hpp"
#include "solver/solid.hpp"

namespace cyl {

struct GuestHello {
  std::string name, version;  ///< empty if the hello has none
  double relative = 0, absolute = 0;
  std::string claim_source;
  double rounded_rims = 0;     ///< the radius by which it rounds the edges of cylinders and boxes, inwards
  bool depth_at_most = false;  ///< its depths are upper bounds
  /// The kinds of solids that it is asked about, by SolidKind.
  std::array<bool, words_of(SolidKind{}).size()> supports{false, false, true, false};
  SizeRange sizes;  ///< of the solids that it is asked about
  Upstream upstream;
};

struct GuestAnswer {
  std::optional<Verdict> verdict;  ///< empty if it declined or failed; `reason` has the reason
  bool declined = false;
  std::string reason;
  std::optional<double> distance, at_least;  ///< at_least is a lower bound of the signed distance
  std::optional<std::array<double, 3>> direction;
  std::optional<std::array<double, 6>> point;  ///< the three heads, then the three tails
};

/// Has exactly one of the three. `error` is the reason why the line is neither a hello nor an answer.
struct GuestLine {
  std::optional<GuestHello> hello;
  std::optional<GuestAnswer> answer;
  std::string error;
};

/// Throws on no content of a line. The numbers of an answer are finite. The numbers of a claim are also not
/// negative.
GuestLine parse_guest_line(std::string_view text);

/// With `depth_at_most`, a depth is an upper bound.
/// Returns the answer; of a point and a direction, the one that goes with the verdict.
MethodAnswer method_answer(const GuestAnswer& said, bool depth_at_most);

}  // namespace cyl
