// SPDX-License-Identifier: MIT
#include "scenes/read/mesh_files.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "scenes/read/number_list.hpp"

namespace cyl {
namespace {

/// A binary STL begins with 80 bytes without meaning and the number of triangles. Each triangle has a
/// normal, three vertices and two more bytes. All numbers are little-endian.
constexpr std::size_t stl_head = 84, stl_triangle = 50, stl_normal = 12;

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << 8 * i;
  return value;
}

std::vector<Vector3> read_binary_stl(const std::string& bytes, std::size_t triangles) {
  std::vector<Vector3> vertices;
  for (std::size_t t = 0; t < triangles; ++t) {
    const char* number = bytes.data() + stl_head + stl_triangle * t + stl_normal;
    for (int corner = 0; corner < 3; ++corner) {
      Vector3 v;
      for (double& x : v) {
        x = static_cast<double>(std::bit_cast<float>(little_endian(number)));
        number += sizeof(float);
      }
      vertices.push_back(v);
    }
  }
  return vertices;
}

/// Returns the three numbers after `word` on each line that begins with it, as OBJ has them.
std::vector<Vector3> read_vertices(const std::string& text, const std::string& word) {
  std::vector<Vector3> vertices;
  std::istringstream in(text);
  std::size_t number = 0;
  for (std::string line, first; std::getline(in, line);) {
    ++number;
    std::istringstream fields(line);
    if (!(fields >> first) || first != word) continue;
    std::string rest;
    std::getline(fields >> std::ws, rest);
    while (rest.ends_with('\r')) rest.pop_back();
    const std::vector<double> x = parse_numbers(rest, "line " + std::to_string(number));
    if (x.size() < 3) throw std::runtime_error("line " + std::to_string(number) + ": fewer than 3 numbers");
    if (x.size() == 4 && x[3] != 1) throw std::runtime_error("line " + std::to_string(number) + ": a weight");
    vertices.emplace_back(x[0], x[1], x[2]);
  }
  return vertices;
}

/// Reads words and ignores line breaks. After the first line, each facet has three vertices.
std::vector<Vector3> read_text_stl(const std::string& text) {
  std::istringstream words(text.substr(std::min(text.size(), text.find('\n'))));
  std::vector<Vector3> vertices;
  std::size_t facets = 0;
  for (std::string word; words >> word;) {
    facets += word == "facet";
    if (word != "vertex") continue;
    std::string x, y, z;
    words >> x >> y >> z;
    const std::vector<double> at =
        parse_numbers(x + ' ' + y + ' ' + z, "vertex " + std::to_string(vertices.size() + 1));
    if (at.size() != 3) throw std::runtime_error("an STL that is cut short");
    vertices.emplace_back(at[0], at[1], at[2]);
  }
  if (vertices.size() != 3 * facets) throw std::runtime_error("an STL of facets without three vertices each");
  return vertices;
}

// A binary file that begins with "solid" is known by its length. Others may continue after their triangles.
std::vector<Vector3> read_stl(const std::string& bytes) {
  const bool text = bytes.starts_with("solid");
  if (bytes.size() >= stl_head) {
    const std::size_t triangles = little_endian(bytes.data() + 80);
    const std::size_t size = stl_head + stl_triangle * triangles;
    if (text ? bytes.size() == size : bytes.size() >= size) return read_binary_stl(bytes, triangles);
  }
  if (!text) throw std::runtime_error("an STL that is cut short, or none");
  if (bytes.find("endsolid") == bytes.npos) throw std::runtime_error("an STL that is cut short");
  return read_text_stl(bytes);
}

}  // namespace

std::vector<Vector3> read_mesh(const std::string& file, const std::string& bytes) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (ending != ".stl" && ending != ".obj")
    throw std::runtime_error("'" + ending + "' is neither .stl nor .obj");
  if (bytes.empty()) throw std::runtime_error("it is empty");
  std::vector<Vector3> vertices = ending == ".stl" ? read_stl(bytes) : read_vertices(bytes, "v");
  if (vertices.empty()) throw std::runtime_error("it has no vertices");
  if (!std::ranges::all_of(vertices, [](const Vector3& v) { return v.allFinite(); }))
    throw std::runtime_error("a vertex is not finite");
  return vertices;
}

}  // namespace cyl
