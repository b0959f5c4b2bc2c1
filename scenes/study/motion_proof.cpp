// SPDX-License-Identifier: MIT
#include "scenes/study/motion_proof.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>

#include "oracles/referee/referee.hpp"
#include "scenes/study/joint_path.hpp"
#include "scenes/study/overlap_proof.hpp"
#include "scenes/study/scene_study.hpp"

namespace cyl {
namespace {

/// Before any proof, configurations are drawn to find the bodies near each other. A search goes on from some
/// of them, for so many rounds. All this takes a few ms per pair.
constexpr std::size_t descents_cap = 4, descent_rounds_cap = 24;
/// The part of the seen distance beyond the clearance that a bound should reach if it is cheap.
constexpr double wanted_share = 0.5;
/// The boxes spent on a better bound if a pair is proved with fewer.
constexpr std::size_t better_boxes_cap = 500;

/// Whether the referee proves that the direction separates the solids, even if one grows by the gap. Only its
/// normal separates a half-space, but no double may have that direction and length 1.
bool separates(const Vector3& direction, Pair pair, double gap) {
  (is_half_space(pair.b) ? pair.a : pair.b).rounding += gap;
  if (has_half_space(pair)) return judge_verdict(pair).verdict == Verdict::disjoint;
  MethodAnswer witness;
  witness.status = Status::answered;
  witness.verdict = Verdict::disjoint;
  witness.set_direction(direction);
  return check_witness(pair, witness) == Verdict::disjoint;
}

struct Cell {
  JointBox box;
  double bound = -std::numeric_limits<double>::infinity();  ///< proved: the distance is greater all over it
  double share = 1;                                         ///< of the joints' space
  std::size_t widest = 0;                                   ///< the joint along which to cut the cell
  std::size_t number = 0;
};

struct LaterOf {
  bool operator()(const Cell& x, const Cell& y) const {
    return x.bound != y.bound ? x.bound > y.bound : x.number > y.number;
  }
};

class Prover {
 public:
  Prover(const Scene& scene, std::size_t a, std::size_t b, const MotionQuestion& question)
      : scene_(scene), q_(question), path_(scene, a, b), limits_(path_.limits()) {
    proof_.a = a;
    proof_.b = b;
    proof_.between = path_.free_joints();
    proof_.least = std::numeric_limits<double>::infinity();
  }

  MotionProof run() {
    search();
    if (proof_.verdict == MotionVerdict::open) divide();
    return std::move(proof_);
  }

 private:
  using Point = std::vector<double>;  ///< a value for each free joint of the path

  // Looks at one configuration. Returns true if it refutes the pair as place() puts it.
  bool look(const Distance& d, const JointBox& box) {
    const bool nearer = d.value < proof_.least;
    if (!nearer && (d.value - d.error > q_.clearance || proof_.verdict == MotionVerdict::within))
      return false;
    Point middle;
    for (const Range& range : box) middle.push_back(range.low + (range.high - range.low) / 2);
    if (nearer) {
      proof_.least = d.value;
      proof_.joints = middle;
    }
    if (d.value - d.error > q_.clearance) return false;
    Pair pair = place_pair(scene_, set_joints(scene_, proof_.between, middle), proof_.a, proof_.b);
    if (referee_within(pair, q_.clearance) != true) return false;
    proof_.least = d.value;
    proof_.joints = std::move(middle);
    proof_.verdict = MotionVerdict::within;
    if (d.value - d.error > 0) return false;
    // A solid may reach beyond its shapes by the excess. Only what lies inside the shapes counts.
    pair.a.rounding -= scene_.bodies[proof_.a].excess;
    pair.b.rounding -= scene_.bodies[proof_.b].excess;
    if (referee_within(pair, 0) != true) return false;
    proof_.verdict = MotionVerdict::refuted;
    return true;
  }

