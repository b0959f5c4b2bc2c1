#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the libraries of the build folder $1 into a clean prefix, moves it, and builds the example of docs/library-use.md against
# it with compiler $2: by find_package, a component at a time, each header alone.
set -euo pipefail

build=$1
compiler=$2
source=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
cd -- "$scratch"

fail() {
  echo "$*"
  exit 1
}

# What docs/library-use.md prints, in files of the names it states.
awk '/^```/ && open { close(name); open = 0; next } /^```[a-z]+ file=/ { name = $0; sub(/.*file=/, "", name); open = 1 }
     open == 2 { print > name } open == 1 { open = 2 }' "$source/docs/library-use.md"
[[ -s CMakeLists.txt && -s consumer.cpp && -s consumer.out ]] || fail "docs/library-use.md lacks an example"

install_into() { # prefix components..
  local prefix=$1 component
  shift
  for component; do cmake --install "$build" --prefix "$prefix" --component "$component" >/dev/null; done
}

built_by_cmake() { # prefix project folder
  cmake -G Ninja -S "$2" -B "$2/build" -DCMAKE_PREFIX_PATH="$1" -DCMAKE_CXX_COMPILER="$compiler" >log 2>&1 || fail "$(cat log)"
  cmake --build "$2/build" >log 2>&1 || fail "$(cat log)"
}

# The solver alone needs nothing of the rest, neither to be built nor to be used.
cmake -G Ninja -S "$source" -B solver -DDAYLIGHT_HARNESS=OFF -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" >log 2>&1 || fail "$(cat log)"
cmake --build solver >log 2>&1 || fail "$(cat log)"
cmake --install solver --prefix first >/dev/null
mv first moved
mkdir only_solver
cat >only_solver/consumer.cpp <<'END'
#include <daylight/solver/intersect_batch.hpp>
int main() { return cyl::intersect(cyl::Solid{}, cyl::Solid{}) == cyl::Verdict::intersecting ? 0 : 1; }
END
sed 's/exact/solver/g' CMakeLists.txt >only_solver/CMakeLists.txt
built_by_cmake "$PWD/moved" only_solver
only_solver/build/consumer || fail "the solver is wrong"
! ldd only_solver/build/consumer | grep -E 'gmp|mpf|fcl|nlopt|sqlite' || fail "the solver alone needs more than Eigen"
mkdir absent
sed 's/^/# /; s/^# \(cmake_min\|project\|find_package\)/\1/' CMakeLists.txt >absent/CMakeLists.txt
! cmake -G Ninja -S absent -B absent/build -DCMAKE_PREFIX_PATH="$PWD/moved" >log 2>&1 || fail "found a component that is not installed"
grep -q 'component exact is not installed' log || fail "$(cat log)"

install_into "$PWD/moved" exact
mkdir example
cp CMakeLists.txt consumer.cpp example
built_by_cmake "$PWD/moved" example
example/build/consumer >printed
diff -u consumer.out printed || fail "docs/library-use.md prints something else"

# The program finds its files beside it, wherever it is moved, and tells what an installation lacks.
try_program() { # prefix
  local daylight=$1/bin/daylight
  "$daylight" campaign --methods decide --pairs 1000 --seed 1 --table --out "$1/run" >printed || fail "the installed program: $(cat printed)"
  grep -qE "^corpus +$(cat "$source"/corpus/cases/*.jsonl | grep -c .) " printed || fail "not every case was played: $(cat printed)"
  "$source/reports/web/page_data.py" "$1/run/report.html" >page.json
  "$daylight" scene "$1/share/daylight/corpus/scenes/twenty.urdf" >printed || fail "$(cat printed)"
  ! "$daylight" fuzz --for 1s >/dev/null 2>err || fail "a fuzzer was installed"
  grep -q 'no part of an installation' err || fail "$(cat err)"
  rm -r "$1/run"
}
install_into first program
cp -r first/. moved
rm -r first
try_program "$PWD/moved"
! grep -qF -- "$source" moved/bin/daylight || fail "the program names a path of this machine"

# The portable archive finds all that it needs in its own folder, wherever it is unpacked, and gates a plug-in there.
cpack --config "$build/CPackConfig.cmake" -B "$PWD/archive" >log 2>&1 || fail "$(cat log)"
mkdir portable
tar -xf archive/*.tar.gz -C portable --strip-components 1
for program in portable/bin/*; do
  ldd "$program" | sed -n 's/.* => \(\S*\) .*/\1/p' | grep -vE "^$PWD/portable/|/lib(c|m|pthread|gcc_s|stdc\+\+)\.so" >outside || true
  [[ ! -s outside ]] || fail "$program needs $(cat outside)"
  ! grep -qF -- "$source" "$program" || fail "$program names a path of this machine"
done
grep -q 'libfcl0.7/copyright' portable/share/doc/daylight/bundled-libraries.txt || fail "the archive lacks the licences of its libraries"
cat >always.c <<'END'
#include "plugin.h"
static int ask(const double* a, const double* b, double* more) { return (void)a, (void)b, (void)more, DAYLIGHT_INTERSECTING; }
static const struct DaylightMethod always = {.abi = DAYLIGHT_PLUGIN_ABI, .name = "always", .ask = ask};
const struct DaylightMethod* daylight_method(void) { return &always; }
END
cc -shared -fPIC -I portable/share/daylight/oracles always.c -o always.so
status=0
portable/bin/daylight gate --plugin ./always.so --pairs 20000 >printed 2>&1 || status=$?
[[ $status == 2 ]] || fail "the gate of the archive ends with $status: $(cat printed)"

# No header needs one that is not installed, nor one included before it; none warns, whoever compiles, and the plug-in's
# is C too.
cflags="-I moved/include -I moved/include/daylight $(pkg-config --cflags-only-I eigen3) -Wall -Wextra -Werror -fsyntax-only"
export compiler cflags
(cd moved/include/daylight && find . -type f) | sed 's|^\./|daylight/|' >headers
# shellcheck disable=SC2016 # for the other shell
xargs -P 2 -n 1 bash -c '$compiler $cflags -std=c++20 -x c++ - <<<"#include <$0>" || { echo "$0 does not stand alone"; exit 255; }' <headers ||
  fail "a header does not stand alone"
for other in g++ clang++; do
  # shellcheck disable=SC2086 # flags are words
  ! command -v $other >/dev/null || sed 's/.*/#include <&>/' headers | $other $cflags -std=c++20 -x c++ - || fail "$other warns"
done
# shellcheck disable=SC2086
echo '#include "plugin.h"' | "$compiler" $cflags -I portable/share/daylight/oracles -x c - || fail "the header of plug-ins is no C"
! grep -rlF -- "$source" moved/lib*/cmake 2>/dev/null || fail "a path of this machine was installed"
echo passed
