// SPDX-License-Identifier: MIT
#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "corpus/pairs/support.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {
namespace {

/// How a method spends its budget of evaluations of f: `global` on each of the three charts, then at most
/// `local` on each round of polishing.
struct Setting {
  std::string_view algorithm_name, setting;
  nlopt_algorithm algorithm;
  int global;
  int local;
  bool stop_at_sign;  ///< ends with the first direction of negative f, without a distance
  unsigned share;
  double relative;  ///< of the claim
};

/// The seed of NLopt's generator, which belongs to the thread. It is set before each pair. Otherwise an
/// answer would depend on the pairs before it.
constexpr unsigned long random_seed = 1;

/// First steps of the rounds of polishing, in chart coordinates. A simplex that has collapsed on a kink of f
/// starts anew, smaller, in the next round.
constexpr double polish_steps[3] = {0x1p-3, 0x1p-8, 0x1p-16};

/// Half the side of the chart that polishing may use. It is wider than the face (1), so that a minimum on an
/// edge of the cube is inside.
constexpr double polish_reach = 2;

/// Polishing ends at steps below this, in chart coordinates: two ulp of 1.
constexpr double polish_step_tol = 0x1p-51;

/// The same for the local searches inside MLSL. It is small enough to distinguish basins. Polishing does the
/// rest.
constexpr double basin_step_tol = 0x1p-20;

/// A pair scaled by a power of two so that its largest length is near 1, with the best direction seen so
/// far.
struct Problem {
  Terms<double> a, b;
  Vec3<double> delta;
  int exponent = 0;  ///< a length of the pair is 2^exponent lengths of the problem

  int chart = 0;
  double best = std::numeric_limits<double>::infinity();
  Vec3<double> best_direction{0, 0, 1};
};

// The offset may overflow, so half of it is formed first.
Problem scale(const Pair& pair) {
  const Vector3 half_delta = 0.5 * pair.b.center - 0.5 * pair.a.center;
  double largest = half_delta.cwiseAbs().maxCoeff();
  for (const Solid* c : {&pair.a, &pair.b})
    largest = std::max({largest, c->radius, c->height, c->rounding, std::ranges::max(c->edges)});

  Problem p;
  p.exponent = largest > 0 ? std::ilogb(largest) : 0;
  const auto scaled = [&](double x) { return std::scalbn(x, -p.exponent); };
  const auto terms = [&](Solid c) {
    for (double* x : {&c.radius, &c.height, &c.rounding, &c.edges[0], &c.edges[1], &c.edges[2]})
      *x = scaled(*x);
    return terms_of<double>(c);
  };
  p.a = terms(pair.a);
  p.b = terms(pair.b);
  p.delta = lifted<double>(Vector3(2 * half_delta.unaryExpr(scaled)));
  return p;
}

Vec3<double> direction_of(int chart, const double* x) {
  double d[3];
  d[chart] = 1;
  d[(chart + 1) % 3] = x[0];
  d[(chart + 2) % 3] = x[1];
  const Vec3<double> v{d[0], d[1], d[2]};
  return v / norm(v);
}

// Evaluates f(D)/|D| of Equation (6) with D on a face of the cube |x|, |y|, |z| <= 1. Because f(-D) = f(D),
// three faces are the whole sphere, and no chart has a pole.
double evaluate(unsigned, const double* x, double*, void* data) {
  Problem& p = *static_cast<Problem*>(data);
  const Vec3<double> d = direction_of(p.chart, x);
  const double f = support_gap(p.a, p.b, p.delta, d);
  if (std::isnan(f)) return HUGE_VAL;
  if (f < p.best) {
    p.best = f;
    p.best_direction = d;
  }
  return f;
}

using Optimizer = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

Optimizer make_optimizer(nlopt_algorithm algorithm, Problem& p, double reach, int evaluations,
                         bool stop_at_sign) {
  Optimizer opt(nlopt_create(algorithm, 2), nlopt_destroy);
  nlopt_set_min_objective(opt.get(), evaluate, &p);
  nlopt_set_lower_bounds1(opt.get(), -reach);
  nlopt_set_upper_bounds1(opt.get(), reach);
  nlopt_set_maxeval(opt.get(), evaluations);
  if (stop_at_sign) nlopt_set_stopval(opt.get(), -std::numeric_limits<double>::denorm_min());
  return opt;
}

// The codes that nlopt_optimize returns (budget reached, roundoff limited, failure) give no information on
// the minimum. The objective itself keeps the best direction. Nelder-Mead copes best with the kinks of f
// among NLopt's local methods without derivatives. In one pair of a hundred, SBPLX and COBYLA stop 10 to
// 10000 times farther from the minimum.
void minimise(Problem& p, const Setting& s) {
  nlopt_srand(random_seed);
  double x[2];
  double value;

  for (p.chart = 0; p.chart < 3; ++p.chart) {
    const Optimizer global = make_optimizer(s.algorithm, p, 1, s.global, s.stop_at_sign);
    const Optimizer basin = make_optimizer(NLOPT_LN_NELDERMEAD, p, 1, s.global, s.stop_at_sign);
    nlopt_set_xtol_abs1(basin.get(), basin_step_tol);
    nlopt_set_local_optimizer(global.get(), basin.get());
    x[0] = x[1] = 0;
    nlopt_optimize(global.get(), x, &value);
    if (s.stop_at_sign && p.best < 0) return;
  }

  for (double step : polish_steps) {
    const Optimizer local = make_optimizer(NLOPT_LN_NELDERMEAD, p, polish_reach, s.local, s.stop_at_sign);
    nlopt_set_initial_step1(local.get(), step);
    nlopt_set_xtol_abs1(local.get(), polish_step_tol);
    const Vector3 d(p.best_direction.x, p.best_direction.y, p.best_direction.z);
    d.cwiseAbs().maxCoeff(&p.chart);
    x[0] = d[(p.chart + 1) % 3] / d[p.chart];
    x[1] = d[(p.chart + 2) % 3] / d[p.chart];
    nlopt_optimize(local.get(), x, &value);
    if (s.stop_at_sign && p.best < 0) return;
  }
}

// Shares: an answer takes 0.15 ms with 600 evaluations, 0.3 ms with 1200, and 2.6 ms with 6000 of DIRECT.
// All other methods together take 0.1 ms on a pair.
//
// Claims: the largest errors seen, relative to the size, were 4e-2 (direct-600, crs-1200), 7e-4 (mlsl-1200)
// and 1.4e-5 (direct-6000). They come from 2500 pairs each of random solids, needles, disks and solids along
// the axes. Nine in ten errors were below 2e-10, and all above 2e-4 were depths of overlaps.
constexpr Setting settings[] = {
    {"direct", "600", NLOPT_GN_DIRECT_L, 120, 80, false, 64, 1e-1},
    {"direct", "6000", NLOPT_GN_DIRECT_L, 1800, 200, false, 1024, 1e-3},
    {"mlsl", "1200", NLOPT_G_MLSL_LDS, 300, 100, false, 64, 1e-2},
    {"crs", "1200", NLOPT_GN_CRS2_LM, 300, 100, false, 64, 1e-1},
    {"sign", "600", NLOPT_GN_DIRECT_L, 120, 80, true, 64, 1e-1},
};

// These are for curves. Their claims promise nothing, because no error is greater than the size.
constexpr Setting more_settings[] = {
    {"direct", "150", NLOPT_GN_DIRECT_L, 30, 20, false, 16, 1},
    {"direct", "300", NLOPT_GN_DIRECT_L, 60, 40, false, 32, 1},
    {"direct", "1500", NLOPT_GN_DIRECT_L, 350, 150, false, 256, 1},
    {"mlsl", "300", NLOPT_G_MLSL_LDS, 70, 30, false, 32, 1},
    {"mlsl", "600", NLOPT_G_MLSL_LDS, 140, 60, false, 64, 1},
    {"crs", "300", NLOPT_GN_CRS2_LM, 70, 30, false, 32, 1},
    {"crs", "600", NLOPT_GN_CRS2_LM, 140, 60, false, 64, 1},
    {"sign", "150", NLOPT_GN_DIRECT_L, 30, 20, true, 16, 1},
    {"sign", "1500", NLOPT_GN_DIRECT_L, 350, 150, true, 256, 1},
};

class Nlopt final : public Method {
 public:
  explicit Nlopt(const Setting& setting)
      : Method({"nlopt", std::string(setting.algorithm_name), std::string(setting.setting)}),
        setting_(setting) {
    int major, minor, bugfix;
    nlopt_version(&major, &minor, &bugfix);
    version_ = std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(bugfix);
  }

