// SPDX-License-Identifier: MIT
// A method: anything that answers a pair. It may decline or fail; it is never trusted.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/pairs/method_answer.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// From where on a method promises not to be undecided, where both solids are valid and within range.
enum class DecisionScope : unsigned char {
  not_promised,
  above_1e13,  ///< It decides gaps of 1e-13 of the size, and where a ball of that lies in both (law 39).
  all          ///< It decides every pair of which anybody can prove a verdict.
};

/// What a method promises: to be right wherever |distance| >= relative * size + absolute, and more.
struct Claim {
  double relative = 0;
  double absolute = 0;      ///< a length in the scene's unit
  std::string_view source;  ///< the line of its documentation or source that says so
  bool assumed = false;     ///< by us: `source` is no promise, but the best that its sources tell
  // No library documents any of these.
  bool bitwise_stable = false;  ///< A change that alters no digit of the question alters none of its answer.
  bool mirror_invariant = false;  ///< Its verdict stays, wherever, when signs of coordinates are flipped.
  bool certified = false;         ///< It offers a witness that proves its verdict with every yes and no.
  bool from_a_to_b = false;       ///< The directions it offers point from a to b.
  bool reports_invalid = false;   ///< It says `invalid` of a pair with a negative radius.
  DecisionScope decides = DecisionScope::not_promised;
};

/// Interface of a method. `ask` may do anything foreign code does: throw, abort, hang. Callers who cannot
/// afford that go through contained.hpp. `ask` is called from one thread; the same pair gives the same
/// answer.
class Method {
 public:
  virtual ~Method() = default;
  virtual std::string_view name() const = 0;     ///< <library>[-<way>][-<setting>]
  virtual std::string_view version() const = 0;  ///< of the library, as found at build or run time
  virtual Claim claim() const = 0;
  virtual bool foreign() const { return true; }
  virtual bool guest() const { return false; }  ///< no part of this build: guest.hpp
  /// Whether nothing that its library keeps outlives a call, so that it may be asked again in the same
  /// process after an assertion of it failed.
  virtual bool recovers() const { return false; }
  /// Asked on one index in so many (and wherever others disagree): > 1 for costly methods.
  virtual unsigned share() const { return 1; }
  /// Does what must be done once in the process that asks, such as to load a library; ask() does it where it
  /// was not done. May do what ask() may.
  virtual void initialize() {}
  /// Whether it has a shape for such solids.
  virtual bool supports(SolidKind kind) const { return kind == SolidKind::cylinder; }
  bool supports(const Pair& pair) const { return supports(kind_of(pair.a)) && supports(kind_of(pair.b)); }
  /// The solids that it really asks about, where it rounds the edges of cylinders on purpose.
  virtual Pair modelled(const Pair& pair) const { return pair; }
  /// Its answer, or that it declines a solid that it does not take.
  MethodAnswer ask(const Pair& pair) {
    if (supports(pair)) return answer(pair);
    return declined_shape(kind_of(supports(kind_of(pair.a)) ? pair.b : pair.a));
  }
  /// Whether it runs what is foreign in processes of its own, so that it may be asked in this one.
  virtual bool is_out_of_process() const { return false; }
  /// Whether it does better on many pairs than ask() does on each.
  virtual bool has_batch_call() const { return is_out_of_process(); }
  /// Asks about as many pairs, all of them or those up to the first failure, and returns how many these are.
  virtual std::size_t ask_many(std::span<const Pair> pairs, std::span<MethodAnswer> answers) {
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if ((answers[i] = ask(pairs[i])).status == Status::failed) return i + 1;
    return pairs.size();
  }
  /// Of one that runs apart: CPU time that its processes have taken.
  virtual std::chrono::nanoseconds cpu_time() const { return {}; }

  using Call = std::function<Verdict(std::size_t)>;
  /// For timing alone: does for all pairs what a user does once a solid (shapes built, axes normalised). The
  /// call returned says yes or no of pair i; it holds what it needs of `pairs`. Empty where there is no such
  /// way.
  virtual Call prepare_all(std::span<const Pair> pairs) {
    static_cast<void>(pairs);
    return {};
  }
  using DistanceCall = std::function<double(std::size_t)>;
  /// Likewise, for the signed distance with whatever witness comes with it; the call gives NaN where the
  /// method has none (many give none of overlapping solids).
  virtual DistanceCall prepare_distances(std::span<const Pair> pairs) {
    static_cast<void>(pairs);
    return {};
  }
  using BatchCall = std::function<void(std::span<Verdict>)>;
  /// Likewise, for all pairs in one call.
  virtual BatchCall prepare_batch(std::span<const Pair> pairs) {
    static_cast<void>(pairs);
    return {};
  }

 protected:
  /// Asked about no solid that it does not take.
  virtual MethodAnswer answer(const Pair& pair) = 0;
};

/// Every method of this build, in a fixed order: ours first.
std::vector<std::unique_ptr<Method>> all_methods();

/// The same libraries at more of their settings, for curves of speed against accuracy: no campaign asks
/// them. Names follow those of all_methods(), with which they share none.
std::vector<std::unique_ptr<Method>> setting_methods();

std::vector<std::unique_ptr<Method>> own_methods();  ///< intersect, decide, distance, exact
std::unique_ptr<Method> certifying_method();         ///< the one of own_methods() that is `certified`
std::vector<std::unique_ptr<Method>>
literature_2008_methods();  ///< the text of 2008 and the page of the book
std::vector<std::unique_ptr<Method>>
literature_2017_methods();  ///< of the text of 2017: put right, and as printed
std::vector<std::unique_ptr<Method>> nlopt_methods();
std::vector<std::unique_ptr<Method>> fcl_methods();
std::vector<std::unique_ptr<Method>> bullet_methods();
std::vector<std::unique_ptr<Method>> ccd_methods();
std::vector<std::unique_ptr<Method>> ode_methods();
std::vector<std::unique_ptr<Method>> mujoco_methods();
std::vector<std::unique_ptr<Method>> nlopt_settings();   ///< evaluations
std::vector<std::unique_ptr<Method>> fcl_settings();     ///< tolerances
std::vector<std::unique_ptr<Method>> bullet_settings();  ///< sides of the hull
std::vector<std::unique_ptr<Method>> ccd_settings();     ///< tolerances of MPR; GJK reads none
std::vector<std::unique_ptr<Method>> mujoco_settings();  ///< tolerances

/// Keeps the methods that `spec` names: "a,b" keeps a and b, "-a,b" (given as --methods=-a,b) all but a and
/// b; a name stands for every method that is it or begins with it and '-'. Throws UsageError on an
/// unknown name.
std::vector<std::unique_ptr<Method>> select_methods(std::vector<std::unique_ptr<Method>> methods,
                                                    std::string_view spec);

/// The same rule for any list of names (families): the indices kept, in order.
std::vector<std::size_t> select_names(const std::vector<std::string>& names, std::string_view spec);

}  // namespace cyl
