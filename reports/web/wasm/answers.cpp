// SPDX-License-Identifier: MIT
#include "reports/web/wasm/answers.hpp"

#include "solver/decide.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

Prepared solid_of(const double* x) noexcept {
  return prepare(Cylinder{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6], x[7], x[8]});
}

class Row {
 public:
  explicit Row(double* next) noexcept : next_(next) {}
  template <class Enum>
  void put(Enum value) noexcept {
    *next_++ = static_cast<double>(value);
  }
  void put(const Vector3& v) noexcept {
    for (int i = 0; i < 3; ++i) put(v[i]);
  }

 private:
  double* next_;
};

}  // namespace

void answer_all(const double* question, double* answers) noexcept {
  const Prepared a = solid_of(question), b = solid_of(question + question_size / 2);
  const Answer decided = decide(a, b);
  const Distance measured = distance(a, b);
  Row row(answers);
  row.put(intersect(a, b));
  row.put(decided.verdict);
  row.put(decided.proof);
  row.put(decided.hull_a);
  row.put(decided.hull_b);
  row.put(decided.iterations);
  row.put(decided.direction);
  row.put(decided.point_head);
  row.put(decided.point_tail);
  row.put(measured.verdict);
  row.put(measured.value);
  row.put(measured.error);
  row.put(measured.least);
  row.put(measured.iterations);
  row.put(measured.direction);
  row.put(measured.on_a);
  row.put(measured.on_b);
}

}  // namespace cyl
