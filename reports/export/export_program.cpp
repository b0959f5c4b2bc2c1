// SPDX-License-Identifier: MIT
#include "reports/export/export_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/adapter.hpp"
#include "reports/export/program_text.hpp"

namespace cyl {
namespace {

constexpr std::string_view fcl_flags = "$(pkg-config --cflags eigen3) -lfcl -lccd";
constexpr std::string_view bullet_flags = "$(pkg-config --cflags --libs bullet-float64)";
constexpr std::string_view ccd_flags = "$(pkg-config --cflags --libs ccd)";
constexpr std::string_view ode_flags = "$(pkg-config --cflags --libs ode)";
constexpr std::string_view mujoco_flags = "-lmujoco";

/// @a.radius@, @a.rotation@, ... of one solid.
void add_solid(Words& words, const std::string& name, const Cylinder& c) {
  const Vector3 axis = unit_axis(c.axis);
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = rotation_to(axis);
  words[name + ".radius"] = literal(c.radius);
  words[name + ".height"] = literal(c.height);
  words[name + ".half"] = literal(c.height / 2);
  words[name + ".center"] = listed(c.center.data(), 3);
  words[name + ".axis"] = listed(axis.data(), 3);
  words[name + ".rotation"] = listed(rows.data(), 9);
  words[name + ".rotation4"] = listed(rows.data(), 3) + ", 0, " + listed(rows.data() + 3, 3) + ", 0, " +
                               listed(rows.data() + 6, 3) + ", 0";
}

constexpr std::string_view fcl_solids =
    R"(  const fcl::Cylinderd a(@a.radius@, @a.height@), b(@b.radius@, @b.height@);  // radius, height
  fcl::Transform3d pose_a = fcl::Transform3d::Identity(), pose_b = pose_a;
  pose_a.linear() << @a.rotation@;  // the last column is the axis
  pose_a.translation() << @a.center@;
  pose_b.linear() << @b.rotation@;
  pose_b.translation() << @b.center@;
)";

constexpr std::string_view fcl_collide = R"(#include <fcl/config.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>

#include <cstdio>

int main() {
@solids@
  fcl::CollisionRequestd request;
  request.gjk_solver_type = fcl::@solver@;
  request.gjk_tolerance = @tolerance@;
  fcl::CollisionResultd result;
@before@  const bool meet = fcl::collide(&a, pose_a, &b, pose_b, request, result) > 0;

@after@}
)";

constexpr std::string_view fcl_distance = R"(#include <fcl/config.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/distance.h>

#include <cmath>
#include <cstdio>

int main() {
@solids@
  fcl::DistanceRequestd request;
  request.enable_nearest_points = true;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.distance_tolerance = @tolerance@;
  fcl::DistanceResultd result;
  for (fcl::Vector3d& point : result.nearest_points) point.setZero();
@before@  const double distance = fcl::distance(&a, pose_a, &b, pose_b, request, result);
  const bool meet = !(distance > 0);

@after@}
)";

constexpr std::string_view bullet_poses =
    R"(  static_assert(sizeof(btScalar) == 8, "link the double precision libraries");
  const btTransform pose_a(btMatrix3x3(@a.rotation@),  // the last column is the axis
                           btVector3(@a.center@));
  const btTransform pose_b(btMatrix3x3(@b.rotation@),
                           btVector3(@b.center@));
)";

constexpr std::string_view bullet_cylinders =
    R"(  btCylinderShapeZ a(btVector3(@a.radius@, @a.radius@, @a.half@));  // radius, radius, half the height
  btCylinderShapeZ b(btVector3(@b.radius@, @b.radius@, @b.half@));
)";

constexpr std::string_view bullet_margins = R"(  a.setMargin(0);
  b.setMargin(0);
)";

constexpr std::string_view bullet_hull = R"(
/// Prisms @around@ the cylinders: where these @prisms@, so do the cylinders.
static void fill(btConvexHullShape& hull, double radius, double half_height) {
  const int sides = @sides@;
  const double stretch = @stretch@;
  hull.setMargin(0);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * 3.141592653589793 * i / sides;
    const double x = radius * stretch * std::cos(angle), y = radius * stretch * std::sin(angle);
    hull.addPoint(btVector3(x, y, half_height), false);
    hull.addPoint(btVector3(x, y, -half_height), false);
  }
  hull.recalcLocalAabb();
}
)";

