// SPDX-License-Identifier: MIT
// A method answers pairs. It may decline or fail, and is never trusted.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "corpus/pairs/method_answer.hpp"
#include "corpus/pairs/size_range.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// On which pairs a method promises to decide, if both solids are valid and within its range.
enum class DecisionScope : unsigned char {
  not_promised,
  above_1e13,  ///< It decides gaps of 1e-13 of the size, or if a ball that large fits in both (law 39).
               ///< It does not promise that for boxes.
  all          ///< It decides every pair whose verdict can be proved.
};

/// The promises of a method. The main one: it is right if |distance| >= relative * size + absolute.
struct Claim {
  double relative = 0;
  double absolute = 0;      ///< a length in the scene's unit
  std::string_view source;  ///< the line of its documentation or source that states it
  bool assumed = false;     ///< The library states no tolerance: `source` is the basis of an estimate.
  // No library documents what follows.
  bool bitwise_stable =
      false;  ///< If a transformation is exact, such as scaling by 2^k, the answer keeps every digit.
  /// Its verdict on solids without rounding never changes if the signs of coordinates are flipped.
  bool mirror_invariant = false;
  bool certified = false;        ///< Each yes and no comes with a witness that proves it.
  bool from_a_to_b = false;      ///< The directions it offers point from a to b.
  bool reports_invalid = false;  ///< It answers `invalid` to a pair with a negative radius.
  DecisionScope decides = DecisionScope::not_promised;
};

/// "fcl-libccd-tol1e-10": a library, one of its algorithms, and a setting. The parts that the name leaves out
/// are empty.
struct MethodName {
  std::string library, algorithm = {}, setting = {};
};

/// A method. `ask` may do anything that foreign code does: throw, abort, hang. contained.hpp calls it safely.
/// `ask` is called from one thread. The same pair gives the same answer.
class Method {
 public:
  explicit Method(MethodName name = {}) { set_name(std::move(name)); }
  virtual ~Method() = default;
  std::string_view name() const { return name_; }
  const MethodName& name_parts() const { return parts_; }
  std::string_view library() const { return parts_.library; }  ///< of a guest: its own name
  virtual std::string_view version() const = 0;  ///< of the library, as found at build or run time
  virtual Claim claim() const = 0;
  virtual bool foreign() const { return true; }   ///< code of another project
  virtual bool guest() const { return false; }    ///< loaded by --plugin or started by --command
  virtual bool program() const { return false; }  ///< started by --command
  /// Returns whether its library keeps no state between calls. Then it may be asked again in the same process
  /// after one of its assertions failed.
  virtual bool recovers() const { return false; }
  /// Costly methods return n > 1. They get one pair in n, and each pair on which another method is wrong
  /// beyond its claim.
  virtual unsigned share() const { return 1; }
  /// Performs one-time initialization in the calling process, such as loading a library. The first answer()
  /// does the same if there was no call. May fail like answer().
  virtual void initialize() {}
  /// Returns whether it has a shape for such solids. No pair has two half-spaces.
  virtual bool supports(SolidKind kind) const { return kind == SolidKind::cylinder; }
  /// Returns the sizes that it claims to support; null if it claims none.
  virtual const SizeRange* sizes() const { return nullptr; }
  bool supports_kinds(const Pair& pair) const {
    return supports(kind_of(pair.a)) && supports(kind_of(pair.b));
  }
  bool supports(const Pair& pair) const { return supports_kinds(pair) && (!sizes() || sizes()->holds(pair)); }
  /// Returns why it declines a pair that it does not support.
  MethodAnswer decline(const Pair& pair) const {
    for (const Solid* solid : {&pair.a, &pair.b})
      if (!supports(kind_of(*solid))) return declined_shape(kind_of(*solid));
    return declined_size();
  }
  /// Returns the solids that it really tests. They differ from `pair` if it rounds the
  /// edges of cylinders and boxes on purpose.
  virtual Pair modelled(const Pair& pair) const { return pair; }
  /// Returns its answer. It declines pairs that it does not support.
  MethodAnswer ask(const Pair& pair) { return supports(pair) ? answer(pair) : decline(pair); }
  /// Returns whether it runs foreign code in processes of its own, so that a call of ask() is
  /// safe in this process.
  virtual bool is_out_of_process() const { return false; }
  /// Returns whether ask_many() costs less than a call of ask() for each pair.
  virtual bool has_batch_call() const { return is_out_of_process(); }
  /// Asks about all pairs, or about those up to the first failure. Returns the number of answers.
  virtual std::size_t ask_many(std::span<const Pair> pairs, std::span<MethodAnswer> answers) {
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if ((answers[i] = ask(pairs[i])).status == Status::failed) return i + 1;
    return pairs.size();
  }
  /// Returns the CPU time of its processes, if it is out of process.
  virtual std::chrono::nanoseconds cpu_time() const { return {}; }

