#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Which answers of the solver and the seed methods change with the build: gcc and clang, -O0 and -O3, with and without
# fused multiply-add (-mfma -ffp-contract=fast), denormal numbers kept and flushed to 0, each against the release build
# of gcc. Prints the lines of bench/stability/builds.jsonl:
#   cmake --preset release && ninja -C build/release compare_builds
#   bench/stability/builds.sh build/release/compare_builds > bench/stability/builds.jsonl
# Arguments: that program; a folder for what is built, else a temporary one. JOBS: how many at a time, else 2. For
# x86-64 alone; a compiler that is not installed is left out, but gcc, and so is fused multiply-add that the machine
# has not.
set -euo pipefail
[[ $(uname -m) == x86_64 ]]
program=$(readlink -f -- "$1")
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../.."
if [[ $# -gt 1 ]]; then
  work=$2
  mkdir -p -- "$work"
else
  work=$(mktemp -d)
  trap 'rm -rf -- "$work"' EXIT
fi

driver() { [[ $1 == gcc* ]] && echo g++ || echo clang++; }  # of a build or compiler
reference=gcc-O3
builds=()
for compiler in gcc clang; do
  command -v "$(driver "$compiler")" >/dev/null || continue
  for level in O3 O0; do
    builds+=("$compiler-$level")
    if grep -qw fma /proc/cpuinfo; then builds+=("$compiler-$level-fma"); fi
  done
done

flags_of() {  # of a build, as the release preset has them but for what its name says
  local contract=off
  [[ $1 == *-fma ]] && contract='fast -mfma'
  [[ $1 == *-O0* ]] && echo -n '-O0 ' || echo -n '-O3 '
  echo "-DNDEBUG -std=c++20 -ffp-contract=$contract -fno-math-errno -I. $(pkg-config --cflags eigen3) '-DDAYLIGHT_VERSION=\"\"'"
}

sources=()
for file in solver/*.cpp solver/detail/*.cpp solver/literature/*.cpp corpus/pairs/method_answer.cpp \
            oracles/methods/{adapter,method,own_methods,literature_2008_method,literature_2017_method}.cpp \
            bench/stability/build_answers_main.cpp; do
  [[ $file == *_test.cpp ]] || sources+=("$file")
done
cache=$(command -v ccache || true)
for build in "${builds[@]}"; do
  mkdir -p -- "$work/$build"
  compiler=$(driver "$build")
  for file in "${sources[@]}"; do
    own=
    [[ $file == *_v3.cpp ]] && own=-march=x86-64-v3
    [[ $file == *_v4.cpp ]] && own=-march=x86-64-v4
    printf '%s\0' "$cache $compiler $(flags_of "$build") $own -c $file -o $work/$build/${file//\//_}.o"
  done
done | xargs -0 -P "${JOBS:-2}" -I{} bash -c '{}'

"$program" pairs "$work/pairs"
for build in "${builds[@]}"; do
  "$(driver "$build")" "$work/$build"/*.o -o "$work/$build/answers"
  printf '%s\0' "$work/$build/answers $work/pairs $work/$build.answers" \
                "$work/$build/answers $work/pairs $work/$build-flush.answers flush"
done | xargs -0 -P "${JOBS:-2}" -I{} bash -c '{}'
compared=("$reference" "$work/$reference.answers")
for name in "${builds[@]}" "${builds[@]/%/-flush}"; do
  [[ $name == "$reference" ]] || compared+=("$name" "$work/$name.answers")
done

versions=
for compiler in gcc clang; do
  if [[ ${builds[*]} == *$compiler* ]]; then
    versions+=",\"$compiler\":\"$("$(driver "$compiler")" -dumpfullversion -dumpversion)\""
  fi
done
echo "{\"command\":\"bench/stability/builds.sh build/release/compare_builds\"$versions}"
"$program" compare "$work/pairs" "${compared[@]}"