constexpr std::string_view bullet_hulls = R"(  btConvexHullShape a, b;
  fill(a, @a.radius@, @a.half@);
  fill(b, @b.radius@, @b.half@);
)";

constexpr std::string_view bullet_detector = R"(#include <BulletCollision/CollisionShapes/@header@>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <cmath>
#include <cstdio>

struct Contact final : btDiscreteCollisionDetectorInterface::Result {
  bool found = false;
  double distance = 0;
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3&, const btVector3&, btScalar d) override {
    found = true;
    distance = d;
  }
};
@fill@
int main() {
@poses@@shapes@@margins@
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(&a, &b, &simplex, &depth);
  btDiscreteCollisionDetectorInterface::ClosestPointInput input;
  input.m_transformA = pose_a;
  input.m_transformB = pose_b;
  Contact contact;
@before@  detector.getClosestPoints(input, contact, nullptr);
  const double distance = contact.distance;
  const bool meet = contact.found && !(distance > 0);

@after@}
)";

constexpr std::string_view bullet_gjkepa2 = R"(#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>

#include <cmath>
#include <cstdio>

int main() {
@poses@@shapes@@margins@
  btGjkEpaSolver2::sResults result;
  const btVector3 guess = pose_a.getOrigin() - pose_b.getOrigin();
@before@  const bool found = btGjkEpaSolver2::SignedDistance(&a, pose_a, &b, pose_b, guess, result);
  if (!found && result.status != btGjkEpaSolver2::sResults::EPA_Failed) {
    std::puts("Bullet says: GJK_Failed, which is no answer");
    return 0;
  }
  // EPA comes after GJK has found an overlap.
  const double distance = found ? result.distance : 0;
  const bool meet = !found || !(distance > 0);

@after@}
)";

constexpr std::string_view ccd = R"(#include <ccd/ccd.h>

#include <cmath>
#include <cstdio>

struct Cylinder {
  double center[3], axis[3], radius, half_height;
};

static double dot(const double* u, const double* v) { return u[0] * v[0] + (u[1] * v[1] + u[2] * v[2]); }

static void center(const void* object, ccd_vec3_t* point) {
  const Cylinder& c = *static_cast<const Cylinder*>(object);
  ccdVec3Set(point, c.center[0], c.center[1], c.center[2]);
}

// The farthest point along the direction; along the axis, the middle of a cap.
static void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Cylinder& c = *static_cast<const Cylinder*>(object);
  double d[3] = {direction->v[0], direction->v[1], direction->v[2]}, across[3];
  if (!(dot(d, d) > 0x1p-900 && dot(d, d) < 0x1p900)) {  // else squares vanish or overflow
    const double largest = std::fmax(std::fmax(std::fabs(d[0]), std::fabs(d[1])), std::fabs(d[2]));
    if (largest > 0 && std::isfinite(largest))
      for (double& x : d) x = std::scalbn(x, -std::ilogb(largest));
  }
  const double along = dot(d, c.axis);
  for (int i = 0; i < 3; ++i) across[i] = d[i] - along * c.axis[i];
  const double length = std::sqrt(dot(across, across));
  const bool is_along = !(dot(across, across) > 0x1p-100 * dot(d, d));  // but for rounding
  for (int i = 0; i < 3; ++i) {
    point->v[i] = c.center[i] + std::copysign(c.half_height, along) * c.axis[i];
    if (!is_along) point->v[i] += c.radius / length * across[i];
  }
}
@first_direction@
int main() {
  // centre, unit axis, radius, half the height
  const Cylinder a = {{@a.center@}, {@a.axis@}, @a.radius@, @a.half@};
  const Cylinder b = {{@b.center@}, {@b.axis@}, @b.radius@, @b.half@};

  ccd_t settings;
  CCD_INIT(&settings);
  settings.support1 = settings.support2 = support;
  settings.center1 = settings.center2 = center;
  settings.max_iterations = 500;
@settings@@before@  const bool meet = @call@(&a, &b, &settings) != 0;

@after@}
)";

constexpr std::string_view ccd_first_direction = R"(
static void from_center_to_center(const void* a, const void* b, ccd_vec3_t* direction) {
  ccd_vec3_t center_a, center_b;
  center(a, &center_a);
  center(b, &center_b);
  ccdVec3Sub2(direction, &center_b, &center_a);
  if (direction->v[0] == 0 && direction->v[1] == 0 && direction->v[2] == 0) ccdVec3Set(direction, 1, 0, 0);
}
)";