  using Call = std::function<Verdict(std::size_t)>;
  /// For timing only: prepares all solids once (builds shapes, normalises axes). Returns a function that
  /// gives the verdict of pair i and owns the data that it needs. The function is empty if the method cannot
  /// prepare.
  virtual Call prepare_all(std::span<const Pair> pairs) {
    static_cast<void>(pairs);
    return {};
  }
  using DistanceCall = std::function<double(std::size_t)>;
  /// Like prepare_all(), but the function computes the witness and returns the signed distance, or NaN if the
  /// method has no distance. Many have none for overlapping solids.
  virtual DistanceCall prepare_distances(std::span<const Pair> pairs) {
    static_cast<void>(pairs);
    return {};
  }
  using BatchCall = std::function<void(std::span<Verdict>)>;
  /// As prepare_all(), with one call for all pairs.
  virtual BatchCall prepare_batch(std::span<const Pair> pairs) {
    static_cast<void>(pairs);
    return {};
  }

 protected:
  /// Called only for pairs that supports() accepts.
  virtual MethodAnswer answer(const Pair& pair) = 0;
  void set_name(MethodName name) {
    parts_ = std::move(name);
    name_ = parts_.library;
    for (const std::string& part : {parts_.algorithm, parts_.setting})
      if (!part.empty()) name_ += '-' + part;
  }

 private:
  MethodName parts_;
  std::string name_;
};

/// Every method of this build, in a fixed order: ours first.
std::vector<std::unique_ptr<Method>> all_methods();

/// The same libraries at more settings, only for the curves of speed against accuracy. Campaigns do not use
/// them. Their names differ from all names of all_methods().
std::vector<std::unique_ptr<Method>> setting_methods();

std::vector<std::unique_ptr<Method>> own_methods();  ///< intersect, decide, distance, exact
std::unique_ptr<Method> certifying_method();         ///< the one of own_methods() that is `certified`
std::vector<std::unique_ptr<Method>>
literature_2008_methods();  ///< seed2008 and seedbook: docs/algorithms.md
std::vector<std::unique_ptr<Method>> literature_2017_methods();  ///< seed2017: docs/algorithms.md
std::vector<std::unique_ptr<Method>> nlopt_methods();
std::vector<std::unique_ptr<Method>> fcl_methods();
std::vector<std::unique_ptr<Method>> bullet_methods();
std::vector<std::unique_ptr<Method>> ccd_methods();
/// Returns ccd_methods() under the same names, with the sums of our support function, which libccd calls, in
/// another order. If this changes an answer, the answer depends on the last bit of our sums.
std::vector<std::unique_ptr<Method>> ccd_methods_of_other_sums();
std::vector<std::unique_ptr<Method>> ode_methods();
std::vector<std::unique_ptr<Method>> mujoco_methods();
std::vector<std::unique_ptr<Method>> nlopt_settings();   ///< evaluations
std::vector<std::unique_ptr<Method>> fcl_settings();     ///< tolerances
std::vector<std::unique_ptr<Method>> bullet_settings();  ///< sides of the hull
std::vector<std::unique_ptr<Method>> ccd_settings();     ///< tolerances of MPR; GJK reads none
std::vector<std::unique_ptr<Method>> mujoco_settings();  ///< tolerances

/// Keeps the methods that `spec` names. "a,b" keeps a and b; "-a,b" (given as --methods=-a,b) keeps all
/// others. "fcl" selects the method `fcl` and all methods `fcl-..`. Throws UsageError on an unknown name.
std::vector<std::unique_ptr<Method>> select_methods(std::vector<std::unique_ptr<Method>> methods,
                                                    std::string_view spec);

/// Applies it to names, such as families. Returns the kept indices, in order.
std::vector<std::size_t> select_names(const std::vector<std::string>& names, std::string_view spec);

}  // namespace cyl
