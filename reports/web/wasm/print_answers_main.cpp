// SPDX-License-Identifier: MIT
// Writes pairs and the native solver's answers in binary: every case, then pairs of each family in turn. A
// row has question_size + answers_size doubles. compare_test.mjs compares the module with them.
//     print_answers CASES PAIRS SEED
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/store/case_files.hpp"
#include "reports/web/wasm/answers.hpp"

namespace cyl {
namespace {

void print_row(const Pair& pair) {
  static_assert(question_size == 2 * cylinder_number_count);
  const auto question = numbers_of(pair);
  std::array<double, answers_size> answers;
  answer_all(question.data(), answers.data());
  std::fwrite(question.data(), sizeof question, 1, stdout);
  std::fwrite(answers.data(), sizeof answers, 1, stdout);
}

/// Prints one pair for each reason for which a solid is invalid.
void print_invalid() {
  const Pair good;
  for (std::size_t i = 0; i < cylinder_number_count; ++i)
    for (const double bad : {-1.0, 0.0, std::numeric_limits<double>::infinity()}) {
      Pair pair = good;
      *numbers_of(pair.a)[i] = bad;
      print_row(pair);
    }
}

}  // namespace
}  // namespace cyl

int main(int count, char** words) {
  using namespace cyl;
  if (count != 4) return 64;
  const std::uint64_t pairs = std::strtoull(words[2], nullptr, 10),
                      seed = std::strtoull(words[3], nullptr, 10);
  for (const Case& known : read_case_folder(words[1])) print_row(known.pair);
  print_invalid();
  std::vector<Family> all;
  for (const auto& some : {families(), rounded_families(), margin_families()})
    all.insert(all.end(), some.begin(), some.end());
  for (std::uint64_t i = 0; i < pairs; ++i) print_row(all[i % all.size()].generate(seed, i / all.size()));
  return std::fflush(stdout) == 0 ? 0 : 1;
}
