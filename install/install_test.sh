#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the libraries of the build folder $1 into a clean prefix, moves it, and builds the example of README.md against
# it with compiler $2: by find_package and by pkg-config, a component at a time, each header alone.
set -euo pipefail

build=$1
compiler=$2
source=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
cd -- "$scratch"

fail() {
  echo "$*"
  exit 1
}

# What README.md prints, in files of the names it states.
awk '/^```/ && open { close(name); open = 0; next } /^```[a-z]+ file=/ { name = $0; sub(/.*file=/, "", name); open = 1 }
     open == 2 { print > name } open == 1 { open = 2 }' "$source/README.md"
[[ -s CMakeLists.txt && -s consumer.cpp && -s consumer.out ]] || fail "README.md lacks an example"

cat >some_oracles.cpp <<'END'
#include <daylight/oracles/compare.hpp>
#include <daylight/oracles/contained.hpp>
#include <daylight/oracles/exact.hpp>
int main() {
  const cyl::Pair pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{0, 0, 5}, {0, 0, 1}, 1, 2}};
  const cyl::Truth truth = cyl::judge(pair);
  cyl::LazyDistance distance([&](double width) { return cyl::enclose_distance(pair, truth, width); });
  int wrong = 0, answers = 0;
  for (const auto& method : cyl::all_methods()) {
    const cyl::MethodAnswer answer = method->ask(pair);
    answers += answer.status == cyl::Status::answered;
    wrong += cyl::compare(pair, truth, distance, method->claim(), answer).has_value();
  }
  return answers > 20 && wrong == 0 ? 0 : 1;
}
END

install_into() { # prefix components..
  local prefix=$1 component
  shift
  for component; do cmake --install "$build" --prefix "$prefix" --component "$component" >/dev/null; done
}

built_by_pkg_config() { # prefix module source program
  local flags
  export PKG_CONFIG_PATH
  PKG_CONFIG_PATH=$(dirname -- "$(find "$1" -name daylight-solver.pc)")
  flags=$(pkg-config --cflags --libs "$2")
  # shellcheck disable=SC2086 # flags are words
  "$compiler" "$3" -o "$4" $flags -std=c++20  # after the flags: those of FCL say c++11
}

built_by_cmake() { # prefix project folder
  cmake -S "$2" -B "$2/build" -DCMAKE_PREFIX_PATH="$1" -DCMAKE_CXX_COMPILER="$compiler" >log 2>&1 || fail "$(cat log)"
  cmake --build "$2/build" >log 2>&1 || fail "$(cat log)"
}

# The solver alone needs nothing of the rest.
install_into first solver
mv first moved
cat >only_solver.cpp <<'END'
#include <daylight/solver/intersect_batch.hpp>
int main() { return cyl::intersect(cyl::Cylinder{}, cyl::Cylinder{}) == cyl::Verdict::intersecting ? 0 : 1; }
END
built_by_pkg_config "$PWD/moved" daylight-solver only_solver.cpp only_solver
./only_solver || fail "the solver is wrong"
! ldd only_solver | grep -E 'gmp|mpf|fcl|nlopt|sqlite' || fail "the solver alone needs more than Eigen"
mkdir absent
sed 's/^/# /; s/^# \(cmake_min\|project\|find_package\)/\1/' CMakeLists.txt >absent/CMakeLists.txt
! cmake -S absent -B absent/build -DCMAKE_PREFIX_PATH="$PWD/moved" >log 2>&1 || fail "found a component that is not installed"
grep -q 'component exact is not installed' log || fail "$(cat log)"

install_into "$PWD/moved" exact
mkdir example
cp CMakeLists.txt consumer.cpp example
built_by_cmake "$PWD/moved" example
example/build/consumer >printed
diff -u consumer.out printed || fail "README.md prints something else"
built_by_pkg_config "$PWD/moved" daylight-exact consumer.cpp consumer
./consumer | diff -u consumer.out - || fail "built by pkg-config it prints something else"

install_into "$PWD/moved" oracles
mkdir oracles
mv some_oracles.cpp oracles/consumer.cpp
sed 's/exact/oracles/g' CMakeLists.txt >oracles/CMakeLists.txt
built_by_cmake "$PWD/moved" oracles
oracles/build/consumer || fail "the oracles are wrong"
built_by_pkg_config "$PWD/moved" daylight-oracles oracles/consumer.cpp some_oracles
./some_oracles || fail "built by pkg-config the oracles are wrong"

# The Debian packages hold the same, and name what they need.
if command -v dpkg-deb >/dev/null; then
  cpack -G DEB --config "$build/CPackConfig.cmake" -B "$PWD/debs" >log 2>&1 || fail "$(cat log)"
  [[ $(ls debs/*.deb | wc -l) == 3 ]] || fail "$(ls debs)"
  for name in solver exact oracles; do
    dpkg-deb -x debs/libdaylight-$name-dev_*.deb unpacked
  done
  dpkg-deb -f debs/libdaylight-solver-dev_*.deb Depends | grep -qx 'libeigen3-dev (>= 3.4)' || fail "the solver's package needs something else"
  dpkg-deb -f debs/libdaylight-exact-dev_*.deb Depends | grep -q '^libdaylight-solver-dev (= .*libmpfi-dev' || fail "the exact package lacks what it needs"
  dpkg-deb -f debs/libdaylight-oracles-dev_*.deb Depends | tr -d ' ' | tr , '\n' | sed 's/(.*//; /^libdaylight/d' >needed
  while IFS= read -r package; do
    dpkg-query -W "$package" >/dev/null || fail "the oracles' package needs $package, which the build did not"
  done <needed
  diff <(cd moved && find . -type f -printf '%f\n' | sort) <(find unpacked -type f -printf '%f\n' | sort) || fail "the packages hold something else"
  mkdir packaged
  cp CMakeLists.txt consumer.cpp packaged
  built_by_cmake "$PWD/unpacked/usr" packaged
  packaged/build/consumer | diff -u consumer.out - || fail "built from the packages it prints something else"
else
  echo 'skipped: the Debian packages (no dpkg-deb here)'
fi

# No header needs one that is not installed, nor one included before it.
cflags=$(pkg-config --cflags daylight-oracles)
while IFS= read -r header; do
  # shellcheck disable=SC2086 # flags are words
  echo "#include <daylight/$header>" | "$compiler" -fsyntax-only $cflags -std=c++20 -x c++ - || fail "$header does not stand alone"
done < <(cd moved/include/daylight && find . -type f | sed 's|^\./||')
! grep -rlF -- "$source" moved/lib*/cmake moved/lib*/pkgconfig 2>/dev/null || fail "a path of this machine was installed"
echo passed