  double distance_at(const Point& point) {
    JointBox box;
    for (const double x : point) box.push_back({x, x});
    const Pair& placed = path_.place_middle(box);
    const Distance d = distance(placed.a, placed.b);
    refuted_ |= look(d, box);
    return d.value;
  }

  // Draws configurations, then goes downhill joint by joint from the nearest of them.
  void search() {
    std::vector<std::pair<double, Point>> drawn;
    for (std::size_t k = 0; k < (limits_.empty() ? 1 : motion_draws_cap) && !refuted_; ++k) {
      const std::vector<double> joints = q_.drawn ? (*q_.drawn)[k] : draw_joints(scene_, q_.seed, k);
      Point point;
      for (const std::size_t link : path_.free_joints()) point.push_back(joints[link]);
      const double d = distance_at(point);
      drawn.emplace_back(d, std::move(point));
    }
    std::ranges::stable_sort(drawn, {}, &std::pair<double, Point>::first);
    for (std::size_t k = 0; k < std::min(descents_cap, drawn.size()) && !refuted_; ++k) descend(drawn[k]);
  }

  void descend(std::pair<double, Point>& from) {
    auto& [least, point] = from;
    double part = 0.25;
    for (std::size_t round = 0; round < descent_rounds_cap && !refuted_; ++round) {
      bool better = false;
      for (std::size_t i = 0; i < point.size(); ++i) {
        for (const double sign : {-1.0, 1.0}) {
          const double before = point[i], step = sign * part * (limits_[i].high - limits_[i].low);
          point[i] = std::clamp(before + step, limits_[i].low, limits_[i].high);
          const double d = distance_at(point);
          if (refuted_) return;
          if (d < least) {
            least = d;
            better = true;
          } else {
            point[i] = before;
          }
        }
      }
      if (!better) part /= 2;
    }
  }

  // Bounds a cell. The referee proves that the direction of the distance in the middle, or an axis, separates
  // the bodies, even if one grows by the gap along it. The part that no travel uses up is left everywhere.
  // Returns true if the bodies come within the clearance.
  bool examine(Cell& cell) {
    ++proof_.boxes;
    cell.number = proof_.boxes;
    const Pair& placed = path_.place_middle(cell.box);
    const Distance d = distance(placed.a, placed.b);
    refuted_ = look(d, cell.box);
    if (proof_.verdict <= MotionVerdict::within) return true;
    Vector3 direction = d.direction;
    double gap = d.value - 2 * d.error;
    Travel travel = path_.travel(direction);
    const auto [along, axis] = path_.gap_along_axes();
    if (const double least = along - 2 * d.error; least > q_.clearance) {
      Travel far = path_.travel(axis);
      if (least - far.length > std::max(gap - travel.length, q_.clearance))
        std::tie(direction, gap, travel) = std::tuple(axis, least, std::move(far));
    }
    cell.widest = static_cast<std::size_t>(std::ranges::max_element(travel.shares) - travel.shares.begin());
    const double bound =
        gap - travel.length - scene_.bodies[proof_.a].excess - scene_.bodies[proof_.b].excess;
    if (!(bound > cell.bound) || !(bound > q_.clearance)) return false;
    if (separates(direction, placed, gap)) cell.bound = bound;
    return false;
  }

  void divide() {
    Cell all;
    all.box = limits_;
    if (examine(all)) return go_nearer();
    cells_.push(std::move(all));
    std::size_t enough = std::min(q_.open_cap, q_.box_cap);
    for (;;) {
      const bool proved = cells_.top().bound > q_.clearance;
      if (proved && proof_.verdict == MotionVerdict::open) {
        proof_.verdict = MotionVerdict::never;
        enough = std::min(q_.box_cap, std::max(2 * proof_.boxes, better_boxes_cap));
      }
      if (proved && cells_.top().bound >= q_.clearance + wanted_share * (proof_.least - q_.clearance)) break;
      proof_.out_of_time = !proved && q_.workforce.out_of_time();
      if (proof_.out_of_time || proof_.boxes + 2 > enough || !cut()) break;
      if (proof_.verdict <= MotionVerdict::within) return go_nearer();
    }
    proof_.held = path_.held();
    if (proof_.held) proof_.verdict = MotionVerdict::open;
    if (proof_.verdict != MotionVerdict::never) {
      proof_.open_share = proof_.held ? 1 : share_left();
      return;
    }
    proof_.bound = cells_.top().bound;
    contradict(proof_, proof_.least);
  }