constexpr std::string_view ode = R"(#include <ode/ode.h>

#include <cstdio>

int main() {
  static_assert(sizeof(dReal) == 8, "a build in double precision");
  dInitODE2(0);
  dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
@before@  // radius, height; the last column of the rotation, beside ODE's padding, is the axis
  const dGeomID a = dCreateCylinder(nullptr, @a.radius@, @a.height@);
  const dMatrix3 rotation_a = {@a.rotation4@};
  dGeomSetRotation(a, rotation_a);
  dGeomSetPosition(a, @a.center@);
  const dGeomID b = dCreateCylinder(nullptr, @b.radius@, @b.height@);
  const dMatrix3 rotation_b = {@b.rotation4@};
  dGeomSetRotation(b, rotation_b);
  dGeomSetPosition(b, @b.center@);

  dContactGeom contacts[8];
  const bool meet = dCollide(a, b, @flags@, contacts, sizeof contacts[0]) > 0;

@after@}
)";

constexpr std::string_view mujoco = R"(#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

int main() {
  mju_user_error = [](const char* text) {
    std::fprintf(stderr, "%s\n", text);
    std::abort();
  };
  mju_user_warning = [](const char*) {};
  const char xml[] =
      "<mujoco><size nstack=\"1000\"/><worldbody><geom type=\"cylinder\" size=\"1 1\"/>"
      "<geom type=\"cylinder\" size=\"1 1\"/></worldbody></mujoco>";
  static mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "pair.xml", sizeof xml - 1);
  std::memcpy(files.filedata[mj_findFileVFS(&files, "pair.xml")], xml, sizeof xml - 1);
  char error[200] = "";
  mjModel* const model = mj_loadXML("pair.xml", &files, error, sizeof error);
  if (model == nullptr) return std::puts(error), 2;
  mjData* const data = mj_makeData(model);
  model->opt.mpr_tolerance = @tolerance@;
  model->opt.mpr_iterations = @iterations@;

  const mjtNum size[6] = {@a.radius@, @a.half@, 0, @b.radius@, @b.half@, 0};  // radius, half the height
  const mjtNum position[6] = {@a.center@, @b.center@};
  const mjtNum rotation[18] = {@a.rotation@,  // the last column is the axis
                               @b.rotation@};
  std::memcpy(model->geom_size, size, sizeof size);
  std::memcpy(data->geom_xpos, position, sizeof position);
  std::memcpy(data->geom_xmat, rotation, sizeof rotation);
  mjContact contacts[mjMAXCONPAIR];
@before@  const bool meet = mjCOLLISIONFUNC[mjGEOM_CYLINDER][mjGEOM_CYLINDER](model, data, contacts, 0, 1, 0) > 0;

@after@}
)";

/// Covers the roundings of cosine, quotient and product in a prism's vertex, as in the method.
constexpr std::string_view outward = "(1 + 0x1p-50) / std::cos(3.141592653589793 / sides)";
constexpr std::string_view inward = "1 - 0x1p-50";

constexpr std::string_view bullet_version = "btGetVersion() / 100, btGetVersion() % 100";

/// What stands for a @word@ of a program's text; it may hold earlier words, and those of the pair.
struct Setting {
  std::string_view word, text;
};

struct Program {
  LibraryCall call;
  std::string_view text;
  std::array<Setting, 7> settings;  ///< those without a word are none
};

