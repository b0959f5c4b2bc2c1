// SPDX-License-Identifier: MIT
#include "fuzz/campaign/batch_process.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/process/process.hpp"
#include "corpus/store/batch_bytes.hpp"

namespace cyl {
namespace {

const ChildOptions batch_child{.failure = "a batch failed", .own_group = true};

}  // namespace

BatchProcess::BatchProcess(std::uint64_t first, std::uint64_t next, const std::function<BatchRecord()>& make,
                           std::chrono::seconds cpu_cap)
    : first_(first),
      next_(next),
      cpu_cap_(cpu_cap),
      child_([&] { return format_batch(make()); }, batch_child) {}

BatchProcess::BatchProcess(std::uint64_t first, std::uint64_t next, const std::vector<std::string>& command,
                           std::chrono::seconds cpu_cap)
    : first_(first), next_(next), cpu_cap_(cpu_cap), child_(command, batch_child) {}

// A limit of the process itself would be inherited by the contained workers and blamed on whom they happen to
// ask.
bool BatchProcess::advance() {
  if (child_.advance()) return true;
  if (child_.cpu_time() > cpu_cap_) {
    over_cap_ = true;
    child_.kill_now();
  }
  return false;
}

BatchRecord BatchProcess::take() const {
  if (over_cap_) throw std::runtime_error(fmt::format("no end after {} s of CPU time", cpu_cap_.count()));
  if (child_.status() != 0) throw std::runtime_error(how_it_ended(child_.status()));
  BatchRecord batch = parse_batch(child_.bytes());
  batch.first = first_;
  batch.next = next_;
  return batch;
}

}  // namespace cyl
