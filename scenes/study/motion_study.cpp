// SPDX-License-Identifier: MIT
// The proofs of all pairs of a scene, on all cores.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <iterator>
#include <map>
#include <set>

#include "base/stopwatch.hpp"
#include "scenes/study/joint_path.hpp"
#include "scenes/study/scene_study.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// Boxes for one pair before all others had their turn.
constexpr std::size_t first_boxes_cap = 1000;

/// An SRDF is about contact. If bodies come within the clearance, this asks whether they ever touch.
MotionProof prove_contact(const Scene& scene, std::size_t a, std::size_t b, const MotionQuestion& question) {
  MotionProof proof = prove_motion(scene, a, b, question);
  if (proof.verdict != MotionVerdict::within && !proof.bounded) return proof;
  MotionQuestion touch = question;
  touch.clearance = 0;
  MotionProof contact = prove_motion(scene, a, b, touch);
  if (contact.verdict != MotionVerdict::never) return contact;
  proof.verdict = MotionVerdict::within;
  proof.bounded = false;
  proof.open_share = 0;
  proof.bound = contact.bound;
  contradict(proof, proof.least);
  return proof;
}

/// A pair that is to be proved.
struct Task {
  MotionProof* proof;
  bool contact;       ///< of links that an SRDF disables
  std::size_t moved;  ///< joints between the bodies: more cost more
};

class ProofQueue {
 public:
  ProofQueue(const Scene& scene, const MotionQuestion& question)
      : scene_(scene), question_(question), still_(joints_at(scene)) {
    for (std::size_t k = 0; k < motion_draws_cap; ++k) drawn_.push_back(draw_joints(scene, question.seed, k));
    question_.drawn = &drawn_;
  }

  void add(std::vector<MotionProof>& proofs, bool contact) {
    for (MotionProof& proof : proofs)
      tasks_.push_back({&proof, contact, JointPath(scene_, proof.a, proof.b).free_joints().size()});
  }

  void run() {
    std::ranges::stable_sort(tasks_, {}, &Task::moved);
    for (const std::size_t cap : {first_boxes_cap, question_.box_cap}) {
      question_.open_cap = cap;
      on_all_cores(
          tasks_.size(), question_.workforce.threads, [&](std::size_t i) { prove(tasks_[i]); },
          [&](std::size_t done) { show(done); });
      closed_ += std::erase_if(tasks_, [](const Task& task) {
        const MotionProof& p = *task.proof;
        return p.verdict != MotionVerdict::open || p.bounded || p.held;
      });
      if (cap >= question_.box_cap) break;
    }
  }

  double cpu_ms() const { return 1e-6 * ns_; }

 private:
  void prove(const Task& task) {
    MotionProof& proof = *task.proof;
    const double began = processor_ns();
    if (question_.workforce.out_of_time()) {
      proof.out_of_time = true;
      if (proof.boxes == 0) {
        const Pair pair = place_pair(scene_, still_, proof.a, proof.b);
        proof.least = distance(pair.a, pair.b).value;
        proof.open_share = 1;
      }
    } else {
      proof = (task.contact ? prove_contact : prove_motion)(scene_, proof.a, proof.b, question_);
      ++found_[static_cast<std::size_t>(proof.verdict)];
    }
    ns_ += processor_ns() - began;
  }

  void show(std::size_t done) const {
    if (!question_.workforce.show || tasks_.empty()) return;
    const auto found = [&](MotionVerdict verdict) {
      return found_[static_cast<std::size_t>(verdict)].load();
    };
    question_.workforce.show(static_cast<double>(done) / static_cast<double>(tasks_.size()),
                             fmt::format("proofs of {}: {} never, {} refuted",
                                         closed_ > 0 ? fmt::format("{} that are hard", tasks_.size())
                                                     : fmt::format("{} pairs", tasks_.size()),
                                         found(MotionVerdict::never), found(MotionVerdict::refuted)));
  }

  const Scene& scene_;
  MotionQuestion question_;
  std::vector<std::vector<double>> drawn_;
  std::vector<double> still_;
  std::vector<Task> tasks_;
  std::size_t closed_ = 0;
  std::array<std::atomic<std::size_t>, enum_words<MotionVerdict>.size()> found_{};
  std::atomic<double> ns_ = 0;
};