constexpr std::array programs{
    Program{LibraryCall{"fcl-libccd", "FCL", "fcl::collide", "gjk_solver_type GST_LIBCCD, gjk_tolerance 1e-6",
                        fcl_flags, "libfcl-dev"},
            fcl_collide,
            {{{"version", "FCL_VERSION"},
              {"solver", "GST_LIBCCD"},
              {"tolerance", "1e-6"},
              {"solids", fcl_solids}}}},
    Program{LibraryCall{"fcl-libccd-tol1e-10", "FCL", "fcl::collide",
                        "gjk_solver_type GST_LIBCCD, gjk_tolerance 1e-10", fcl_flags, "libfcl-dev"},
            fcl_collide,
            {{{"version", "FCL_VERSION"},
              {"solver", "GST_LIBCCD"},
              {"tolerance", "1e-10"},
              {"solids", fcl_solids}}}},
    Program{LibraryCall{"fcl-indep", "FCL", "fcl::collide", "gjk_solver_type GST_INDEP, gjk_tolerance 1e-6",
                        fcl_flags, "libfcl-dev"},
            fcl_collide,
            {{{"version", "FCL_VERSION"},
              {"solver", "GST_INDEP"},
              {"tolerance", "1e-6"},
              {"solids", fcl_solids}}}},
    Program{LibraryCall{"fcl-distance-libccd", "FCL", "fcl::distance",
                        "gjk_solver_type GST_LIBCCD, distance_tolerance 1e-6, nearest points", fcl_flags,
                        "libfcl-dev"},
            fcl_distance,
            {{{"version", "FCL_VERSION"},
              {"solver", "GST_LIBCCD"},
              {"tolerance", "1e-6"},
              {"solids", fcl_solids}}}},
    Program{LibraryCall{"fcl-distance-libccd-tol1e-10", "FCL", "fcl::distance",
                        "gjk_solver_type GST_LIBCCD, distance_tolerance 1e-10, nearest points", fcl_flags,
                        "libfcl-dev"},
            fcl_distance,
            {{{"version", "FCL_VERSION"},
              {"solver", "GST_LIBCCD"},
              {"tolerance", "1e-10"},
              {"solids", fcl_solids}}}},
    Program{
        LibraryCall{"bullet-cylinder", "Bullet", "btGjkPairDetector",
                    "two btCylinderShapeZ with their default margin, btGjkEpaPenetrationDepthSolver, double "
                    "precision",
                    bullet_flags, "libbullet-dev"},
        bullet_detector,
        {{{"version", bullet_version},
          {"header", "btCylinderShape.h"},
          {"fill", ""},
          {"poses", bullet_poses},
          {"shapes", bullet_cylinders},
          {"margins", ""}}}},
    Program{LibraryCall{
                "bullet-cylinder-margin0", "Bullet", "btGjkPairDetector",
                "two btCylinderShapeZ with setMargin(0), btGjkEpaPenetrationDepthSolver, double precision",
                bullet_flags, "libbullet-dev"},
            bullet_detector,
            {{{"version", bullet_version},
              {"header", "btCylinderShape.h"},
              {"fill", ""},
              {"poses", bullet_poses},
              {"shapes", bullet_cylinders},
              {"margins", bullet_margins}}}},
    Program{LibraryCall{"bullet-gjkepa2", "Bullet", "btGjkEpaSolver2::SignedDistance",
                        "two btCylinderShapeZ with setMargin(0), double precision", bullet_flags,
                        "libbullet-dev"},
            bullet_gjkepa2,
            {{{"version", bullet_version},
              {"poses", bullet_poses},
              {"shapes", bullet_cylinders},
              {"margins", bullet_margins}}}},
    Program{
        LibraryCall{"bullet-hull-16", "Bullet", "btGjkPairDetector",
                    "two btConvexHullShape with 16 sides and setMargin(0), btGjkEpaPenetrationDepthSolver, "
                    "double precision",
                    bullet_flags, "libbullet-dev"},
        bullet_detector,
        {{{"version", bullet_version},
          {"header", "btConvexHullShape.h"},
          {"sides", "16"},
          {"fill", bullet_hull},
          {"poses", bullet_poses},
          {"shapes", bullet_hulls},
          {"margins", ""}}}},
    Program{
        LibraryCall{"bullet-hull-64", "Bullet", "btGjkPairDetector",
                    "two btConvexHullShape with 64 sides and setMargin(0), btGjkEpaPenetrationDepthSolver, "
                    "double precision",
                    bullet_flags, "libbullet-dev"},
        bullet_detector,
        {{{"version", bullet_version},
          {"header", "btConvexHullShape.h"},
          {"sides", "64"},
          {"fill", bullet_hull},
          {"poses", bullet_poses},
          {"shapes", bullet_hulls},
          {"margins", ""}}}},
    Program{
        LibraryCall{"libccd-gjk", "libccd", "ccdGJKIntersect",
                    "max_iterations 500, the default first direction", ccd_flags, "libccd-dev"},
        ccd,
        {{{"version", "version"}, {"call", "ccdGJKIntersect"}, {"first_direction", ""}, {"settings", ""}}}},
    Program{
        LibraryCall{"libccd-gjk-centers", "libccd", "ccdGJKIntersect",
                    "max_iterations 500, the first direction from centre to centre", ccd_flags, "libccd-dev"},
        ccd,
        {{{"version", "version"},
          {"call", "ccdGJKIntersect"},
          {"first_direction", ccd_first_direction},
          {"settings", "  settings.first_dir = from_center_to_center;\n"}}}},
    Program{LibraryCall{"libccd-mpr", "libccd", "ccdMPRIntersect", "max_iterations 500, mpr_tolerance 1e-4",
                        ccd_flags, "libccd-dev"},
            ccd,
            {{{"version", "version"},
              {"call", "ccdMPRIntersect"},
              {"first_direction", ""},
              {"settings", "  settings.mpr_tolerance = 1e-4;\n"}}}},
    Program{LibraryCall{"libccd-mpr-tol1e-10", "libccd", "ccdMPRIntersect",
                        "max_iterations 500, mpr_tolerance 1e-10", ccd_flags, "libccd-dev"},
            ccd,
            {{{"version", "version"},
              {"call", "ccdMPRIntersect"},
              {"first_direction", ""},
              {"settings", "  settings.mpr_tolerance = 1e-10;\n"}}}},
    Program{LibraryCall{"ode", "ODE", "dCollide", "one contact", ode_flags, "libode-dev"},
            ode,
            {{{"version", "dODE_VERSION"}, {"flags", "1"}}}},
    Program{LibraryCall{"ode-unrefined", "ODE", "dCollide", "one contact, CONTACTS_UNIMPORTANT", ode_flags,
                        "libode-dev"},
            ode,
            {{{"version", "dODE_VERSION"}, {"flags", "static_cast<int>(1 | CONTACTS_UNIMPORTANT)"}}}},
    Program{LibraryCall{"ode-contacts-8", "ODE", "dCollide", "eight contacts", ode_flags, "libode-dev"},
            ode,
            {{{"version", "dODE_VERSION"}, {"flags", "8"}}}},
    Program{LibraryCall{"mujoco", "MuJoCo", "mjCOLLISIONFUNC[mjGEOM_CYLINDER][mjGEOM_CYLINDER]",
                        "mpr_tolerance 1e-6, mpr_iterations 50", mujoco_flags, "libmujoco-dev"},
            mujoco,
            {{{"version", "mj_versionString()"}, {"tolerance", "1e-6"}, {"iterations", "50"}}}},
    Program{LibraryCall{"mujoco-tol1e-10", "MuJoCo", "mjCOLLISIONFUNC[mjGEOM_CYLINDER][mjGEOM_CYLINDER]",
                        "mpr_tolerance 1e-10, mpr_iterations 500", mujoco_flags, "libmujoco-dev"},
            mujoco,
            {{{"version", "mj_versionString()"}, {"tolerance", "1e-10"}, {"iterations", "500"}}}},
};

