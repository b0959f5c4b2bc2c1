// SPDX-License-Identifier: MIT
#include "fuzz/guided/visited.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <fstream>
#include <system_error>

namespace cyl {
namespace {

constexpr std::size_t angles = enum_values<AngleClass>.size();

Visited own;
Visited* current = &own;

}  // namespace

std::size_t index_of(const Stratum& s) {
  return (static_cast<std::size_t>(s.feature) * angles + static_cast<std::size_t>(*s.angle)) *
             margin_decade_count +
         static_cast<std::size_t>(s.decade);
}

Stratum stratum_at(std::size_t index) {
  return {static_cast<ContactFeature>(index / margin_decade_count / angles),
          static_cast<int>(index % margin_decade_count),
          static_cast<AngleClass>(index / margin_decade_count % angles)};
}

Visited& visited() { return *current; }

void count_execution() { std::atomic_ref(current->executions).fetch_add(1, std::memory_order_relaxed); }

void keep_visited(const std::string& file) {
  const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  void* memory = MAP_FAILED;
  if (descriptor >= 0 && ftruncate(descriptor, sizeof(Visited)) == 0)
    memory = mmap(nullptr, sizeof(Visited), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  const int error = errno;
  if (descriptor >= 0) close(descriptor);
  if (memory == MAP_FAILED) throw std::system_error(error, std::generic_category(), file);
  current = static_cast<Visited*>(memory);
}

Visited read_visited(const std::string& file) {
  Visited seen;
  std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(&seen), sizeof seen);
  return seen;
}

}  // namespace cyl
