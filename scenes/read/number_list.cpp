// SPDX-License-Identifier: MIT
#include "scenes/read/number_list.hpp"

#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace cyl {

std::vector<double> parse_numbers(const std::string& text, const std::string& what) {
  std::vector<double> numbers;
  std::istringstream in(text);
  for (std::string field; in >> field;) {
    const char* const end = field.data() + field.size();
    const char* const begin = field.data() + (field.starts_with('+') ? 1 : 0);
    double x = 0;
    const auto [rest, error] = std::from_chars(begin, end, x);
    if (error != std::errc() || rest != end || !std::isfinite(x))
      throw std::runtime_error(what + " is '" + text + "', no numbers");
    numbers.push_back(x);
  }
  return numbers;
}

}  // namespace cyl
