// SPDX-License-Identifier: MIT
#include "oracles/trial/finding_text.hpp"

#include <fmt/format.h>
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/witness_miss.hpp"

namespace cyl {
namespace {

/// Writes a number without the sign of zero.
std::string number(double x) { return format_double(x == 0 ? 0 : x); }

/// Characters of a fraction that is shown in full.
constexpr std::size_t shown_cap = 60;

bool is_shortened(const ExactVector& v) {
  return std::ranges::any_of(v.exact, [](const std::string& exact) { return exact.size() > shown_cap; });
}

std::string coordinate(const ExactVector& v, std::size_t i) {
  if (const std::string& exact = v.exact[i]; exact.size() > shown_cap)
    return fmt::format("about {}", number(mpq_class(exact).get_d()));
  else if (!exact.empty())
    return exact;
  // If two doubles have a sum that is exactly one double, that double is shown. The error of the sum decides.
  const double sum = v.head[i] + v.tail[i], of_tail = sum - v.head[i];
  const double error = (v.head[i] - (sum - of_tail)) + (v.tail[i] - of_tail);
  if (v.tail[i] == 0 || error == 0) return number(sum);
  return number(v.head[i]) + (v.tail[i] < 0 ? " - " : " + ") + number(std::abs(v.tail[i]));
}

std::string in_words(const ExactVector& v) {
  return fmt::format("({}, {}, {})", coordinate(v, 0), coordinate(v, 1), coordinate(v, 2));
}

std::string statement_of(const Certificate& certificate) {
  switch (certificate.kind) {
    case CertificateKind::direction:
      return fmt::format(
          "A plane with normal {} separates them: all of a lies on one side, all of b on the other.",
          in_words(certificate.vector));
    case CertificateKind::point:
      return fmt::format("The point {} lies in both.", in_words(certificate.vector));
    case CertificateKind::points:
      return fmt::format(
          "The point {} lies in a without its rounding, the point {} in b without its own. Their distance is "
          "at most the sum of the roundings.",
          in_words(certificate.vector), in_words(certificate.second));
    case CertificateKind::near:
      return fmt::format(
          "They touch, up to 2^-200 times the size. The point {} is at most that far from either solid. "
          "Along {}, any gap or overlap is at most as wide.",
          in_words(certificate.vector), in_words(certificate.second));
    case CertificateKind::near_points:
      return fmt::format(
          "They touch, up to 2^-200 times the size. The points {} and {} are at most that far from a and b "
          "without their roundings. Their distance is at most that much above the sum of the roundings. "
          "Along {}, any gap or overlap is at most as wide.",
          in_words(certificate.vector), in_words(certificate.third), in_words(certificate.second));
    case CertificateKind::none:
      break;
  }
  return "No verdict could be proved.";
}

/// Relative to the size.
constexpr double shown_margin = 1000;

}  // namespace

std::string margin_in_words(const Enclosure& margin) {
  if (margin.lo > shown_margin) return fmt::format("margin of more than {} sizes", shown_margin);
  if (margin.lo == margin.hi) return fmt::format("margin {:.3g}", margin.lo);
  return fmt::format("margin {:.3g} to {:.3g}", margin.lo, margin.hi);
}

std::string describe_finding(const Finding& finding) {
  const std::string margin = finding.margin ? fmt::format(", {}", margin_in_words(*finding.margin)) : "";
  return fmt::format("{} ({}{})", to_string(finding.kind), in_words(finding.severity), margin);
}

std::string miss_in_words(const Pair& pair, const MethodAnswer& answer) {
  const std::optional<double> miss = witness_miss(pair, answer);
  const double size = size_of(pair);
  if (!miss || size == 0) return {};
  if (answer.witness != CertificateKind::direction)
    return *miss > 0 ? fmt::format("the point lies {:.3g} of the size outside", *miss / size) : "";
  if (*miss == 0) return "the direction gives f(D) = 0 exactly, which separates nothing";
  if (*miss < 0) return {};
  return fmt::format("the direction gives f(D) = {:.3g} of the size, not below 0", *miss / size);
}

std::string in_words(const Certificate& certificate) {
  const bool shortened =
      is_shortened(certificate.vector) || is_shortened(certificate.second) || is_shortened(certificate.third);
  return statement_of(certificate) + (shortened ? " The certificate has its exact fractions." : "");
}

}  // namespace cyl
