#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# amalgamate_test.sh BUILD_FOLDER COMPILER: one program with the one header and with the solver itself has to print the
# same answers, digit by digit.
set -eu
source=$(cd "$(dirname "$0")/.." && pwd) build=$(realpath "$1") folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$source/solver/amalgamate.py" >daylight.hpp
! grep Eigen daylight.hpp
cat >probe.cpp <<'END'
#include HEADER
#include <cstdio>
unsigned long long state = 1;
double next() {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return double(state >> 40) / (1 << 23) - 1;
}
double size() { const double x = next(); return x < -0.5 ? 0 : x * x; }
cyl::Solid draw(int kind) {
  cyl::Solid c;
  c.center = {next(), next(), next()};
  c.axis = {next(), next(), next()};
  if (kind == 0) c.shape = cyl::Shape::half_space;
  if (kind == 1) c.shape = cyl::Shape::box, c.edges = {size(), size(), size()}, c.quaternion = {next(), next(), next(), next()};
  if (kind > 1) c.radius = kind > 2 ? size() : 0, c.height = size();
  if (kind > 0) c.rounding = size();
  return c;
}
int main() {
  for (int i = 0; i < 40000; ++i) {
    const cyl::Solid a = draw(i % 4), b = draw(1 + i / 4 % 3);
    const cyl::Answer p = cyl::decide(a, b);
    const cyl::Distance d = cyl::distance(a, b);
    std::printf("%s %s %a %a %a %a\n", to_string(cyl::intersect(a, b)), to_string(p.verdict), p.direction[0],
                p.point_tail[2], d.value, d.on_b[1]);
  }
}
END
flags="-std=c++20 -O1 -ffp-contract=off"
$2 $flags -DHEADER='"daylight.hpp"' -DDAYLIGHT_SOLVER_IMPLEMENTATION probe.cpp -o one
$2 $flags -DHEADER='"solver/distance.hpp"' -I"$source" -isystem /usr/include/eigen3 probe.cpp "$build/libdaylight_solver.a" -o whole
./one >one.out && ./whole >whole.out
cmp one.out whole.out
