// SPDX-License-Identifier: MIT
// Writes the answers of the solver and the seed methods to pairs from a file. bench/stability/builds.sh
// compares builds by them. Only Eigen is linked. Pairs are read and not drawn, because another build would
// draw others. The first argument is the file of pairs, sixteen doubles each. The second is the file for the
// answers, a MethodAnswer each, by pair and then method. With "flush" as the third, denormal numbers are
// read and left as 0. Files fit only the machine that wrote them.
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <vector>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include "bench/stability/build_pairs.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/decide_exactly.hpp"

namespace cyl {

/// Proofs are not tested here. Their arithmetic is left out, and `exact` is not asked.
Truth decide_exactly(const Cylinder&, const Cylinder&) { std::abort(); }

}  // namespace cyl

int main(int count, char** arguments) {
  using namespace cyl;
  if (count < 3) return 64;
  if (count > 3 && std::string_view(arguments[3]) == "flush") {
#if defined(__x86_64__)
    constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
    _mm_setcsr(_mm_getcsr() | flush_to_zero | denormals_are_zero);
#else
    return 64;
#endif
  }
  std::FILE* in = std::fopen(arguments[1], "rb");
  std::FILE* out = std::fopen(arguments[2], "wb");
  if (!in || !out) return 65;
  const auto methods = built_methods();
  double numbers[doubles_per_pair];
  for (std::size_t i = 0; std::fread(numbers, sizeof numbers, 1, in) == 1; ++i) {
    const Pair pair = pair_of(numbers, cylinder_number_count);
    for (const auto& method : methods) {
      const MethodAnswer answer = i % method->share() == 0 ? method->ask(pair) : MethodAnswer{};
      if (std::fwrite(&answer, sizeof answer, 1, out) != 1) return 65;
    }
  }
  return std::fclose(out) == 0 ? 0 : 65;
}
