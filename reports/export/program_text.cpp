// SPDX-License-Identifier: MIT
#include "reports/export/program_text.hpp"

#include <algorithm>
#include <limits>

#include "corpus/pairs/pair_io.hpp"

namespace cyl {

std::string filled(std::string_view text, const Words& words) {
  std::string out;
  while (true) {
    const std::size_t begin = text.find('@');
    out += text.substr(0, begin);
    if (begin == std::string_view::npos) return out;
    text.remove_prefix(begin + 1);
    const std::size_t end = text.find('@');
    out += words.at(std::string(text.substr(0, end)));
    text.remove_prefix(end + 1);
  }
}

std::string literal(double x) {
  std::string text = format_double(x);
  const bool integer = text.find_first_of(".en") == std::string::npos;
  if (integer && (text.size() > 9 || text == "-0")) text += ".0";
  return text;
}

std::string bound(double x) {
  constexpr double largest = std::numeric_limits<double>::max();
  return literal(std::clamp(x, -largest, largest));
}

std::string listed(const double* numbers, int count) {
  std::string text = literal(numbers[0]);
  for (int i = 1; i < count; ++i) text += ", " + literal(numbers[i]);
  return text;
}

}  // namespace cyl
