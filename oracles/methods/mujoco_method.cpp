// SPDX-License-Identifier: MIT
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {
namespace {

static_assert(sizeof(mjtNum) == 8);

/// Values of mpr_tolerance, a length, and the number of steps for each: MuJoCo's defaults, and values for
/// users who need more precision.
constexpr double default_tol = 1e-6, fine_tol = 1e-10;
constexpr int default_cap = 50, fine_cap = 500;

/// The default handlers also write MUJOCO_LOG.TXT into the working folder.
void install_handlers() {
  mju_user_error = [](const char* text) {
    std::fprintf(stderr, "%s\n", text);
    std::abort();
  };
  mju_user_warning = [](const char*) {};
}

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

/// Makes two cylinders. Their sizes and poses are set for each pair. Throws std::runtime_error.
std::unique_ptr<mjModel, DeleteModel> make_model() {
  constexpr char file[] = "pair.xml";
  const std::string text =
      "<mujoco><size nstack=\"1000\"/><worldbody><geom type=\"cylinder\" size=\"1 1\"/>"
      "<geom type=\"cylinder\" size=\"1 1\"/></worldbody></mujoco>";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), file, static_cast<int>(text.size()));
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), file)], text.data(), text.size());
  char error[200] = "";
  std::unique_ptr<mjModel, DeleteModel> model(mj_loadXML(file, files.get(), error, sizeof error));
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(std::string("MuJoCo: ") + error);
  return model;
}

/// A solid as MuJoCo keeps it.
class MujocoSolid {
 public:
  explicit MujocoSolid(const Solid& c) : position_(c.center), rotation_(rotation_of(c)) {
    switch (kind_of(c)) {
      case SolidKind::sphere:
        type_ = mjGEOM_SPHERE;
        size_ = {c.rounding, 0, 0};
        return;
      case SolidKind::capsule:
        type_ = mjGEOM_CAPSULE;
        size_ = {c.rounding, c.height / 2, 0};
        return;
      case SolidKind::half_space:
        type_ = mjGEOM_PLANE;
        size_ = {0, 0, 0};  // infinite
        return;
      case SolidKind::box:
        type_ = mjGEOM_BOX;
        size_ = {c.edges[0] / 2, c.edges[1] / 2, c.edges[2] / 2};
        return;
      case SolidKind::cylinder:
      case SolidKind::rounded:
      case SolidKind::rounded_box:
        type_ = mjGEOM_CYLINDER;
        size_ = {c.radius, c.height / 2, 0};
    }
  }

  int type() const { return type_; }

  void write_to(mjModel& model, mjData& data, int geom) const {
    model.geom_type[geom] = type_;
    std::copy_n(size_.data(), 3, model.geom_size + 3 * geom);
    std::copy_n(position_.data(), 3, data.geom_xpos + 3 * geom);
    std::copy_n(rotation_.data(), 9, data.geom_xmat + 9 * geom);
  }

 private:
  int type_;
  Vector3 size_, position_;
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rotation_;
};

/// MuJoCo's collider of two kinds. It leaves out the other parts of mj_collision, which search for near
/// pairs and prepare data for the solver of contacts.
class Collider {
 public:
  Collider(double tolerance, int iterations) {
    install_handlers();
    model_ = make_model();
    data_.reset(mj_makeData(model_.get()));
    if (!data_) throw std::runtime_error("MuJoCo makes no mjData");
    model_->opt.mpr_tolerance = tolerance;
    model_->opt.mpr_iterations = iterations;
  }

  Verdict collide(const MujocoSolid& a, const MujocoSolid& b) {
    if (a.type() > b.type()) return collide(b, a);  // MuJoCo's table has the lesser type first
    a.write_to(*model_, *data_, 0);
    b.write_to(*model_, *data_, 1);
    mjContact contacts[mjMAXCONPAIR];
    const mjfCollision collider = mjCOLLISIONFUNC[a.type()][b.type()];
    const int count = collider(model_.get(), data_.get(), contacts, 0, 1, /*margin*/ 0);
    return count > 0 ? Verdict::intersecting : Verdict::disjoint;
  }

 private:
  std::unique_ptr<mjModel, DeleteModel> model_;
  std::unique_ptr<mjData, DeleteData> data_;
};

/// Returns whether the collider makes a contact. It is not used for distances. With a margin, it returns the
/// depth of the grown solids along one direction that MPR finds. That is up to half off on plain pairs.
class Mujoco final : public VerdictMethod<MujocoSolid> {
 public:
  Mujoco(MethodName name, double tolerance, int iterations)
      : VerdictMethod(std::move(name)), tolerance_(tolerance), collider_(tolerance, iterations) {}
  std::string_view version() const override { return mj_versionString(); }
  bool supports(SolidKind kind) const override {
    return kind != SolidKind::rounded && kind != SolidKind::rounded_box;
  }
  Claim claim() const override {
    return {.absolute = tolerance_, .source = "mujoco/mjmodel.h: mpr_tolerance, MPR solver tolerance"};
  }

  MethodAnswer answer(const Pair& pair) override {
    for (const Solid* c : {&pair.a, &pair.b}) {
      const bool zero = is_box(*c) ? *std::ranges::min_element(c->edges) / 2 == 0
                                   : c->rounding == 0 && (c->radius == 0 || c->height / 2 == 0);
      if (zero && !is_half_space(*c))
        return declined_answer("a length is 0: MuJoCo's model compiler says that sizes must be positive");
    }
    return VerdictMethod::answer(pair);
  }

 private:
  Verdict collide(const MujocoSolid& a, const MujocoSolid& b) override { return collider_.collide(a, b); }

  const double tolerance_;
  Collider collider_;
};

}  // namespace

std::vector<std::unique_ptr<Method>> mujoco_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Mujoco>(MethodName{"mujoco"}, default_tol, default_cap));
  methods.push_back(std::make_unique<Mujoco>(MethodName{"mujoco", "", "tol1e-10"}, fine_tol, fine_cap));
  return methods;
}

std::vector<std::unique_ptr<Method>> mujoco_settings() {
  std::vector<std::unique_ptr<Method>> methods;
  for (const auto& [setting, tolerance, cap] :
       {std::tuple("tol1e-4", 1e-4, default_cap), std::tuple("tol1e-8", 1e-8, fine_cap),
        std::tuple("tol1e-12", 1e-12, fine_cap)})
    methods.push_back(std::make_unique<Mujoco>(MethodName{"mujoco", "", setting}, tolerance, cap));
  return methods;
}

}  // namespace cyl
