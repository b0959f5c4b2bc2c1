#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The smoke vectors in GoogleTest, doctest, Catch2 and Boost.Test, with functions that are right and wrong. $1: the compiler.
set -euo pipefail

here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
cd -- "$scratch"
fail() {
  head -c 2000 out
  echo "FAILED: $*"
  exit 1
}

cat >functions.cpp <<'END_OF_FILE'
#include <cstdlib>
#include <cstring>
#include "daylight_vectors.hpp"
static const DaylightVector* of(const double* a, const double* b) {
  for (const DaylightVector& v : daylight_vectors)
    if (std::memcmp(v.a, a, sizeof v.a) == 0 && std::memcmp(v.b, b, sizeof v.b) == 0) return &v;
  return nullptr;
}
daylight_v1::Said collide(const double a[9], const double b[9]) {
  const DaylightVector& v = *of(a, b);
  const char* how = std::getenv("HOW");
  if (std::strcmp(how, "declines") == 0) return {};
  if (std::strcmp(how, "blind") == 0 && a[8] > 0) return daylight_v1::Said::verdict(false);
  if (std::strcmp(how, "short") == 0 && v.low > 0) return daylight_v1::Said::of_distance(v.low / 2);
  return a[6] > 1 ? daylight_v1::Said::of_distance((v.low + v.high) / 2) : daylight_v1::Said::verdict(v.result >= 0);
}
END_OF_FILE
flags=(-std=c++17 -Wall -Wextra -Werror -I "$here" -I "$here/../v1")
"$1" "${flags[@]}" -c functions.cpp -o functions.o
for framework in googletest doctest catch2 boost_test; do
  (($(wc -l <"$here/glue/$framework.cpp") <= 40)) || fail "$framework is long"
  libraries=()
  [[ $framework != googletest ]] || libraries=(-lgtest_main -lgtest -lpthread)
  "$1" "${flags[@]}" "$here/glue/$framework.cpp" functions.o -o "$framework" "${libraries[@]}" >out 2>&1 ||
    fail "$framework: apt-get install libgtest-dev doctest-dev catch2 libboost-test-dev"
  for how in right declines; do HOW=$how "./$framework" >out 2>&1 || fail "$framework: $how"; done
  for how in blind short; do
    ! HOW=$how "./$framework" >out 2>&1 || fail "$framework: $how"
    # Spheres that meet; a pair that is disjoint.
    [[ $how == short ]] && wanted='v1[-_]eb9d40709353387c' || wanted='v1[-_]b4d03ec8e323df15'
    grep -qE "$wanted" out || fail "$framework: $how: which vector"
    grep -qE 'said (a distance of|that they are disjoint)' out || fail "$framework: $how: what was wrong"
  done
done
echo passed
