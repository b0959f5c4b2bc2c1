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
grep -Eq '^[0-9]+ causes?$' out || fail 'the first line does not count the causes'
grep -q '^\* fcl-libccd/overflow' out || fail 'overflow is no cause'
grep -q '"key": "fcl-libccd/overflow"' causes.json || fail 'the causes are not written'
[[ -s night/report.html ]] || fail 'no page'
[[ $(find night/buckets -name '*.jsonl' ! -name '*.worst.jsonl' -exec cat {} + | wc -l) == $(grep -c '"key"' causes.json) ]] || fail 'not one simple pair a cause'
[[ -s night/buckets/fcl-libccd.overflow.jsonl ]] || fail 'the file of a cause is not called as it is'
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
grep -q 'fcl-libccd/overflow (line [0-9]*) expired on 2020-12-31' out || fail 'an expired suppression is not told'
printf '{"bucket":"overflow","owner":7}\n' >bad.jsonl
run 64 triage night --suppressions bad.jsonl
grep -q 'bad.jsonl: line 1, column 30: owner is no text' err || fail 'the error names no place'

# A suppression by a key of 0.1.0 still holds, and what replaces it is told.
sed 's|fcl-libccd/overflow|overflow|' known.jsonl >former.jsonl
run 0 triage night --for 1s --suppressions former.jsonl
grep -q 'overflow (line [0-9]*) is by a key of 0.1.0; write instead' out || fail 'an old key is not told'
grep -q '^{"bucket":"fcl-libccd/overflow","reason":"known","link":"-","owner":"ada"' out || fail 'no line replaces it'

# The second morning: nothing is new; what is noted stays.
rm -r killed
run 0 triage night --annotate fcl-libccd/overflow --owner ada --note 'told "them"'
grep -q '"owner":"ada"' notes.jsonl || fail 'nothing is noted'
run 64 triage night --annotate no/such --owner ada
run 2 campaign --pairs 1500 --seed 4 --methods fcl-libccd,seedbook-printed --families lattice,tiny_and_huge --cases '' --out night2
triage night2
grep -q '^0 new causes, ' out || fail 'the same program has new causes'
! grep -q ', gone' out || fail 'what fails today is called gone'
python3 - night2/report.html <<'END' || fail 'the page lacks what was noted, or the nights'
import json, re, sys
page = open(sys.argv[1], encoding='utf-8').read()
data = json.loads(re.search(r'<script type="application/json" id="report-data">(.*?)</script>', page, re.S)[1])
cause = next(b for b in data['buckets'] if b['key'] == 'fcl-libccd/overflow')
assert cause['note'] == {'owner': 'ada', 'note': 'told "them"'}, cause['note']
assert [night['run'] for night in cause['nights']] == ['night', 'night2'] and cause['standing'] == 'known'
assert data['changes']['new'] == 0 and data['changes']['against'] == ['night'] and data['changes']['known'] > 0
assert all(f['margin'] is None or f['margin'][0] <= f['margin'][1] for f in data['findings'])
claims = {m['name']: m['claim']['stated'] for m in data['methods']}
assert claims['fcl-libccd'] and not claims['seedbook-printed'], claims
END
echo passed
