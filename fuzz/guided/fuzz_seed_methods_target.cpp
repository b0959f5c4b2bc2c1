// SPDX-License-Identifier: MIT
// The methods of the documents of 2008 and 2017 and of the book, held to their claims by the referee. A
// record asks one of them, which it draws itself: some cost 0.1 ms.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "fuzz/guided/fuzz_judge.hpp"

namespace cyl {
namespace {

class SeedMethods {
 public:
  SeedMethods() : methods_(literature_2008_methods()), sink_("fuzz_seed_methods") {
    for (auto& method : literature_2017_methods()) methods_.push_back(std::move(method));
  }

  void run(const Record& record) {
    FuzzJudge fuzz_judge(record, {}, false, sink_);
    Method& method = *methods_[fuzz_judge.draws().below(methods_.size())];
    fuzz_judge.record(method, method.ask(fuzz_judge.pair()));
  }

 private:
  std::vector<std::unique_ptr<Method>> methods_;
  FindingSink sink_;
};

}  // namespace
}  // namespace cyl

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size != cyl::record_size) return -1;  // newer engines keep no such input
  static cyl::SeedMethods methods;
  cyl::Record record;
  std::copy_n(data, size, record.begin());
  methods.run(record);
  return 0;
}
