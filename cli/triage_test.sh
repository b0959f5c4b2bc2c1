#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Triage of the executable given as $1, as a person sees it: exit codes, files, a second morning.
set -euo pipefail

# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"

triage() { # with more time until every finding was looked at
  local seconds
  for seconds in 2 8 32 128; do
    expect 2 "triage $1" "$daylight" triage "$@" --for "${seconds}s"
    grep -q 'findings remain: run triage again' out || return 0
  done
}
night=(campaign --pairs 1500 --methods fcl-libccd,seedbook-printed --families 'lattice,tiny_and_huge' --cases '')

expect 64 'no run' "$daylight" triage
expect 64 'no such run' "$daylight" triage nowhere

expect 2 'a night' "$daylight" "${night[@]}" --seed 3 --out night

triage night --json causes.json
holds 'the printed page of the book is a cause' out '^\* seedbook/wrong_intersecting'
holds 'the causes are counted' out '^[0-9]+ causes?$'
holds 'overflow is a cause' out '^\* fcl-libccd/overflow'
holds 'it is written' causes.json '"key": "fcl-libccd/overflow"'
[[ -s night/report.html ]] || failed 'no page'
equal 'a simple pair a cause' "$(grep -c '"key"' causes.json)" \
  "$(find night/causes -name '*.jsonl' -exec cat {} + | wc -l)"
[[ -s night/causes/fcl-libccd.overflow.jsonl ]] || failed 'the file of a cause is not called as it is'
cat night/causes/*.jsonl >simple.jsonl
expect 0 'the simple pairs are pairs' "$daylight" check simple.jsonl
# The second morning: nothing is new.
expect 2 'another night' "$daylight" "${night[@]}" --seed 4 --out night2
triage night2
holds 'nothing is new' out '^0 new causes, '
lacks 'nothing is gone' out ', gone'
mkdir -p empty
expect 64 'nothing to compare with' "$daylight" triage night2 --for 1s --against empty
holds 'nothing to compare with' err 'empty holds no run$'
expect 0 'only what is new' "$daylight" triage night2 --for 1s --new-only --json new.json
holds 'what changed is still reported' out '^0 new causes, [0-9]+ known'
lacks 'no known cause is listed' out '^\* '
equal 'none is written' '[]' "$(<new.json)"
expect 2 'without an earlier run' "$daylight" triage night --for 1s --new-only --json new.json
equal 'all are new' "$(grep -c '"key"' causes.json)" "$(grep -c '"key"' new.json)"
