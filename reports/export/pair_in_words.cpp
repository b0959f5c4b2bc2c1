// SPDX-License-Identifier: MIT
#include "reports/export/pair_in_words.hpp"

#include <fmt/format.h>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/solid_kind.hpp"

namespace cyl {

std::string triple(const Vector3& v) {
  return fmt::format("({}, {}, {})", format_double(v[0]), format_double(v[1]), format_double(v[2]));
}

namespace {

std::string row(const char* name, const Solid& c, bool rounded) {
  const bool plane = is_half_space(c);
  return fmt::format("| {} | {} | {} | {} | {} |{}\n", name, triple(c.center), triple(c.axis),
                     plane ? "half-space" : format_double(c.radius), plane ? "" : format_double(c.height),
                     rounded ? fmt::format(" {} |", format_double(c.rounding)) : "");
}

/// Returns a row of the table of a pair with a box.
std::string wide_row(const char* name, const Solid& c) {
  std::string directed, lengths;
  if (is_box(c)) {
    const auto& q = c.quaternion;
    directed = fmt::format("quaternion ({}, {}, {}, {})", format_double(q[0]), format_double(q[1]),
                           format_double(q[2]), format_double(q[3]));
    lengths = "edges " + triple({c.edges[0], c.edges[1], c.edges[2]});
  } else {
    directed = (is_half_space(c) ? "normal " : "axis ") + triple(c.axis);
    if (!is_half_space(c))
      lengths = fmt::format("radius {}, height {}", format_double(c.radius), format_double(c.height));
  }
  if (c.rounding != 0) lengths += ", rounding " + format_double(c.rounding);
  return fmt::format("| {} | {} | {} | {} |\n", name, triple(c.center), directed, lengths);
}

std::string table_of(const Pair& pair) {
  if (has_box(pair))
    return "| | centre | direction | lengths |\n|---|---|---|---|\n" + wide_row("a", pair.a) +
           wide_row("b", pair.b);
  const bool rounded = is_rounded(pair);
  return std::string("| | centre | axis | radius | height |") +
         (rounded ? " rounding |\n|---|---|---|---|---|---|\n" : "\n|---|---|---|---|---|\n") +
         row("a", pair.a, rounded) + row("b", pair.b, rounded);
}

}  // namespace

std::string solids_in_words(const Pair& pair) {
  const auto word = [](const Solid& c) {
    if (is_half_space(c)) return std::string("half-space");
    if (is_box(c)) return std::string(c.rounding > 0 ? "rounded box" : "box");
    return std::string(to_string(kind_of(c))) + (kind_of(c) == SolidKind::rounded ? " cylinder" : "");
  };
  const std::string a = word(pair.a), b = word(pair.b);
  return a == b ? "two " + a + (is_box(pair.a) ? "es" : "s") : "a " + a + " and a " + b;
}

std::string question_of(const Pair& pair) {
  std::string text =
      fmt::format("Do these solids, {}, meet? Heights are full heights. ", solids_in_words(pair));
  if (is_rounded(pair))
    text += fmt::format("A solid is all points within its rounding of the {}. ",
                        has_box(pair) ? "solid without it" : "cylinder");
  if (has_half_space(pair))
    text += "The centre of a half-space is a point of its plane, and its axis the outward normal. ";
  if (has_box(pair))
    text +=
        "The edges of a box are full lengths, along the columns of the rotation of quaternion/|quaternion|, "
        "which is written w, x, y, z. ";
  return text + "All numbers are exact doubles.\n\n" + table_of(pair);
}

}  // namespace cyl
