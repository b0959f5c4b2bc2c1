#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# daylight_add_gate in a project of strangers, with the executable $1: by FetchContent, and from an installation.
set -euo pipefail

# shellcheck source=SCRIPTDIR/../../cli/expect.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../../cli/expect.sh"

# The pairs of a cell are decided pairs. Undecided pairs are counted beside them.
feature() { # PAIRS UNDECIDED
  printf '{"methods":[{"cells":[{"feature":"side-rim","pairs":%s,"undecided":%s}]}],"failures":[]}' "$@" >cells.json
  expect 0 "$1 decided pairs" cmake -DJSON=cells.json -DFEATURE=side-rim -P "$source_tree/cmake/gate/feature.cmake"
}
feature 300 100
holds 'the decided pairs' err '^right on 300 independent pairs$'
feature 0 100
holds 'no decided pair' err '^not decided: '

remarks='[{"text":"x is gone","exit_code":0},{"text":"y is stale","exit_code":2}]'
printf '{"methods":[{"cells":[{"feature":"side-rim","pairs":9}]}],"failures":[],"remarks":%s}' "$remarks" >remarks.json
expect 0 'a remark has no feature' cmake -DJSON=remarks.json -DFEATURE=side-rim -P "$source_tree/cmake/gate/feature.cmake"
expect 1 'a remark that fails the gate' cmake -DJSON=remarks.json -DFEATURE=other -P "$source_tree/cmake/gate/feature.cmake"
holds 'a remark that fails the gate' err '^y is stale$'
lacks 'a remark that passes' err 'x is gone'

project() { # FOLDER HOW: a project whose plug-in is that of the guide, and one that declines everything
  mkdir "$1"
  awk '/^```cpp file=mine.cpp/ { open = 1; next } /^```/ { open = 0 } open' "$source_tree/docs/guides/library.md" >"$1/mine.cpp"
  sed 's/^int ask(.*/&\n  return DAYLIGHT_DECLINED;/; s/"mine/"idle/' "$1/mine.cpp" >"$1/idle.cpp"
  cat >"$1/CMakeLists.txt" <<END_OF_FILE
cmake_minimum_required(VERSION 3.25)
project(strangers CXX)
enable_testing()
$2
foreach(name mine idle)
  add_library(\${name} MODULE \${name}.cpp)
  target_link_libraries(\${name} PRIVATE daylight::plugin)
  daylight_add_gate(NAME \${name} PLUGIN \${name} CLAIM 1e-6 PAIRS 1200 ANNOTATE \${name}.cpp:1)
endforeach()
END_OF_FILE
}

try() { # FOLDER OPTION..
  expect 0 "$1 is configured" cmake -S "$1" -B "$1/build" "${@:2}"
  expect 0 "$1 is built" cmake --build "$1/build"
  expect 8 "$1 fails" ctest --test-dir "$1/build" --output-on-failure
  holds 'the gate itself' out 'mine\.gate \.+ +Passed'
  holds 'a feature that is wrong' out 'mine\.side-rim \.+\*+Failed'
  holds 'how' out 'mine/wrong_intersecting/side-rim/'
  holds 'its pair' out '^  \{"a":\{"axis":\[.*"radius":'
  holds 'a feature that is right' out 'mine\.side-side \.+ +Passed'
  holds 'a feature that is wrong within the claim alone' out 'mine\.cap-cap \.+ +Passed'
  holds 'none of no feature' out 'mine\.other \.+ +Passed'
  holds 'a feature that was not decided' out 'idle\.side-rim \.+\*+Skipped'
  holds 'a plug-in that answers nothing' out 'idle\.other \.+\*+Failed'
}

project fetched "include(FetchContent)
FetchContent_Declare(daylight SOURCE_DIR $source_tree SOURCE_SUBDIR cmake/gate)
FetchContent_MakeAvailable(daylight)"
# Fewer cases: those of the project are 36 s of a gate.
mkdir bin
printf '#!/bin/sh\nexec %s "$@" --cases ""\n' "$daylight" >bin/daylight
chmod +x bin/daylight
try fetched -DDAYLIGHT_PROGRAM="$scratch/bin/daylight"
cp fetched/build/mine.gate.json base.json
echo "daylight_add_gate(NAME again PLUGIN mine CLAIM 1e-6 PAIRS 9 SEED 9 AGAINST $scratch/base.json)" >>fetched/CMakeLists.txt
# No stored case needs the suppression, because this gate has no cases.
printf '{"cause":"stated/wrong_disjoint","reason":"r","link":"-","owner":"ada","expires":"2999-12-31"}\n' >stated.jsonl
printf '%s\n' 'echo "{\"name\":\"stated\"}"' 'while read -r _; do echo "{\"verdict\":\"disjoint\"}"; done' >stated.sh
cat >>fetched/CMakeLists.txt <<END_OF_FILE
daylight_add_gate(NAME stated COMMAND "sh $scratch/stated.sh" PAIRS 1200 FOR 100s SEED 5 SUPPRESSIONS $scratch/stated.jsonl)
END_OF_FILE
expect 0 'configured again' cmake -S fetched -B fetched/build
expect 0 'nothing is new' ctest --test-dir fetched/build -R '^again'
expect 0 'a command' ctest --test-dir fetched/build -R '^stated.gate'
expect 8 'a suppression that no case needs' ctest --test-dir fetched/build -R '^stated.other' --output-on-failure
holds 'a suppression that no case needs' out '^the suppression of stated/wrong_disjoint \(line 1\) matches no stored case'
expect 0 'its seed' grep -q '"seed": *5' fetched/build/stated.gate.json

# As cmake --install lays it out; install_test looks whether it does.
mkdir -p prefix/lib/x/cmake/daylight-gate prefix/share/daylight/oracles
cp "$source_tree"/cmake/gate/*.cmake prefix/lib/x/cmake/daylight-gate
cp "$source_tree/oracles/plugin.h" prefix/share/daylight/oracles
cp -r bin prefix
project installed 'find_package(daylight-gate REQUIRED)'
try installed -DCMAKE_PREFIX_PATH="$scratch/prefix" -Ddaylight-gate_DIR="$scratch/prefix/lib/x/cmake/daylight-gate"
sed -i 's/PLUGIN ${name}/PLUGIN none/' installed/CMakeLists.txt
expect 1 'no such target' cmake -S installed -B installed/build
holds 'why' err 'PLUGIN none is not a target'
