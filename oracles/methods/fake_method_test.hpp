// SPDX-License-Identifier: MIT
// A method for tests, whose answers come from a function.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "oracles/methods/method.hpp"

namespace cyl {

struct FakeTraits {
  Claim claim = {};
  bool foreign = true, guest = false, is_out_of_process = false;
  unsigned share = 1;
  bool recovers = false;
};

class FakeMethod : public Method {
 public:
  using Ask = std::function<MethodAnswer(const Pair&)>;
  FakeMethod(std::string name, Ask ask, FakeTraits traits = {})
      : Method(split(name, traits.guest)), ask_(std::move(ask)), traits_(traits) {}
  std::string_view version() const override { return "1"; }
  Claim claim() const override { return traits_.claim; }
  bool foreign() const override { return traits_.foreign; }
  bool guest() const override { return traits_.guest; }
  bool is_out_of_process() const override { return traits_.is_out_of_process; }
  unsigned share() const override { return traits_.share; }
  bool recovers() const override { return traits_.recovers; }
  MethodAnswer answer(const Pair& pair) override { return ask_(pair); }

 private:
  /// A guest has algorithms of no name.
  static MethodName split(const std::string& name, bool guest) {
    const auto after = [&](std::size_t end) { return std::min(end, name.size() - 1) + 1; };
    const std::size_t first = name.find('-'), second = name.find('-', after(first));
    if (guest) return {name.substr(0, first), "", name.substr(after(first))};
    return {name.substr(0, first), name.substr(after(first), second - after(first)),
            name.substr(after(second))};
  }
  Ask ask_;
  FakeTraits traits_;
};

inline std::unique_ptr<Method> fake_method(std::string name, FakeMethod::Ask ask, FakeTraits traits = {}) {
  return std::make_unique<FakeMethod>(std::move(name), std::move(ask), traits);
}

}  // namespace cyl
