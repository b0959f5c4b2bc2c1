// SPDX-License-Identifier: MIT
#include "oracles/trial/finding_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

/// Without the sign of zero.
std::string number(double x) { return format_double(x == 0 ? 0 : x); }

std::string coordinate(const ExactVector& v, std::size_t i) {
  if (!v.exact[i].empty()) return v.exact[i];
  if (v.tail[i] == 0) return number(v.head[i]);
  return number(v.head[i]) + (v.tail[i] < 0 ? " - " : " + ") + number(std::abs(v.tail[i]));
}

std::string in_words(const ExactVector& v) {
  return fmt::format("({}, {}, {})", coordinate(v, 0), coordinate(v, 1), coordinate(v, 2));
}

}  // namespace

std::string in_words(const Certificate& certificate) {
  switch (certificate.kind) {
    case CertificateKind::direction:
      return fmt::format(
          "A plane with normal {} separates them: all of a lies on one side, all of b on the other.",
          in_words(certificate.vector));
    case CertificateKind::point:
      return fmt::format("The point {} lies in both.", in_words(certificate.vector));
    case CertificateKind::near:
      return fmt::format(
          "They touch to within 2^-200 of their size: the point {} is that near to both, and along {} "
          "neither "
          "a gap nor an overlap is wider.",
          in_words(certificate.vector), in_words(certificate.second));
    case CertificateKind::none:
      break;
  }
  return "No verdict could be proved.";
}

}  // namespace cyl