std::vector<MotionProof> not_proved_yet(const BodyPairs& pairs) {
  std::vector<MotionProof> proofs(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) std::tie(proofs[i].a, proofs[i].b) = pairs[i];
  return proofs;
}

ExemptionProof bodies_of(const Scene& scene, std::size_t exemption) {
  const auto& [one, other, reason] = scene.exemptions[exemption];
  ExemptionProof proof;
  proof.exemption = exemption;
  proof.not_looked_at = has_unknown_shapes(scene, one) || has_unknown_shapes(scene, other);
  std::vector<std::size_t> on_other;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (scene.bodies[b].link == other) on_other.push_back(b);
  BodyPairs pairs;
  for (std::size_t a = 0; a < scene.bodies.size(); ++a)
    for (const std::size_t b : on_other)
      if (scene.bodies[a].link == one && a != b) pairs.push_back(std::minmax(a, b));
  proof.bodies = not_proved_yet(pairs);
  return proof;
}

void conclude(ExemptionProof& proof) {
  const auto any = [&](MotionVerdict verdict) {
    return std::ranges::find(proof.bodies, verdict, &MotionProof::verdict) != proof.bodies.end();
  };
  if (any(MotionVerdict::refuted))
    proof.verdict = MotionVerdict::refuted;
  else if (!proof.not_looked_at && !any(MotionVerdict::open))
    proof.verdict = any(MotionVerdict::within) ? MotionVerdict::within : MotionVerdict::never;
}

}  // namespace

bool has_unknown_shapes(const Scene& scene, std::size_t link) {
  return std::ranges::find(scene.left_out, scene.links[link].name, &LeftOut::link) != scene.left_out.end();
}

std::vector<std::size_t> joints_held_between(const Scene& scene, const PairStudy& pair) {
  std::vector<std::size_t> links;
  // A parent comes before its link. The later of the two goes up until they meet.
  std::size_t a = scene.bodies[pair.a].link, b = scene.bodies[pair.b].link;
  while (a != b) {
    std::size_t& later = a > b ? a : b;
    if (!drawn_in_full(scene, later)) links.push_back(later);
    if (!scene.links[later].parent) break;
    later = *scene.links[later].parent;
  }
  return links;
}

std::vector<std::string> joints_held_between(const Scene& scene, const SceneStudy& study) {
  std::set<std::size_t> between;
  for (const PairStudy& pair : study.pairs)
    for (const std::size_t link : joints_held_between(scene, pair)) between.insert(link);
  std::vector<std::string> joints;
  for (const std::size_t link : between) joints.push_back(scene.links[link].joint);
  return joints;
}

MotionStudy prove_motions(const Scene& scene, const BodyPairs& pairs, std::span<const double> seen,
                          const MotionQuestion& question, const BodyPairs& others) {
  MotionStudy study;
  study.pairs = not_proved_yet(pairs);
  std::set<std::pair<std::size_t, std::size_t>> exempt;
  for (std::size_t i = 0; i < scene.exemptions.size(); ++i) {
    if (scene.exemptions[i].reason != "Never") continue;
    study.exemptions.push_back(bodies_of(scene, i));
    for (const MotionProof& proof : study.exemptions.back().bodies) exempt.emplace(proof.a, proof.b);
  }
  BodyPairs left;
  std::ranges::copy_if(others, std::back_inserter(left), [&](const auto& p) { return !exempt.contains(p); });
  study.others = not_proved_yet(left);
  ProofQueue queue(scene, question);
  queue.add(study.pairs, false);
  for (ExemptionProof& e : study.exemptions) queue.add(e.bodies, true);
  queue.add(study.others, false);
  queue.run();
  study.ms = queue.cpu_ms();
  std::map<std::pair<std::size_t, std::size_t>, double> least;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    contradict(study.pairs[i], seen[i]);
    least[pairs[i]] = seen[i];
  }
  const auto count = [&](const std::vector<MotionProof>& proofs) {
    study.contradicted +=
        static_cast<std::size_t>(std::ranges::count(proofs, true, &MotionProof::contradicted));
  };
  count(study.pairs);
  count(study.others);
  for (ExemptionProof& e : study.exemptions) {
    for (MotionProof& proof : e.bodies)
      if (const auto found = least.find({proof.a, proof.b}); found != least.end())
        contradict(proof, found->second);
    count(e.bodies);
    conclude(e);
  }
  return study;
}

}  // namespace cyl
