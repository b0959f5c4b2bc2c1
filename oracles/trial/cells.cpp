// SPDX-License-Identifier: MIT
#include "oracles/trial/cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracles/referee/referee.hpp"
#include "oracles/trial/contact.hpp"

namespace cyl {
namespace {

constexpr std::array powers{1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,
                            1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16};
constexpr int decades = 16;  ///< of a sine or cosine, below 0.1
constexpr int oblique_bin = decades + 1, right_bin = 2 * decades + 2;
constexpr int infinite_bin = decades + 1;  ///< of the aspect, after all that is above 1e16

/// Decades at the sizes of scenes, and coarser steps at sizes that only scaled pairs have.
constexpr std::array scales{1e-200, 1e-100, 1e-50, 1e-20, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6,
                            1e-5,   1e-4,   1e-3,  1e-2,  1e-1,  1e0,   1e1,   1e2,  1e3,  1e4,  1e5,
                            1e6,    1e7,    1e8,   1e9,   1e10,  1e11,  1e12,  1e20, 1e50, 1e100};

std::string power_label(int exponent) {
  if (exponent == 0 || exponent == 1) return exponent == 0 ? "1" : "10";
  return fmt::format("1e{}", exponent);
}

/// Returns the index of the first end that x does not exceed, or the number of ends if it exceeds all.
template <std::size_t n>
int bin_of(double x, const std::array<double, n>& ends) {
  return static_cast<int>(std::lower_bound(ends.begin(), ends.end(), x) - ends.begin());
}

template <std::size_t n>
std::vector<std::string> upper_ends(const std::array<double, n>& ends) {
  std::vector<std::string> labels;
  for (const double end : ends) labels.push_back(power_label(static_cast<int>(std::lround(std::log10(end)))));
  labels.push_back("> " + labels.back());
  return labels;
}

int angle_bin(const Pair& pair) {
  const AxesAngle angle = axes_angle(pair);
  if (angle.parallel) return 0;
  if (angle.right) return right_bin;
  const int from_parallel = margin_decade(angle.sine), from_right = margin_decade(angle.cosine);
  return from_parallel > 0 ? oblique_bin - from_parallel : oblique_bin + from_right;
}

int aspect_bin(const Pair& pair) {
  double most = 1;
  const auto look = [&](double x, double y) { most = std::max({most, x / y, y / x}); };
  for (const Solid* c : {&pair.a, &pair.b}) {
    if (is_half_space(*c)) continue;
    const Extents of = extents_of(*c);
    if (of.across == 0 || of.along == 0) return infinite_bin;
    look(of.across, of.along);
  }
  if (has_half_space(pair)) return bin_of(most, powers);
  const Extents a = extents_of(pair.a), b = extents_of(pair.b);
  look(a.across / 2 + a.along, b.across / 2 + b.along);
  return bin_of(most, powers);
}

int margin_bin(const Pair& pair, Verdict truth, double size) {
  if (truth == Verdict::touching) return touching_bin;
  // Two points that are apart are infinitely many sizes apart.
  return margin_decade(size > 0 ? std::abs(approximate_distance(pair).value) / size
                                : std::numeric_limits<double>::infinity());
}

int offset_bin(const Pair& pair, double size) {
  constexpr std::array<double, powers.size() + 1> ends = [] {
    std::array<double, powers.size() + 1> e{1};
    std::copy(powers.begin(), powers.end(), e.begin() + 1);
    return e;
  }();
  const double off = std::max(pair.a.center.cwiseAbs().maxCoeff(), pair.b.center.cwiseAbs().maxCoeff());
  return off == 0 ? 0 : bin_of(off / size, ends);
}

constexpr int kinds = static_cast<int>(words_of(SolidKind{}).size());

/// The pairs of kinds i <= j are numbered row by row, and all others come last.
int shapes_bin(const Pair& pair) {
  if (!is_ordinary(pair)) return kinds * (kinds + 1) / 2;
  const auto [i, j] = std::minmax({static_cast<int>(kind_of(pair.a)), static_cast<int>(kind_of(pair.b))});
  return i * kinds - i * (i - 1) / 2 + (j - i);
}

}  // namespace

CellAxis margin_axis() {
  CellAxis axis{"margin: distance or depth over size", {}};
  for (int d = 0; d <= decades; ++d) axis.labels.push_back(power_label(-d));
  axis.labels.push_back("touching");
  return axis;
}

CellAxis x_axis(Plane plane) {
  if (plane == Plane::scale_offset) return {"size, in the unit of length", upper_ends(scales)};
  if (plane == Plane::margin_shapes) return margin_axis();
  if (plane == Plane::aspect_margin) {
    CellAxis axis{"largest ratio of diameter, height or sizes", upper_ends(powers)};
    axis.labels.push_back("flat, thin or a point");
    return axis;
  }
  CellAxis axis{"angle of the axes: its sine, then its cosine", {"parallel"}};
  for (int d = decades; d > 0; --d) axis.labels.push_back(power_label(-d));
  axis.labels.push_back("oblique");
  for (int d = 1; d <= decades; ++d) axis.labels.push_back(power_label(-d));
  axis.labels.push_back("perpendicular");
  return axis;
}

CellAxis y_axis(Plane plane) {
  if (plane == Plane::margin_shapes) {
    CellAxis axis{"shapes, at ordinary sizes", {}};
    for (std::size_t i = 0; i < words_of(SolidKind{}).size(); ++i)
      for (std::size_t j = i; j < words_of(SolidKind{}).size(); ++j)
        axis.labels.push_back(fmt::format("{}, {}", words_of(SolidKind{})[i], words_of(SolidKind{})[j]));
    axis.labels.push_back("other sizes");
    return axis;
  }
  if (plane != Plane::scale_offset) return margin_axis();
  CellAxis axis{"largest coordinate of a centre over size", upper_ends(powers)};
  axis.labels.insert(axis.labels.begin(), power_label(0));
  return axis;
}

std::array<Cell, planes.size()> cells_of(const Pair& pair, Verdict truth) {
  const double size = size_of(pair);
  const int margin = margin_bin(pair, truth, size);
  return {Cell{angle_bin(pair), margin}, Cell{aspect_bin(pair), margin},
          Cell{bin_of(size, scales), offset_bin(pair, size)}, Cell{margin, shapes_bin(pair)}};
}

}  // namespace cyl
