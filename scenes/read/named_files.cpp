// SPDX-License-Identifier: MIT
#include "scenes/read/named_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace cyl {
namespace {

namespace fs = std::filesystem;

constexpr const char* package_file = "package.xml";
constexpr std::size_t package_cap = std::size_t(1) << 20;  ///< its largest size

bool is_inside(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

std::string larger_than(std::size_t cap) { return "it is larger than " + std::to_string(cap >> 20) + " MiB"; }

std::string read_bytes(const fs::path& file, std::size_t cap) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("it cannot be opened");
  std::string bytes;
  for (std::size_t size = 0; in; bytes.resize(size + static_cast<std::size_t>(in.gcount()))) {
    size = bytes.size();
    if (size > cap) throw std::runtime_error(larger_than(cap));
    bytes.resize(std::max<std::size_t>(2 * size, 4096));
    in.read(bytes.data() + size, static_cast<std::streamsize>(bytes.size() - size));
  }
  if (in.bad()) throw std::runtime_error("it cannot be read");
  return bytes;
}

struct ShapeCheck : pugi::xml_tree_walker {
  std::string fault;
  bool for_each(pugi::xml_node& node) override {
    if (depth() >= depth_cap) fault = "elements are nested more than " + std::to_string(depth_cap) + " deep";
    const auto attributes = node.attributes();
    if (static_cast<std::size_t>(std::distance(attributes.begin(), attributes.end())) > attribute_cap)
      fault = "an element has more than " + std::to_string(attribute_cap) + " attributes";
    return fault.empty();
  }
};

/// Returns the name of the ROS package in a folder, or an empty text.
std::string package_in(const fs::path& folder) {
  std::error_code none;
  pugi::xml_document document;
  if (!fs::is_regular_file(folder / package_file, none)) return "";
  try {
    const std::string text = read_bytes(folder / package_file, package_cap);
    document.load_buffer(text.data(), text.size());
  } catch (const std::runtime_error&) {
    return "";
  }
  return document.child("package").child_value("name");
}

}  // namespace

void check_given_file(const fs::path& file, std::size_t cap) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) throw std::runtime_error("it cannot be opened");
  if (status.type() != fs::file_type::regular && status.type() != fs::file_type::fifo)
    throw std::runtime_error("it is neither a regular file nor a pipe");
  if (status.type() == fs::file_type::regular && fs::file_size(file, error) > cap)
    throw std::runtime_error(larger_than(cap));
}

NamedFiles::NamedFiles(const std::string& first, const std::vector<std::string>& folders)
    : first_(first), folder_(fs::absolute(first).parent_path()) {
  std::error_code none;
  // The first file may be a link into the folder in which its package is developed.
  for (const fs::path& folder :
       {fs::weakly_canonical(folder_, none), fs::weakly_canonical(first, none).parent_path()}) {
    permit(folder);
    for (fs::path above = folder; above != above.root_path(); above = above.parent_path()) {
      if (!fs::exists(above / package_file, none)) continue;
      permit(above);
      break;
    }
  }
  for (const std::string& folder : folders) {
    permit(folder);
    for (const auto& package : fs::directory_iterator(folder, none))
      if (fs::exists(package.path() / package_file, none)) permit(package.path());
  }
}

void NamedFiles::permit(const fs::path& folder) {
  std::error_code none;
  const fs::path path = fs::weakly_canonical(folder, none);
  permitted_.push_back({path.has_filename() ? path : path.parent_path(), package_in(path)});
}

std::string NamedFiles::why_not(const fs::path& file) const {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  if (error) return "it is not there";
  if (std::ranges::none_of(permitted_, [&](const Folder& f) { return is_inside(real, f.path); }))
    return "it is outside " + permitted_.front().path.string() + " (--files-from DIR permits a folder)";
  return fs::is_regular_file(real, error) ? "" : "it is not a regular file";
}

std::string NamedFiles::read(const fs::path& file, NamedBy by) {
  if (by == NamedBy::user) {
    check_given_file(file, file_cap);
  } else if (const std::string why = why_not(file); !why.empty()) {
    throw std::runtime_error(why);
  }
  std::error_code none;
  if (by == NamedBy::file && fs::file_size(file, none) > file_cap)
    throw std::runtime_error(larger_than(file_cap));
  std::string bytes = read_bytes(file, file_cap);
  if (bytes.size() > bytes_left_)
    throw std::runtime_error("with it, the files of the scene are larger than " +
                             std::to_string(files_cap >> 20) + " MiB");
  bytes_left_ -= bytes.size();
  return bytes;
}

std::string NamedFiles::load(pugi::xml_document& document, const fs::path& file, NamedBy by) {
  std::string text = read(file, by);
  const auto tags = static_cast<std::size_t>(std::ranges::count(text, '<'));
  if (tags > tags_left_)
    throw std::runtime_error("more than " + std::to_string(tag_cap) + " tags in the files of the scene");
  tags_left_ -= tags;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result) {
    const auto line = 1 + std::count(text.begin(), text.begin() + result.offset, '\n');
    throw std::runtime_error("line " + std::to_string(line) + ": " + result.description());
  }
  ShapeCheck check;
  if (!document.traverse(check)) throw std::runtime_error(check.fault);
  return text;
}

fs::path NamedFiles::find(const std::string& name) const {
  constexpr std::string_view package = "package://", url = "file://";
  std::vector<fs::path> candidates;
  if (name.starts_with(url)) {
    candidates.emplace_back(name.substr(url.size()));
  } else if (!name.starts_with(package)) {
    candidates.push_back(folder_ / name);
  } else {
    const std::string path = name.substr(package.size()), owner = path.substr(0, path.find('/')),
                      rest = path.substr(std::min(path.size(), owner.size() + 1));
    const auto look_in = [&](const fs::path& folder) {
      if (folder.filename() == owner) candidates.push_back(folder / rest);
      candidates.push_back(folder / path);
    };
    for (const Folder& f : permitted_)
      if (!owner.empty() && f.package == owner) candidates.push_back(f.path / rest);
    for (fs::path folder = folder_; folder != folder.root_path(); folder = folder.parent_path())
      look_in(folder);
    for (const Folder& f : permitted_) look_in(f.path);
  }
  std::string why;
  for (const fs::path& file : candidates) {
    const std::string fault = why_not(file);
    if (fault.empty()) return file;
    std::error_code none;
    if (why.empty() && fs::exists(file, none)) why = fault;
  }
  throw std::runtime_error(why.empty() ? "it is not there" : why);
}

}  // namespace cyl