const Program* find_program(std::string_view method) {
  const auto* found = std::find_if(programs.begin(), programs.end(),
                                   [&](const Program& p) { return p.call.method == method; });
  return found == programs.end() ? nullptr : found;
}

std::string truth_line(const Trial& asked) {
  std::string text = fmt::format("{} (python3 exact.py proves it)", to_string(asked.truth.verdict));
  if (asked.truth.verdict != Verdict::touching)
    text += fmt::format(", signed distance {} to {}", format_double(asked.distance.lo),
                        format_double(asked.distance.hi));
  return text;
}

/// What stands after the call: prints and judges the answer.
std::string verdict_on(const LibraryCall& call, const Words& words, const Trial& asked,
                       const Method& method) {
  const FindingKind kind = asked.finding()->kind;
  std::string text;
  // The headers of libccd do not tell its version.
  if (call.library == "libccd") text = fmt::format("  const char version[] = \"{}\";\n", method.version());
  const auto says = [&](const std::string& format, const std::string& values) {
    text += fmt::format("  std::printf(\"{} {} says: {}\\n\", {}, {});\n", call.library,
                        call.library == "Bullet" ? "%d.%d" : "%s", format, words.at("version"), values);
  };
  const auto is_true = [&] { text += fmt::format("  std::puts(\"true is: {}\");\n", truth_line(asked)); };
  const auto judge_by = [&](const std::string& wrong) {
    text += fmt::format("  const bool wrong = {};\n", wrong);
    text += "  std::puts(wrong ? \"WRONG\" : \"right\");\n  return wrong ? 1 : 0;\n";
  };
  if (call.call == "fcl::distance" && (kind == FindingKind::non_finite || kind == FindingKind::bad_witness))
    text += "  const fcl::Vector3d between = result.nearest_points[1] - result.nearest_points[0];\n";
  const std::string said = "meet ? \"intersecting\" : \"disjoint\"";
  switch (kind) {
    case FindingKind::distance_outside:
      says("%s, distance %.17g", said + ", distance");
      is_true();
      text += fmt::format("  const double tolerance = {};\n", literal(method.claim().absolute));
      judge_by(fmt::format("!(distance >= {} - tolerance && distance <= {} + tolerance)",
                           literal(asked.distance.lo), literal(asked.distance.hi)));
      break;
    case FindingKind::non_finite:
      text += fmt::format("  const bool finite = std::isfinite(distance){};\n",
                          call.library == "FCL" ? " && between.allFinite()" : "");
      says("%s, distance %.17g%s",
           said + ", distance, finite ? \"\" : \"; not all that it tells is finite\"");
      is_true();
      judge_by("!finite");
      break;
    case FindingKind::bad_witness:
      says("%s, distance %.17g, nearest points (%.17g, %.17g, %.17g) apart",
           said + ", distance, between[0], between[1], between[2]");
      is_true();
      text += fmt::format(
          "  // The direction that exact.py shows not to separate them.\n"
          "  const fcl::Vector3d shown({});\n",
          listed(asked.answer().head, 3));
      judge_by("between == shown");
      break;
    case FindingKind::exception:
    case FindingKind::crash:
    case FindingKind::hang:
      says("%s", said);
      is_true();
      text += "  return 0;\n";
      break;
    default:
      says("%s", said);
      is_true();
      judge_by(asked.truth.verdict == Verdict::disjoint ? "meet" : "!meet");
  }
  return text;
}

