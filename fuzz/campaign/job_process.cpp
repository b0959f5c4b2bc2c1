// SPDX-License-Identifier: MIT
#include "fuzz/campaign/job_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <stdexcept>

#include "base/process/process.hpp"
#include "corpus/store/batch_bytes.hpp"

namespace cyl {
namespace {

using Range = std::array<std::uint64_t, 2>;

/// Means that there are no more batches. The end of the pipe does not show it, because later jobs hold it
/// open.
constexpr Range no_more{0, 0};

// Each batch follows its size.
void serve(int ranges, int output, const JobProcess::MakeBatch& make) {
  for (Range range; read(ranges, &range, sizeof range) == sizeof range && range != no_more;) {
    const std::string batch = format_batch(make(range[0], range[1]));
    const std::uint64_t size = batch.size();
    write_all(output, {reinterpret_cast<const char*>(&size), sizeof size});
    write_all(output, batch);
  }
}

}  // namespace

JobProcess::Pipe::Pipe() {
  if (pipe2(ends, O_CLOEXEC) != 0) throw_errno("pipe");
}
JobProcess::Pipe::~Pipe() { close_all({ends[0], ends[1]}); }

JobProcess::JobProcess(const std::function<MakeBatch()>& prepare, std::chrono::seconds cpu_cap)
    : cpu_cap_(cpu_cap),
      child_(std::function<void(int)>([&](int output) {
               close(ranges_.ends[1]);
               serve(ranges_.ends[0], output, prepare());
             }),
             {.failure = "a batch failed", .own_group = true}) {}

JobProcess::~JobProcess() {
  if (busy_ || child_.advance()) return;
  write_all(ranges_.ends[1], {reinterpret_cast<const char*>(&no_more), sizeof no_more});
  child_.wait();
}

void JobProcess::begin(std::uint64_t first, std::uint64_t next) {
  first_ = first;
  next_ = next;
  busy_ = true;
  cpu_at_start_ = child_.cpu_time();
  const Range range{first, next};
  write_all(ranges_.ends[1], {reinterpret_cast<const char*>(&range), sizeof range});
}

// A limit of the process itself would be inherited by the contained workers and blamed on whom they happen to
// ask.
bool JobProcess::advance() {
  if (child_.advance()) return true;
  std::uint64_t size = 0;
  const std::string& bytes = child_.bytes();
  if (bytes.size() >= sizeof size) std::memcpy(&size, bytes.data(), sizeof size);
  if (size > 0 && bytes.size() >= sizeof size + size) return true;
  if (busy_ && child_.cpu_time() - cpu_at_start_ > cpu_cap_) {
    over_cap_ = true;
    child_.kill_now();
  }
  return false;
}

BatchRecord JobProcess::take() {
  if (over_cap_) throw std::runtime_error(fmt::format("no end after {} s of CPU time", cpu_cap_.count()));
  if (child_.ended()) throw std::runtime_error(how_it_ended(child_.status()));
  std::uint64_t size = 0;
  std::memcpy(&size, child_.bytes().data(), sizeof size);
  BatchRecord batch = parse_batch(child_.bytes().substr(sizeof size, size));
  child_.forget_bytes(sizeof size + size);
  batch.first = first_;
  batch.next = next_;
  busy_ = false;
  return batch;
}

}  // namespace cyl
