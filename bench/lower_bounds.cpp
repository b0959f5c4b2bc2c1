// SPDX-License-Identifier: MIT
#include "bench/lower_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/statistics.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

struct Batch {
  std::vector<Prepared> solids;
  std::vector<std::array<std::uint32_t, 2>> pairs;  // indices of solids
  std::vector<Vector3> directions;                  // one a pair, unit
  std::vector<Verdict> verdicts;
};

// The axes of other pairs are uniform on the sphere and independent of these pairs.
Batch draw_batch(std::uint64_t seed, std::size_t count) {
  const Family& random = *find_family("random");
  Batch batch;
  for (std::size_t i = 0; i < count; ++i) {
    const Pair pair = random.generate(seed, i);
    const auto first = static_cast<std::uint32_t>(batch.solids.size());
    batch.solids.push_back(prepare(pair.a));
    batch.solids.push_back(prepare(pair.b));
    batch.pairs.push_back({first, first + 1});
    batch.directions.push_back(random.generate(seed, count + i).a.axis);
  }
  batch.verdicts.resize(count);
  return batch;
}

/// Returns r |P D| + h/2 |D.w|; dd is |D|^2.
double half_width(const Prepared& solid, const Vector3& d, double dd) {
  const double along = d.dot(solid.unit_axis);
  return solid.radius * std::sqrt(std::max(0.0, dd - along * along)) + solid.height / 2 * std::abs(along);
}

double equation_6(const Prepared& a, const Prepared& b, const Vector3& d) {
  const double dd = d.squaredNorm();
  return half_width(a, d, dd) + half_width(b, d, dd) - std::abs(d.dot(b.center - a.center));
}

void evaluate(Batch& batch) {
  double sum = 0;
  for (std::size_t i = 0; i < batch.pairs.size(); ++i) {
    const auto [a, b] = batch.pairs[i];
    sum += equation_6(batch.solids[a], batch.solids[b], batch.directions[i]);
  }
  keep(sum);
}

/// Reads the first, a middle and the last word of a solid. That touches every cache line of it with as few
/// instructions as possible.
std::uint64_t touch(const Prepared& solid) {
  std::uint64_t first, middle, last;
  static_assert(sizeof solid <= 2 * 64 && sizeof solid % sizeof last == 0);
  std::memcpy(&first, &solid, sizeof first);
  std::memcpy(&middle, reinterpret_cast<const char*>(&solid) + sizeof solid / 2, sizeof middle);
  std::memcpy(&last, reinterpret_cast<const char*>(&solid + 1) - sizeof last, sizeof last);
  return first ^ middle ^ last;
}

void pass_over(Batch& batch) {
  for (std::size_t i = 0; i < batch.pairs.size(); ++i) {
    const auto [a, b] = batch.pairs[i];
    batch.verdicts[i] = static_cast<Verdict>((touch(batch.solids[a]) ^ touch(batch.solids[b])) & 1);
  }
  keep(static_cast<unsigned>(batch.verdicts.back()));
}

}  // namespace

LowerBounds measure_lower_bounds(const BenchOptions& options) {
  Batch small = draw_batch(options.seed, options.pairs), large = draw_batch(options.seed, large_batch);
  const std::chrono::duration<double> round(options.min_time / options.passes);
  std::vector<double> evaluation, pass, large_pass;
  for (int i = 0; i < options.passes; ++i) {
    evaluation.push_back(series_cost([&](auto) { evaluate(small); }, options.pairs, round).ns);
    pass.push_back(series_cost([&](auto) { pass_over(small); }, options.pairs, round).ns);
    large_pass.push_back(series_cost([&](auto) { pass_over(large); }, large_batch, round).ns);
  }
  return {quantile(evaluation, 0.5), quantile(pass, 0.5), quantile(large_pass, 0.5)};
}

}  // namespace cyl
