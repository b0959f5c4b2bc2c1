#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Triage of the executable given as $1, as a person sees it: exit codes, files, going on after a kill.
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
cp -r night killed

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
keys=$(grep '"key"' causes.json | sort)

# Killed once something is stored, then run again: the same causes.
stored_causes() { # RUN : whether its triage has stored a cause
  python3 -c 'import sqlite3, sys
sys.exit(not sqlite3.connect(f"file:{sys.argv[1]}/triage.sqlite?mode=ro", uri=True).execute("SELECT 1 FROM cause").fetchone())' \
    "$1" 2>/dev/null
}
setsid "$daylight" triage killed --for 8s >out 2>err &
triaging=$!
for _ in {1..6000}; do
  stored_causes killed && break
  sleep 0.01
done
kill -KILL -- "-$triaging" || failed 'it ended before it was killed'
triage killed --json again.json
equal 'the same causes after a kill' "$keys" "$(grep '"key"' again.json | sort)"

# The second morning: nothing is new.
rm -r killed
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
page_data night2/report.html >page.json
expect 0 'the page compares the nights' python3 - page.json <<'END'
import json, sys
data = json.load(open(sys.argv[1], encoding='utf-8'))
cause = next(b for b in data['causes'] if b['key'] == 'fcl-libccd/overflow')
assert cause['status'] == 'known' and cause['first_seen'] == 'night', cause
assert all(f['margin'] is None or f['margin'][0] <= f['margin'][1] for f in data['findings'])
claims = {m['name']: m['claim']['stated'] for m in data['methods']}
assert claims['fcl-libccd'] and not claims['seedbook-printed'], claims
END
