// SPDX-License-Identifier: MIT
// Measures how bad a method is on one shape. The solids are moved until they touch, and the method is asked
// about pairs along the direction in which they separate. The solver's estimate guides the search, and kept
// pairs are proved.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fuzz/worst/worst.hpp"
#include "solver/distance.hpp"

namespace cyl {

/// Returns a method that answers as `method` does, with the time of a call in ns as the distance: the least
/// of a few.
std::unique_ptr<Method> timed(Method& method, double (*clock)());

/// The value of a shape on which nothing is wrong.
inline constexpr double nothing_wrong = -1000;

/// How bad the method is on a shape, and the pair on its ray on which it is.
struct Evaluation {
  double value = nothing_wrong;
  Pair pair{};
};

/// A shape: the solids touching, and the direction in which b moves away from a. Apart, the margin along it
/// is the distance; into each other it is no less than the depth.
struct Ray {
  Pair touching;
  Vector3 direction;
  double size;
  Pair at(double margin) const;
};

class ShapeEvaluator {
 public:
  ShapeEvaluator(const std::unique_ptr<Method>& method, const Sought& sought, const WorstOptions& options);

  /// Asks about a shape, and keeps in worst() what is worse than all before. A shape on which something
  /// breaks counts for nothing: it is not walked from.
  Evaluation evaluate(const Pair& pair);
  /// Returns whether the wanted features meet, by the solver. It is fast, and proved later if it matters.
  bool likely_sought(const Pair& pair, const Distance& d) const;
  /// Returns whether so much has broken that the search has found its worst.
  bool broken() const;
  unsigned breaks() const { return breaks_; }  ///< crashes, and hangs for several each
  const Evaluation& best() const { return best_; }
  Worst& worst() { return worst_; }
  const Worst& worst() const { return worst_; }

 private:
  struct Probe {
    Pair pair;
    double margin;  ///< signed, along the ray
    MethodAnswer answer{};
  };

  /// Asks about the pair itself and about others of its ray, and returns all of them.
  std::vector<Probe> ask_along(const Pair& pair, const Ray& ray, int per_decade);
  /// Stops at the first hang and notes what fails.
  void ask(std::vector<Probe>& probes);
  void note_failure(const Probe& probe);
  /// For the optimiser: beyond the claim by the margin, else by the part of the claim that is used.
  double value_of(double margin, double size) const;
  /// The value if the answer is wrong, by the solver.
  double likely_value(const Probe& probe) const;
  /// The worst of the answers, if that is worse than `value`.
  const Probe* worst_among(const std::vector<Probe>& probes, double& value) const;
  Evaluation most_wrong_on(const Pair& pair, const Ray& ray);
  double proved_value() const;
  double prove(const Probe& wrong, double likely);
  // If the slowest does not count, the next may.
  Evaluation slowest_on(const Pair& pair, const Ray& ray);
  /// A time that something else caused does not come again.
  Evaluation confirm(const Probe& probe);
  /// For searches by a score.
  Evaluation highest_on(const Pair& pair, const Ray& ray);
  bool belongs(const Pair& pair) const;

  const std::unique_ptr<Method>& method_;
  const Sought& sought_;
  const WorstOptions& options_;
  const Claim claim_;
  std::unique_ptr<Method> timed_;
  std::optional<Asker> asker_;  ///< of the one that is asked
  Evaluation best_;
  double proved_ = nothing_wrong;
  unsigned breaks_ = 0;
  Worst worst_;
};

}  // namespace cyl
