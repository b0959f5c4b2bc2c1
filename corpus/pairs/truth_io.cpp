// SPDX-License-Identifier: MIT
#include "corpus/pairs/truth_io.hpp"

#include <cmath>
#include <cstddef>

#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

void append(std::string& s, const ExactVector& v) {
  for (std::size_t i = 0; i < 3; ++i) {
    s += i == 0 ? '[' : ',';
    if (!v.exact[i].empty()) {
      s.append("\"").append(v.exact[i]).append("\"");
    } else if (v.tail[i] != 0) {
      s.append("[").append(format_number(v.head[i])).append(",").append(format_number(v.tail[i])).append("]");
    } else {
      s += format_number(v.head[i]);
    }
  }
  s += ']';
}

/// Appends the members of the certificate's object without braces, each after a comma. Appends nothing if it
/// has none.
void append(std::string& s, const Certificate& c) {
  if (c.kind == CertificateKind::none) return;
  const bool is_near = c.kind == CertificateKind::near || c.kind == CertificateKind::near_points;
  s.append(",\"").append(is_near ? "near" : to_string(c.kind)).append("\":");
  const bool near_points = c.kind == CertificateKind::near_points;
  const bool two = c.kind == CertificateKind::points || near_points;
  if (is_near) s += near_points ? "{\"points\":" : "{\"point\":";
  if (two) s += '[';
  append(s, c.vector);
  if (two) {
    s += ',';
    append(s, near_points ? c.third : c.second);
    s += ']';
  }
  if (c.hulls != Certificate{}.hulls)
    s.append(",\"hulls\":[\"")
        .append(to_string(c.hulls[0]))
        .append("\",\"")
        .append(to_string(c.hulls[1]))
        .append("\"]");
  if (!is_near) return;
  s += ",\"direction\":";
  append(s, c.second);
  s += '}';
}

std::string verdict_member(Verdict verdict) {
  return std::string("{\"verdict\":\"") + to_string(verdict) + '"';
}

/// Returns a length as JSON: a number, or a string of decimals if it is not finite.
std::string end_text(double x) { return std::isfinite(x) ? format_double(x) : '"' + format_end(x) + '"'; }

}  // namespace

// The distance of centres is at most 2 sqrt(3) times the largest double, 6.23e308. A depth is at most r0 +
// h0 / 2 + r1 + h1 / 2, which is three times the largest double.
std::string format_end(double x) {
  if (std::isfinite(x)) return format_double(x);
  return x < 0 ? "-6.3e308" : "6.3e308";
}

std::string format_certificate(const Certificate& c) {
  std::string s;
  append(s, c);
  return '{' + (s.empty() ? s : s.substr(1)) + '}';
}

std::string format_truth(const Truth& truth, const Enclosure* distance) {
  std::string s = verdict_member(truth.verdict);
  append(s, truth.certificate);
  if (distance)
    s.append(",\"distance\":[")
        .append(end_text(distance->lo))
        .append(",")
        .append(end_text(distance->hi))
        .append("]");
  if (truth.verdict == Verdict::undecided) s.append(",\"bits\":").append(std::to_string(truth.bits));
  if (truth.verdict != Verdict::invalid)
    s.append(",\"stage\":\"").append(to_string(truth.stage)).append("\"");
  return s += '}';
}

std::string format_method_answer(const MethodAnswer& answer) {
  if (answer.status == Status::declined) return "{\"declined\":" + quote_json(answer.reason) + '}';
  if (answer.status == Status::failed) {
    const Failure failure = answer.failure == Failure::none ? Failure::crash : answer.failure;
    return std::string("{\"failed\":\"") + to_string(failure) + "\",\"reason\":" + quote_json(answer.reason) +
           '}';
  }
  std::string s = verdict_member(answer.verdict);
  if (answer.has_distance) s.append(",\"distance\":").append(format_number(answer.distance));
  if (answer.at_least) s.append(",\"distance_at_least\":").append(format_number(answer.distance));
  append(s, answer.certificate());
  return s += '}';
}

nlohmann::ordered_json truth_to_json(const Truth& truth, const Enclosure* distance) {
  return parse_ordered_json(format_truth(truth, distance));
}

nlohmann::ordered_json answer_to_json(const MethodAnswer& answer) {
  return parse_ordered_json(format_method_answer(answer));
}

}  // namespace cyl
