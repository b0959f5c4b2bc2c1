// SPDX-License-Identifier: MIT
#include "scenes/read/mjcf_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <stdexcept>

#include "scenes/read/number_list.hpp"

namespace cyl {
namespace {

/// The most files that one scene includes, and the most in each other. A file may count twice. The content of
/// a file is copied into each file around it.
constexpr std::size_t include_cap = 1000, include_depth_cap = 50;
/// The most values in all classes of defaults: a class holds those of all classes around it.
constexpr std::size_t default_cap = 1'000'000;
constexpr const char* main_class = "main";

}  // namespace

Eigen::Quaterniond turn_from_z(const Vector3& to) {
  const Vector3 direction = to.normalized(), axis = Vector3::UnitZ().cross(direction);
  const double sine = axis.norm();
  return Eigen::Quaterniond(
      Eigen::AngleAxisd(std::atan2(sine, direction.z()), sine > 0 ? Vector3(axis / sine) : Vector3::UnitX()));
}

MjcfDocument::MjcfDocument(NamedFiles& files) : files_(files) {
  files_.load(document_, files_.first(), NamedBy::user);
  root_ = document_.child("mujoco");
  if (!root_) throw std::runtime_error("no <mujoco>");
  include(root_, files_.folder(), 1);
  set_compiler();
  classes_[main_class];
  for (const pugi::xml_node& node : sections("default")) {
    read_class(node, main_class, classes_[main_class]);
    classes_[node.attribute("class").as_string(main_class)] = classes_[main_class];
  }
}

void MjcfDocument::include(pugi::xml_node parent, const std::filesystem::path& folder, int depth) {
  if (depth > depth_cap)
    throw std::runtime_error(
        fmt::format("with its includes, elements are nested more than {} deep", depth_cap));
  for (pugi::xml_node next, child = parent.first_child(); child; child = next) {
    next = child.next_sibling();
    if (std::strcmp(child.name(), "include") != 0) {
      include(child, folder, depth + 1);
      continue;
    }
    const std::string name = child.attribute("file").as_string();
    std::filesystem::path path = files_.folder() / name;  // of the first file, as in MuJoCo
    if (!std::filesystem::exists(path)) path = folder / name;
    std::error_code none;
    const std::filesystem::path real = std::filesystem::weakly_canonical(path, none);
    if (std::ranges::find(open_, real) != open_.end())
      throw std::runtime_error("files include each other in a circle");
    if (++included_ > include_cap || open_.size() >= include_depth_cap)
      throw std::runtime_error(fmt::format("more than {} files are included, or more than {} in each other",
                                           include_cap, include_depth_cap));
    pugi::xml_document other;
    try {
      files_.load(other, path, NamedBy::file);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(path.string() + ": " + error.what());
    }
    open_.push_back(real);
    include(other.document_element(), path.parent_path(), depth);
    open_.pop_back();
    for (const pugi::xml_node& node : other.document_element().children())
      parent.insert_copy_before(node, child);
    parent.remove_child(child);
  }
}

void MjcfDocument::set_compiler() {
  for (const pugi::xml_node& node : sections("compiler")) {
    const auto set = [&](const char* name, std::string& value) {
      if (const pugi::xml_attribute given = node.attribute(name)) value = given.value();
    };
    std::string angle = degrees_ ? "degree" : "radian", limits = autolimits_ ? "true" : "false", coordinate,
                strip = strippath_ ? "true" : "false";
    set("angle", angle);
    set("autolimits", limits);
    set("eulerseq", eulerseq_);
    set("assetdir", meshdir_);
    set("meshdir", meshdir_);
    set("coordinate", coordinate);
    set("strippath", strip);
    strippath_ = strip == "true";
    degrees_ = angle != "radian";
    autolimits_ = limits != "false";
    if (coordinate == "global") throw std::runtime_error("global coordinates, which MuJoCo gave up too");
  }
  for (const pugi::xml_node& flag : entries("option", "flag")) {
    const auto is_off = [&](const char* name, bool before) {
      return std::string(flag.attribute(name).as_string(before ? "enable" : "disable")) == "disable";
    };
    const bool none = is_off("constraint", true);
    limits_ = !none && !is_off("limit", limits_);
    equalities_ = !none && !is_off("equality", equalities_);
    filters_parents_ = !is_off("filterparent", filters_parents_);
  }
  if (eulerseq_.size() != 3 || eulerseq_.find_first_not_of("xyzXYZ") != eulerseq_.npos)
    throw std::runtime_error("eulerseq is '" + eulerseq_ + "'");
}

// A class inherits the values of the class around it and overrides those that it gives itself.
void MjcfDocument::read_class(pugi::xml_node node, const std::string& name, Defaults given) {
  for (const pugi::xml_node& child : node.children())
    for (const pugi::xml_attribute& attribute : child.attributes())
      if (std::strcmp(child.name(), "default") != 0)
        given[child.name()][attribute.name()] = attribute.value();
  for (const auto& [element, values] : given) defaults_ += values.size();
  if (defaults_ > default_cap)
    throw std::runtime_error(fmt::format("the classes of defaults have more than {} values", default_cap));
  classes_[name] = given;
  for (const pugi::xml_node& child : node.children("default"))
    read_class(child, child.attribute("class").as_string(), given);
}

std::vector<pugi::xml_node> MjcfDocument::sections(const std::string& name) const {
  const auto all = root_.children(name.c_str());
  return {all.begin(), all.end()};
}

std::vector<pugi::xml_node> MjcfDocument::entries(const std::string& section, const std::string& name) const {
  std::vector<pugi::xml_node> found;
  for (const pugi::xml_node& node : sections(section))
    for (const pugi::xml_node& child : node.children(name.c_str())) found.push_back(child);
  return found;
}

std::string MjcfDocument::read_file(const std::string& file) const {
  const std::filesystem::path path =
      strippath_ ? std::filesystem::path(file).filename() : std::filesystem::path(file);
  return files_.read(files_.folder() / meshdir_ / path, NamedBy::file);
}

double MjcfDocument::angle(double value) const { return degrees_ ? value * std::numbers::pi / 180 : value; }

const std::map<std::string, std::string>* MjcfDocument::defaults(const std::string& of_class,
                                                                 const std::string& element) const {
  const auto given = classes_.find(of_class.empty() ? main_class : of_class);
  if (given == classes_.end()) throw std::runtime_error("no class '" + of_class + "'");
  const auto attributes = given->second.find(element);
  return attributes == given->second.end() ? nullptr : &attributes->second;
}

MjcfElement::MjcfElement(const MjcfDocument& document, pugi::xml_node node, const std::string& childclass)
    : document_(document),
      node_(node),
      given_(document.defaults(node.attribute("class").as_string(childclass.c_str()), node.name())) {}

std::string MjcfElement::text(const char* name, const std::string& otherwise) const {
  if (const pugi::xml_attribute own = node_.attribute(name)) return own.value();
  if (!given_) return otherwise;
  const auto found = given_->find(name);
  return found == given_->end() ? otherwise : found->second;
}

bool MjcfElement::has(const char* name, bool own) const {
  return own ? !node_.attribute(name).empty() : !text(name).empty();
}

std::vector<double> MjcfElement::numbers(const char* name) const {
  return parse_numbers(text(name),
                       std::string(node_.name()) + " " + node_.attribute("name").as_string() + ": " + name);
}

Vector3 MjcfElement::vector(const char* name, const Vector3& otherwise) const {
  const std::vector<double> x = numbers(name);
  if (x.empty()) return otherwise;
  if (x.size() != 3) throw std::runtime_error(std::string(name) + " is '" + text(name) + "', not 3 numbers");
  return {x[0], x[1], x[2]};
}

Eigen::Quaterniond MjcfElement::turn(bool own) const {
  const auto of = [&](const char* name, std::size_t count) {
    std::vector<double> x = has(name, own) ? numbers(name) : std::vector<double>();
    if (!x.empty() && x.size() != count)
      throw std::runtime_error(std::string(name) + " is '" + text(name) + "', not " + std::to_string(count) +
                               " numbers");
    return x;
  };
  if (const auto x = of("axisangle", 4); !x.empty())
    return Eigen::Quaterniond(
        Eigen::AngleAxisd(document_.angle(x[3]), Vector3(x[0], x[1], x[2]).normalized()));
  if (const auto x = of("xyaxes", 6); !x.empty()) {
    Eigen::Matrix3d m;
    m.col(0) = Vector3(x[0], x[1], x[2]).normalized();
    const Vector3 y(x[3], x[4], x[5]);
    m.col(1) = (y - y.dot(m.col(0)) * m.col(0)).normalized();
    m.col(2) = m.col(0).cross(m.col(1));
    return Eigen::Quaterniond(m);
  }
  if (const auto x = of("zaxis", 3); !x.empty()) return turn_from_z({x[0], x[1], x[2]});
  if (const auto x = of("euler", 3); !x.empty()) {
    Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
    for (std::size_t i = 0; i < 3; ++i) {
      const char letter = document_.eulerseq()[i];
      const bool turning = letter >= 'x';  // about axes that turn along, else about fixed axes
      const Eigen::Quaterniond step(
          Eigen::AngleAxisd(document_.angle(x[i]), Vector3::Unit(letter - (turning ? 'x' : 'X'))));
      q = turning ? q * step : step * q;
    }
    return q;
  }
  const auto x = of("quat", 4);
  if (x.empty()) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(x[0], x[1], x[2], x[3]).normalized();
}

Pose MjcfElement::pose() const {
  bool own = false;
  for (const char* name : {"quat", "axisangle", "xyaxes", "zaxis", "euler"}) own |= has(name, true);
  // If two kinds of orientation are given, versions of MuJoCo differ in which one they take.
  for (const char* name : {"axisangle", "xyaxes", "zaxis", "euler"})
    if (own && given_ && given_->contains(name) && !has(name, true))
      throw std::runtime_error(std::string(node_.name()) + " " + node_.attribute("name").as_string() +
                               " is turned in one way, and by its class in another (" + name +
                               "): give it one of them");
  return Pose(Eigen::Translation3d(vector("pos", Vector3::Zero())) * turn(own));
}

}  // namespace cyl
