// SPDX-License-Identifier: MIT
// A method of the documents this project starts from: literature_2008_method.cpp, literature_2017_method.cpp.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "oracles/methods/adapter.hpp"
#include "oracles/methods/method.hpp"
#include "solver/literature/document.hpp"

namespace cyl {

class LiteratureMethod final : public Method {
 public:
  using Separate = std::function<literature::Separation(const Prepared&, const Prepared&)>;

  /// `version`: the document's date. A literal text takes the axes as they are given.
  LiteratureMethod(MethodName name, std::string_view version, const Claim& claim, unsigned share,
                   bool literal, Separate separate)
      : Method(std::move(name)),
        version_(version),
        claim_(claim),
        share_(share),
        prepare_(literal ? literature::prepare_as_given : prepare),
        separate_(std::move(separate)) {}

  std::string_view version() const override { return version_; }
  Claim claim() const override { return claim_; }
  bool foreign() const override { return false; }
  unsigned share() const override { return share_; }
  MethodAnswer answer(const Pair& pair) override {
    const literature::Separation found = separate_(prepare_(pair.a), prepare_(pair.b));
    MethodAnswer answer = answered(found.verdict);
    if (found.verdict == Verdict::disjoint) answer.set_direction(found.direction);
    return answer;
  }
  Call prepare_all(std::span<const Pair> pairs) override {
    return [this, solids = solids_of<Prepared>(pairs, prepare_)](std::size_t i) {
      return separate_(solids[i].first, solids[i].second).verdict;
    };
  }

 private:
  const std::string_view version_;
  const Claim claim_;
  const unsigned share_;
  Prepared (*const prepare_)(const Solid&) noexcept;
  const Separate separate_;
};

}  // namespace cyl
