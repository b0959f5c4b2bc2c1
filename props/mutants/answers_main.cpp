// SPDX-License-Identifier: MIT
// Prints every answer of our own methods on the first pairs of every family, and every verdict of the batch
// kernels. Two builds can thus be compared bit for bit.
#include <cstdint>
#include <cstdio>
#include <vector>

#include "base/enum_words.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/trial/compare.hpp"
#include "solver/intersect_batch.hpp"

int main() {
  using namespace cyl;
  constexpr std::uint32_t pairs_per_family = 100;
  auto methods = own_methods();
  for (auto make : {literature_2008_methods, literature_2017_methods})
    for (auto& method : make()) methods.push_back(std::move(method));
  for (const auto& from : {families(), margin_families()}) {
    for (const Family& family : from) {
      std::vector<Prepared> a, b;
      std::vector<IndexPair> indices;
      for (std::uint32_t i = 0; i < pairs_per_family; ++i) {
        const Pair pair = family.generate(1, i);
        a.push_back(prepare(pair.a));
        b.push_back(prepare(pair.b));
        indices.push_back({i, i});
        for (const auto& method : methods) std::puts(format_method_answer(method->ask(pair)).c_str());
        const Truth truth = judge(pair);
        const Enclosure distance = enclose_distance(pair, truth);
        std::puts(format_truth(truth, &distance).c_str());
      }
      for (const Instructions set : enum_values<Instructions>) {
        std::vector<Verdict> verdicts(pairs_per_family);
        intersect_batch(a, b, indices, verdicts.data(), set);
        for (const Verdict verdict : verdicts) std::puts(to_string(verdict));
      }
    }
  }
}