std::string announcement(FindingKind kind) {
  switch (kind) {
    case FindingKind::exception:
      return "  std::puts(\"asking; this throws\");\n  std::fflush(stdout);\n";
    case FindingKind::crash:
      return "  std::puts(\"asking; this aborts\");\n  std::fflush(stdout);\n";
    case FindingKind::hang:
      return "  std::puts(\"asking; this does not come back\");\n  std::fflush(stdout);\n";
    default:
      return "";
  }
}

}  // namespace

const LibraryCall* find_library_call(std::string_view method) {
  const Program* program = find_program(method);
  return program == nullptr ? nullptr : &program->call;
}

bool program_shows(FindingKind kind) {
  switch (kind) {
    case FindingKind::wrong_disjoint:
    case FindingKind::wrong_intersecting:
    case FindingKind::bad_witness:
    case FindingKind::distance_outside:
    case FindingKind::non_finite:
    case FindingKind::exception:
    case FindingKind::crash:
    case FindingKind::hang:
      return true;
    default:
      return false;
  }
}

Pair as_given(const Pair& pair) {
  Pair given = pair;
  given.a.axis = unit_axis(pair.a.axis);
  given.b.axis = unit_axis(pair.b.axis);
  return given;
}

std::string reproducing_program(const LibraryCall& call, const Trial& asked, const Method& method) {
  Words words;
  add_solid(words, "a", asked.pair.a);
  add_solid(words, "b", asked.pair.b);
  const bool misses = asked.answer().verdict == Verdict::disjoint;
  words["stretch"] = misses ? outward : inward;
  words["around"] = misses ? "around" : "within";
  words["prisms"] = misses ? "are apart" : "meet";
  const Program& program = *find_program(call.method);
  for (const Setting& setting : program.settings)
    if (!setting.word.empty()) words[std::string(setting.word)] = filled(setting.text, words);
  words["before"] = announcement(asked.finding()->kind);
  words["after"] = verdict_on(call, words, asked, method);
  return fmt::format("// Asks {} ({}) about two cylinders: {}.\n// c++ {} reproduce.cpp -o reproduce {}\n",
                     call.library, call.call, call.settings, compiler_options, call.flags) +
         filled(program.text, words);
}

}  // namespace cyl
