#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the solver as one header, without Eigen and without batches (docs/library-use.md)."""
import pathlib
import re

VECTOR = '''
struct Vector3 {
  double v[3];
  Vector3() : v{0, 0, 0} {}
  Vector3(double x, double y, double z) : v{x, y, z} {}
  double x() const { return v[0]; }
  double y() const { return v[1]; }
  double z() const { return v[2]; }
  double& operator[](int i) { return v[i]; }
  double operator[](int i) const { return v[i]; }
  double sum() const { return v[0] + v[1] + v[2]; }
  bool allFinite() const { return v[0] - v[0] == 0 && v[1] - v[1] == 0 && v[2] - v[2] == 0; }
  Vector3 cross(const Vector3& b) const {
    return {v[1] * b.v[2] - v[2] * b.v[1], v[2] * b.v[0] - v[0] * b.v[2], v[0] * b.v[1] - v[1] * b.v[0]};
  }
  Vector3 operator-() const { return {-v[0], -v[1], -v[2]}; }
  Vector3& operator+=(const Vector3& b) { return *this = {v[0] + b.v[0], v[1] + b.v[1], v[2] + b.v[2]}; }
  Vector3& operator-=(const Vector3& b) { return *this = {v[0] - b.v[0], v[1] - b.v[1], v[2] - b.v[2]}; }
  Vector3& operator*=(double s) { return *this = {v[0] * s, v[1] * s, v[2] * s}; }
  Vector3& operator/=(double s) { return *this = {v[0] / s, v[1] / s, v[2] / s}; }
  friend Vector3 operator+(Vector3 a, const Vector3& b) { return a += b; }
  friend Vector3 operator-(Vector3 a, const Vector3& b) { return a -= b; }
  friend Vector3 operator*(Vector3 a, double s) { return a *= s; }
  friend Vector3 operator*(double s, Vector3 a) { return a *= s; }
  friend Vector3 operator/(Vector3 a, double s) { return a /= s; }
  friend bool operator==(const Vector3& a, const Vector3& b) = default;
};
'''
ROOT = pathlib.Path(__file__).resolve().parent.parent
seen = set()


def text_of(path):
    """The file with the files that it includes, each of them once."""
    if path in seen:
        return ''
    seen.add(path)
    text = re.sub(r'#pragma once\n|#include <Eigen/.*\n|// SPDX.*\n', '', (ROOT / path).read_text())
    text = text.replace('using Vector3 = Eigen::Vector3d;\n', VECTOR)
    if path.endswith('.cpp'):  # two files may use one name in their unnamed namespaces
        own = f'in_{pathlib.Path(path).stem}'
        text = text.replace('\nnamespace {\n', f'\nnamespace {own} {{\n')
        text = text.replace('}  // namespace\n', f'}}\nusing namespace {own};\n')
    return re.sub(r'#include "(.*)"\n', lambda found: text_of(found[1]), text)


sources = [f'solver/{p.name}' for p in sorted((ROOT / 'solver').glob('*.cpp')) if not re.search('_test|batch', p.name)]
print('// SPDX-License-Identifier: MIT\n#pragma once\n' + text_of('solver/distance.hpp') + text_of('solver/decide.hpp'))
print('#ifdef DAYLIGHT_SOLVER_IMPLEMENTATION')
print(''.join(text_of(path) for path in [*sources, 'solver/detail/prove_with_slack.cpp']) + '#endif')
