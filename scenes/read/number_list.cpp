// SPDX-License-Identifier: MIT
#include "scenes/read/number_list.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "base/number_text.hpp"

namespace cyl {

std::vector<double> parse_numbers(const std::string& text, const std::string& what) {
  std::vector<double> numbers;
  std::istringstream in(text);
  for (std::string field; in >> field;) {
    const auto x = number_in<double>(field.substr(field.starts_with('+')));
    if (!x || !std::isfinite(*x)) throw std::runtime_error(what + " is '" + text + "', no numbers");
    numbers.push_back(*x);
  }
  return numbers;
}

}  // namespace cyl