  // Goes on from a place within the clearance, because the bodies may overlap nearby.
  void go_nearer() {
    std::pair<double, Point> from{proof_.least, proof_.joints};
    descend(from);
  }

  // Cuts the cell with the least bound along the joint that adds most to its travel. Returns false if no
  // joint moves.
  bool cut() {
    const Cell cell = cells_.top();
    if (cell.box.empty()) return false;
    const Range& range = cell.box[cell.widest];
    const double middle = range.low + (range.high - range.low) / 2;
    if (!(range.low < middle && middle < range.high)) return false;
    cells_.pop();
    for (const bool upper : {false, true}) {
      Cell part = cell;
      part.share /= 2;
      (upper ? part.box[cell.widest].low : part.box[cell.widest].high) = middle;
      if (examine(part)) return true;
      cells_.push(std::move(part));
    }
    return true;
  }

  double share_left() {
    double share = 0;
    for (; !cells_.empty() && !(cells_.top().bound > q_.clearance); cells_.pop()) share += cells_.top().share;
    return share;
  }

  const Scene& scene_;
  const MotionQuestion& q_;
  JointPath path_;
  JointBox limits_;
  MotionProof proof_;
  bool refuted_ = false;
  std::priority_queue<Cell, std::vector<Cell>, LaterOf> cells_;
};

}  // namespace

MotionProof prove_motion(const Scene& scene, std::size_t a, std::size_t b, const MotionQuestion& question) {
  MotionProof proof = Prover(scene, a, b, question).run();
  // A contact that is not confirmed for the shapes themselves is only one of solids that hold them.
  const bool holds = scene.bodies[a].box || scene.bodies[b].box;
  proof.bounded = proof.verdict == MotionVerdict::refuted
                      ? holds
                      : proof.verdict == MotionVerdict::within && (holds || question.clearance == 0);
  if (proof.bounded) {
    proof.verdict = MotionVerdict::open;
    proof.open_share = 1;
  }
  // If inner solids meet, the shapes meet. They prove nothing else.
  const auto has_inner = [](const Body& body) { return !body.box || body.inner; };
  if (proof.bounded && holds && has_inner(scene.bodies[a]) && has_inner(scene.bodies[b])) {
    Scene inner = scene;
    for (Body* body : {&inner.bodies[a], &inner.bodies[b]})
      std::tie(body->solid, body->box) = std::pair(inner_at(*body, body->solid), std::nullopt);
    MotionQuestion meet = question;
    meet.box_cap = 0;
    MotionProof found = prove_motion(inner, a, b, meet);
    if (!found.bounded && found.verdict <= MotionVerdict::within) return found;
  }
  proof.always = proof.verdict == MotionVerdict::refuted && overlap_always(scene, a, b);
  return proof;
}

std::vector<double> set_joints(const Scene& scene, const std::vector<std::size_t>& links,
                               const std::vector<double>& values) {
  std::vector<double> joints = joints_at(scene);
  for (std::size_t i = 0; i < links.size(); ++i) joints[links[i]] = values[i];
  let_follow(scene, joints);
  return joints;
}

void contradict(MotionProof& proof, double seen) {
  if (!(proof.bound > 0 && seen < proof.bound)) return;
  proof.verdict = MotionVerdict::open;
  proof.bound = 0;
  proof.open_share = 1;
  proof.contradicted = true;
}

}  // namespace cyl
