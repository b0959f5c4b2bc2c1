#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The gate of the executable given as $1, as a build server sees it: exit codes, files, what it says.
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
gate() { # exit code wanted, arguments
  local wanted=$1 code=0
  shift
  timeout 100 "$daylight" gate "$@" >out 2>err || code=$?
  [[ $code == "$wanted" ]] || fail "gate $*: exit code $code, not $wanted"
}

gate 0 --for 3s --junit ours.xml --sarif ours.sarif --json ours.json --keep ours.jsonl
grep -q '^intersect: right on ' out || fail 'no line that says what was proved'
[[ $(head -1 out) == 'seed 1' ]] || fail 'the seed does not come first'
[[ ! -s ours.jsonl ]] || fail 'cases were kept though nothing failed'

gate 2 --method fcl-libccd --for 2s --json fcl.json --keep fcl.jsonl --github
grep -q '^1\. fcl-libccd breaks law ' out || fail 'no broken law'
grep -q '^::error file=' out || fail 'no annotation'
[[ -s fcl.jsonl ]] || fail 'no case was kept'
"$daylight" check fcl.jsonl >/dev/null || fail 'the kept cases are no cases'

gate 0 --method fcl-libccd --against fcl.json
python3 - <<'END'
import json
base = json.load(open('fcl.json'))
for failure in base['failures']:
    failure['count'] -= failure['count'] > 100
json.dump(base, open('fewer.json', 'w'))
END
gate 2 --method fcl-libccd --against fewer.json
grep -q ' in the base' out || fail 'what has grown is not told'
again=$(sed -n 's/^   replay *//p' out | head -1)
code=0
(
  PATH=$(dirname "$daylight"):$PATH
  eval "$again"
) >out 2>err || code=$?
[[ $code == 2 ]] || fail "exit code $code of: $again"
grep -q '^  truth: ' out || fail 'what replays a failure does not say what is true'
gate 64 --against fcl.json --for 4s
printf '{"bucket":"nobody/hang","reason":"r","link":"-","owner":"ada","expires":"2999-12-31"}\n' >stale.jsonl
gate 2 --for 2s --suppressions stale.jsonl
grep -q 'nobody/hang (line 1) matches no stored case' out || fail 'a stale suppression is not told'
gate 64 --method nobody
gate 64 --reproduce nonsense
gate 1 --against ours.xml
gate 0 --laws
grep -q ' swap ' out || fail 'the laws are not listed'
echo passed
