// SPDX-License-Identifier: MIT
// An MJCF file as XML, with its includes, the settings of its compiler, and its classes of defaults. It reads
// leniently: parts that it does not need may be of any version of MuJoCo.
#pragma once

#include <filesystem>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "scenes/read/named_files.hpp"
#include "scenes/scene.hpp"

namespace cyl {

class MjcfDocument;

/// An element with what its class gives it.
class MjcfElement {
 public:
  /// `childclass` is that of the body around it.
  MjcfElement(const MjcfDocument& document, pugi::xml_node node, const std::string& childclass);
  /// Returns an attribute of the element, else of its class, else `otherwise`.
  std::string text(const char* name, const std::string& otherwise = "") const;
  /// Returns the numbers of an attribute, or none if it is missing. Throws std::runtime_error if one is not a
  /// number.
  std::vector<double> numbers(const char* name) const;
  Vector3 vector(const char* name, const Vector3& otherwise) const;
  /// Returns pos and the rotation: quat, axisangle, xyaxes, zaxis or euler.
  Pose pose() const;
  const pugi::xml_node& node() const { return node_; }

 private:
  bool has(const char* name, bool own) const;
  Eigen::Quaterniond turn(bool own) const;

  const MjcfDocument& document_;
  pugi::xml_node node_;
  const std::map<std::string, std::string>* given_ = nullptr;  ///< by its class
};

class MjcfDocument {
 public:
  /// Throws std::runtime_error without the file's name.
  explicit MjcfDocument(NamedFiles& files);

  /// The elements of a name below <mujoco>, and below those of a section.
  std::vector<pugi::xml_node> sections(const std::string& name) const;
  std::vector<pugi::xml_node> entries(const std::string& section, const std::string& name) const;
  /// Returns the bytes of a mesh, which is below the folder that the compiler names.
  std::string read_file(const std::string& file) const;
  /// Returns what a number in the file is in rad.
  double angle(double value) const;

  pugi::xml_node root() const { return root_; }
  bool autolimits() const { return autolimits_; }
  bool limits() const { return limits_; }                    ///< whether joints keep within their ranges
  bool equalities() const { return equalities_; }            ///< whether equalities hold
  bool filters_parents() const { return filters_parents_; }  ///< whether a body and what it carries pass
  const std::string& eulerseq() const { return eulerseq_; }
  /// Returns the defaults of a class for elements of a name, or nullptr.
  const std::map<std::string, std::string>* defaults(const std::string& of_class,
                                                     const std::string& element) const;

 private:
  using Defaults = std::map<std::string, std::map<std::string, std::string>>;  // element, attribute: value
  void include(pugi::xml_node parent, const std::filesystem::path& folder, int depth);
  void read_class(pugi::xml_node node, const std::string& name, Defaults given);
  void set_compiler();

  NamedFiles& files_;
  pugi::xml_document document_;
  pugi::xml_node root_;
  std::string meshdir_, eulerseq_ = "xyz";
  bool degrees_ = true, autolimits_ = true, strippath_ = false, limits_ = true, equalities_ = true,
       filters_parents_ = true;
  std::vector<std::filesystem::path> open_;  ///< included files that include this one
  std::size_t included_ = 0, defaults_ = 0;
  std::map<std::string, Defaults> classes_;
};

/// Returns the quaternion that turns z to a direction the shortest way.
Eigen::Quaterniond turn_from_z(const Vector3& to);

}  // namespace cyl
