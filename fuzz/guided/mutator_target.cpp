// SPDX-License-Identifier: MIT
// The hooks by which a fuzzing engine mutates and crosses records as pairs of solids. Linked with every
// target that an engine drives.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "fuzz/guided/mutator.hpp"
#include "fuzz/guided/record.hpp"

// libFuzzer's own; another engine may lack it.
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                                              std::size_t max_size);

namespace {

/// The engine's own mutation, blind to doubles, is used once in this many.
constexpr std::size_t blind_share = 16;

cyl::Pair decode(const std::uint8_t* data, std::size_t size) {
  // Other bytes become a pair that the mutator makes legal.
  return cyl::decode_record({data, size}).value_or(cyl::Pair{});
}

std::size_t write(const cyl::Pair& pair, std::uint8_t* data, std::size_t room) {
  if (room < cyl::record_size) return 0;
  const cyl::Record record = cyl::encode_record(pair);
  std::copy(record.begin(), record.end(), data);
  return record.size();
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  if (max_size < cyl::record_size) return size;
  if (LLVMFuzzerMutate && size == cyl::record_size &&
      cyl::RandomStream("blind", seed, 0).below(blind_share) == 0) {
    cyl::Record record{};
    std::copy_n(data, size, record.begin());
    LLVMFuzzerMutate(record.data(), record.size(), record.size());
    std::copy(record.begin(), record.end(), data);
    return record.size();
  }
  return write(cyl::mutate(decode(data, size), seed), data, max_size);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1,
                                                 const std::uint8_t* data2, std::size_t size2,
                                                 std::uint8_t* out, std::size_t max_out_size, unsigned seed) {
  return write(cyl::cross_over(decode(data1, size1), decode(data2, size2), seed), out, max_out_size);
}

// The stacks of allocations and a large quarantine cost a tenth of the time; what is freed and used again
// shows without them.
extern "C" const char* __asan_default_options() { return "malloc_context_size=2:quarantine_size_mb=16"; }
