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
  SeedMethods() : methods_(seed_2008_methods()), ledger_("fuzz_seed_methods") {
    for (auto& method : seed_2017_methods()) methods_.push_back(std::move(method));
  }

  void run(const Record& record) {
    Brief brief(record, {}, false, ledger_);
    Method& method = *methods_[brief.draws().below(methods_.size())];
    brief.hold(method, method.ask(brief.pair()));
  }

 private:
  std::vector<std::unique_ptr<Method>> methods_;
  Ledger ledger_;
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
