#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# export --emit of the executable given as $1: the test fails for a function that is wrong like the method, and passes for
# one that is right, in each framework.
set -euo pipefail

# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"

cat >guest.py <<'END_OF_FILE'
import json, os, sys
for line in sys.stdin:
    apart = json.loads(line)['b']['center'][0] > 2.5
    meet = {'verdict': 'intersecting'} if apart else {'verdict': 'disjoint'}
    far = {'verdict': 'disjoint', 'distance': 9} if apart else {'verdict': 'intersecting'}
    print(json.dumps(far if len(sys.argv) > 1 else meet), flush=True)
END_OF_FILE
solid='"axis":[0,0,1],"radius":1,"height":2}'
printf '{"a":{"center":[0,0,0],%s,"b":{"center":[%s,0,0],%s}\n' "$solid" 3 "$solid" "$solid" 1 "$solid" >pairs.jsonl
write() { # NAME LINE COMMAND FRAMEWORK
  expect 0 "export $1 for $4" "$daylight" export "pairs.jsonl:$2" --command "mine=$3" --method mine --emit "$4" --out "$1-$4"
}
for framework in gtest doctest catch2 boost pytest node; do
  write apart 1 'python3 guest.py' $framework
done
write meet 2 'python3 guest.py' pytest
write far 1 'python3 guest.py far' pytest
write far 1 'python3 guest.py far' gtest
expect 64 'no such framework' "$daylight" export pairs.jsonl:1 --command 'mine=python3 guest.py' --method mine --emit cargo --out none
holds 'the proof' apart-gtest/daylight_test.cpp '^// Proof.*"direction":'

cat >functions.cpp <<'END_OF_FILE'
#include <cstdlib>
bool collide(const double a[9], const double b[9]) { return b[0] - a[0] < (std::getenv("WRONG") ? 9 : 2) && a[6] == 1 && b[7] == 2; }
double signed_distance(const double a[9], const double b[9]) { return b[0] - a[0] - (std::getenv("WRONG") ? -6 : 2); }
END_OF_FILE
tried() { # NAME COMMAND..
  expect 0 "$1, right" "${@:2}"
  WRONG=1 expect 1 "$1, wrong" "${@:2}"
}
c++ -std=c++17 -c functions.cpp
echo '#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "apart-doctest/daylight_test.cpp"' >doctest.cpp
echo '#define CATCH_CONFIG_MAIN
#include "apart-catch2/daylight_test.cpp"' >catch2.cpp
echo '#define BOOST_TEST_MODULE mine
#include <boost/test/included/unit_test.hpp>
#include "apart-boost/daylight_test.cpp"' >boost.cpp
cp apart-gtest/daylight_test.cpp gtest.cpp
cp far-gtest/daylight_test.cpp far.cpp
for framework in gtest far doctest catch2 boost; do
  libraries=()
  [[ $framework != gtest && $framework != far ]] || libraries=(-lgtest_main -lgtest -lpthread)
  expect 0 "$framework is compiled" c++ -std=c++17 -Wall -Wextra -Werror $framework.cpp functions.o -o $framework "${libraries[@]}"
  [[ $framework == @(catch2|boost) ]] || tried $framework ./$framework
done
# Their exit codes count failures, or are 201.
for framework in catch2 boost; do
  expect 0 "$framework, right" ./$framework
  ! WRONG=1 ./$framework >out 2>err || failed "$framework, wrong"
done

cat >mine.py <<'END_OF_FILE'
import os
def collide(a, b):
    return b[0] - a[0] < (9 if os.environ.get('WRONG') else 2) and a[6] == 1 and b[7] == 2
def signed_distance(a, b):
    return b[0] - a[0] - (-6 if os.environ.get('WRONG') else 2)
END_OF_FILE
pytest=(env PYTHONPATH="$scratch" PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -m pytest -q)
/usr/bin/python3 -c 'import pytest' || exec "$source_tree/.ci/skip" 'no pytest: apt-get install python3-pytest'
tried pytest "${pytest[@]}" apart-pytest
tried 'a distance in pytest' "${pytest[@]}" far-pytest
expect 0 'a pair that meets' "${pytest[@]}" meet-pytest
command -v node >/dev/null || exec "$source_tree/.ci/skip" 'no Node.js here: apt-get install nodejs'
echo 'export const collide = (a, b) => b[0] - a[0] < (process.env.WRONG ? 9 : 2) && a[6] === 1 && b[7] === 2;' >apart-node/mine.mjs
tried node node --test apart-node/daylight.test.mjs
