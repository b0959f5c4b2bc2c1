// SPDX-License-Identifier: MIT
#include "reports/export/linked_libraries.hpp"

#include <elf.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

namespace cyl {
namespace {

/// Returns the struct at `at` if the file contains all of it.
template <class Struct>
std::optional<Struct> read_at(std::string_view elf, std::uint64_t at) {
  Struct read;
  if (at > elf.size() || elf.size() - at < sizeof read) return {};
  std::memcpy(&read, elf.data() + at, sizeof read);
  return read;
}

/// Returns "-lccd" for "libccd.so.2". Empty if the compiler links it by default, or only a path can name it.
std::string flag_of(std::string_view name) {
  constexpr std::array common{"c", "m", "dl", "rt", "pthread", "stdc++", "gcc_s", "c++", "c++abi", "unwind"};
  const std::size_t end = name.find(".so");
  if (!name.starts_with("lib") || end == name.npos) return {};
  const std::string_view stem = name.substr(3, end - 3);
  if (std::find(common.begin(), common.end(), stem) != common.end()) return {};
  // The name comes from a file and goes into a script, so only plain characters are allowed.
  const bool plain = std::all_of(stem.begin(), stem.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-' || c == '+' || c == '.';
  });
  if (!plain) return {};
  return "-l" + std::string(stem);
}

}  // namespace

std::string linked_libraries(std::string_view elf) {
  const auto head = read_at<Elf64_Ehdr>(elf, 0);
  if (!head || std::memcmp(head->e_ident, ELFMAG, SELFMAG) != 0 || head->e_ident[EI_CLASS] != ELFCLASS64)
    return {};
  std::string flags;
  for (std::uint64_t s = 0; s < head->e_shnum; ++s) {
    const auto section = read_at<Elf64_Shdr>(elf, head->e_shoff + s * sizeof(Elf64_Shdr));
    if (!section || section->sh_type != SHT_DYNAMIC) continue;
    const auto names = read_at<Elf64_Shdr>(elf, head->e_shoff + section->sh_link * sizeof(Elf64_Shdr));
    for (std::uint64_t at = 0; names && at < section->sh_size; at += sizeof(Elf64_Dyn)) {
      const auto entry = read_at<Elf64_Dyn>(elf, section->sh_offset + at);
      if (!entry || entry->d_tag == DT_NULL) break;
      const std::uint64_t name = names->sh_offset + entry->d_un.d_val;
      if (entry->d_tag != DT_NEEDED || name >= elf.size()) continue;
      const std::string_view rest = elf.substr(name);
      const std::string flag = flag_of(rest.substr(0, rest.find('\0')));
      if (!flag.empty()) flags += (flags.empty() ? "" : " ") + flag;
    }
  }
  return flags;
}

std::string linked_libraries_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return linked_libraries(std::string{std::istreambuf_iterator<char>(in), {}});
}

}  // namespace cyl
