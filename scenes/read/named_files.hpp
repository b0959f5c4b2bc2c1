// SPDX-License-Identifier: MIT
// The files that a scene is read from. A stranger may have written them, so one rule holds for all of them:
//
// 1. The user names the first file, and maybe an SRDF. Each is a regular file or a pipe.
// 2. Files name others: meshes, includes, and the SRDF beside a URDF. Each is a regular file in the folder
//    of the first file, in the ROS package that holds the first file, or in a folder that the user permits.
//    Symbolic links are followed first.
// 3. Size and nesting have limits, which are far above those of real scenes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace cyl {

/// The largest mesh or description, and the sum of all files of a scene but its list of solids.
inline constexpr std::size_t file_cap = std::size_t(64) << 20, files_cap = std::size_t(1) << 30;
/// The largest list of solids, a few million of them.
inline constexpr std::size_t list_cap = std::size_t(1) << 30;
/// The most elements within elements, because a walk through them needs room on the stack.
inline constexpr int depth_cap = 1000;
/// The most tags in all descriptions of a scene, and the most attributes of an element: urdfdom compares each
/// attribute with all others.
inline constexpr std::size_t tag_cap = 300'000, attribute_cap = 100;
/// The most links, and the most shapes of a URDF. urdfdom frees a chain of links recursively. Some walks
/// visit all links above each link, and a shape is compared with all others of its link.
inline constexpr std::size_t link_cap = 10'000, shape_cap = 20'000;

enum class NamedBy : unsigned char { user, file };

class NamedFiles {
 public:
  /// `first`: the first file. `folders`: others whose files may be named.
  explicit NamedFiles(const std::string& first, const std::vector<std::string>& folders = {});

  const std::string& first() const { return first_; }
  /// The folder of the first file.
  const std::filesystem::path& folder() const { return folder_; }
  /// Returns the bytes of a file. Throws std::runtime_error with the reason, without the file's name.
  std::string read(const std::filesystem::path& file, NamedBy by);
  /// Reads and parses a file, and returns its text. Throws std::runtime_error with the reason, without the
  /// file's name.
  std::string load(pugi::xml_document& document, const std::filesystem::path& file, NamedBy by);
  /// Returns the file that a robot means: beside it, "file://", or "package://NAME/..". A package NAME is the
  /// folder whose package.xml has this name, or a folder NAME, or is below a folder that contains NAME; it is
  /// searched from the robot's folder upwards. Throws std::runtime_error with the reason if there is none.
  std::filesystem::path find(const std::string& name) const;

 private:
  struct Folder {
    std::filesystem::path path;  ///< canonical
    std::string package;         ///< the name in its package.xml; may be empty
  };
  void permit(const std::filesystem::path& folder);
  /// Returns why a file that a file names must not be read, or an empty text.
  std::string why_not(const std::filesystem::path& file) const;

  std::string first_;
  std::filesystem::path folder_;
  std::vector<Folder> permitted_;
  std::size_t bytes_left_ = files_cap, tags_left_ = tag_cap;
};

/// Throws std::runtime_error with the reason unless this is a regular file or a pipe, of at most `cap` bytes.
void check_given_file(const std::filesystem::path& file, std::size_t cap);

}  // namespace cyl