  std::string_view version() const override { return version_; }
  Claim claim() const override {
    return {
        .relative = setting_.relative,
        .source =
            "nlopt(3): Some of the algorithms attempt to find a global optimum. No error is promised: the "
            "relative part is ours, above the largest error seen with this budget.",
        .assumed = true};
  }
  unsigned share() const override { return setting_.share; }
  bool supports(SolidKind kind) const override { return kind != SolidKind::half_space; }

  MethodAnswer answer(const Pair& pair) override {
    if (const auto declined = decline_invalid(pair)) return *declined;
    Problem p = scale(pair);
    minimise(p, setting_);
    MethodAnswer answer = answered(p.best < 0 ? Verdict::disjoint : Verdict::intersecting);
    // A distance is returned only if the minimum was searched for, and if it does not overflow.
    answer.distance = -std::scalbn(p.best, p.exponent);
    answer.has_distance = std::isfinite(answer.distance) && !(setting_.stop_at_sign && p.best < 0);
    if (p.best < 0) {
      const Vec3<double>& d = p.best_direction;
      answer.set_direction((dot(d, p.delta) < 0 ? -1 : 1) * Vector3(d.x, d.y, d.z));
    }
    return answer;
  }

 private:
  const Setting setting_;
  std::string version_;
};

}  // namespace

std::vector<std::unique_ptr<Method>> nlopt_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  for (const Setting& s : settings) methods.push_back(std::make_unique<Nlopt>(s));
  return methods;
}

std::vector<std::unique_ptr<Method>> nlopt_settings() {
  std::vector<std::unique_ptr<Method>> methods;
  for (const Setting& s : more_settings) methods.push_back(std::make_unique<Nlopt>(s));
  return methods;
}

}  // namespace cyl
