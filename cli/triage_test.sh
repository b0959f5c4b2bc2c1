#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Triage of the executable given as $1, as a person sees it: exit codes, files, going on after a kill, suppressions.
set -euo pipefail

daylight=$1
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
cd -- "$scratch"

fail() {
  printf 'FAILED: %s\n' "$1"
  head -c 4000 out err
  exit 1
}
run() { # exit code wanted, arguments
  local wanted=$1 code=0
  shift
  timeout 800 "$daylight" "$@" >out 2>err || code=$?
  [[ $code == "$wanted" ]] || fail "$*: exit code $code, not $wanted"
}

triage() { # the same, with more time until every finding was looked at
  local seconds
  for seconds in 8 32 128 512; do
    run 2 triage "$@" --for "${seconds}s" --suppressions none.jsonl
    grep -q 'not looked at yet' out || return 0
  done
}

run 64 triage
run 64 triage nowhere

run 2 campaign --pairs 1500 --seed 3 --methods fcl-libccd,seedbook-printed --families lattice,tiny_and_huge --cases '' --out night
cp -r night killed

triage night --json causes.json
grep -q '^\* seedbook/wrong_intersecting' out || fail 'the printed page of the book is no cause'
grep -q '^\* overflow' out || fail 'overflow is no cause'
grep -q '"key": "overflow"' causes.json || fail 'the causes are not written'
[[ -s night/report.html ]] || fail 'no page'
[[ $(find night/buckets -name '*.jsonl' ! -name '*.worst.jsonl' -exec cat {} + | wc -l) == $(grep -c '"key"' causes.json) ]] || fail 'not one simple pair a cause'
cat night/buckets/*.jsonl | "$daylight" check >/dev/null || fail 'the simple pairs are no pairs'
keys=$(grep '"key"' causes.json | sort)

# Killed at some moment, then run again: the same causes.
setsid timeout -s KILL 2 "$daylight" triage killed --for 8s >out 2>err || true
triage killed --json again.json
[[ $(grep '"key"' again.json | sort) == "$keys" ]] || fail 'other causes after a kill'

# Suppressed causes are shown and do not fail; one that nothing stored shows is told.
for key in $(sed -n 's/^\* \([^, ]*\).*/\1/p' out) nobody/hang; do
  printf '{"bucket":"%s","reason":"known","link":"-","owner":"ada","expires":"2999-12-31"}\n' "$key"
done >known.jsonl
run 0 triage night --for 1s --suppressions known.jsonl
grep -q 'overflow.*suppressed' out || fail 'what is suppressed is not shown'
grep -q 'nobody/hang (line [0-9]*) matches no stored case' out || fail 'a stale suppression is not told'
sed s/2999/2020/ known.jsonl >expired.jsonl
run 2 triage night --for 1s --suppressions expired.jsonl
grep -q 'overflow (line [0-9]*) expired on 2020-12-31' out || fail 'an expired suppression is not told'
printf '{"bucket":"overflow","owner":7}\n' >bad.jsonl
run 64 triage night --suppressions bad.jsonl
grep -q 'bad.jsonl: line 1, column 30: owner is no text' err || fail 'the error names no place'
echo passed
