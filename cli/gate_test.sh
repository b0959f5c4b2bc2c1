#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The gate of the executable given as $1, as a build server sees it: exit codes, files, what it says.
set -euo pipefail

daylight=$1
source_tree=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
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
  timeout 300 "$daylight" gate "$@" >out 2>err || code=$?
  [[ $code == "$wanted" ]] || fail "gate $*: exit code $code, not $wanted"
}

gate 0 --pairs 3000 --junit ours.xml --sarif ours.sarif --json ours.json --keep ours.jsonl
grep -q '^intersect: right on ' out || fail 'no line that says what was proved'
[[ $(head -1 out) == 'seed 1' ]] || fail 'the seed does not come first'
! grep -q 'NOT ASKED' out || fail 'something was not asked'
[[ ! -s ours.jsonl ]] || fail 'cases were kept though nothing failed'

gate 2 --method fcl-libccd --pairs 3000 --json fcl.json --keep fcl.jsonl --github
grep -q '^1\. fcl-libccd breaks law ' out || fail 'no broken law'
grep -q '^::error file=' out || fail 'no annotation'
[[ -s fcl.jsonl ]] || fail 'no case was kept'
"$daylight" check fcl.jsonl >/dev/null || fail 'the kept cases are no cases'

# The same number of pairs and the same seed are the same gate, also where the machine is busy.
without_times() {
  python3 - "$1" <<'END'
import json, sys
report = json.load(open(sys.argv[1]))
for part in [*report['phases'], *(method['counts'] for method in report['methods'])]:
    part.pop('milliseconds', part.pop('hung_seconds', None))
print(json.dumps(report, indent=1))
END
}
busy=()
for _ in 1 2 3 4; do
  (while :; do :; done) &
  busy+=($!)
done
trap 'kill "${busy[@]}"; rm -rf -- "$scratch"' EXIT
gate 2 --method fcl-libccd --pairs 3000 --json again.json
kill "${busy[@]}"
trap 'rm -rf -- "$scratch"' EXIT
without_times fcl.json >first
without_times again.json >second
cmp first second || fail 'the same gate said something else on a busy machine'
gate 2 --method fcl-libccd --pairs 3000 --seed 2 --json other.json
! cmp -s first <(without_times other.json) || fail 'another seed is the same gate'

# A cap on time cuts it: more pairs than any machine asks in a second.
gate 3 --for 1s --pairs 4000000000 --json cut.json --junit cut.xml --sarif cut.sarif --github
grep -qE '^NOT ASKED: sample of all strata: [0-9]+ of [0-9]+ rounds, for the time was over$' out ||
  fail 'the cut is not told'
grep -q '^Nothing that was asked fails the gate' out || fail 'a cut gate says that nothing fails'
grep -q '^::warning .*not asked::sample of all strata' out || fail 'no annotation of what was not asked'
grep -q '"not_asked": \[$' cut.json || fail 'the JSON does not say what was not asked'
grep -q '<error type="not asked"' cut.xml || fail 'JUnit does not say what was not asked'
grep -q '"executionSuccessful": false' cut.sarif || fail 'SARIF does not say what was not asked'
gate 2 --command 'liar=while read -r q; do echo "{\"verdict\":\"disjoint\"}"; done' --for 1s --pairs 4000000000

# What fails of a guest is shown in the guest's tree, or nowhere.
liar='liar=while read -r q; do echo "{\"verdict\":\"disjoint\"}"; done'
mkdir -p src && : >src/liar.sh
gate 2 --command "$liar" --pairs 500 --sarif liar.sarif --junit liar.xml --github
grep -q '^::error title=liar breaks law ' out || fail 'no annotation of a guest'
! grep -qE '"uri"|"(message|name)".*/corpus/cases' liar.sarif || fail 'SARIF points at a file that is not the guest'"'"'s'
! grep -qF -- "$source_tree" liar.sarif liar.xml || fail 'a path of ours is in what is sent'
gate 2 --command "$liar" --pairs 500 --sarif liar.sarif --junit liar.xml --github --annotate "$PWD/src/liar.sh:3"
grep -q '^::error file=src/liar.sh,line=3,title=liar breaks law ' out || fail 'no annotation in the guest'"'"'s tree'
[[ $(grep -c '"uri": "src/liar.sh"' liar.sarif) == "$(grep -c '"ruleId"' liar.sarif)" ]] || fail 'SARIF does not point at the guest'
grep -q '<testcase .*file="src/liar.sh" line="3"' liar.xml || fail 'JUnit does not name the file'
gate 64 --command "$liar" --annotate src/none.sh:3
gate 64 --command "$liar" --annotate other=src/liar.sh:3
gate 64 --annotate src/liar.sh:3

# Against a base all of its pairs are asked, and what has grown is told, or it is said what was not.
gate 0 --method fcl-libccd --against fcl.json --sarif same.sarif
grep -q '"level": "note"' same.sarif || fail 'no note'
! grep -q '"baselineState": "new"' same.sarif || fail 'a note of the base is told as new'
python3 - <<'END'
import json
base = json.load(open('fcl.json'))
grown = [failure for failure in base['failures'] if failure['severity'] == 'contract' and failure['count'] > 1
         and failure['kind'] != 'hang' and failure['failed_again'] == failure['reruns']]
assert grown, 'nothing failed on two pairs'
for failure in grown:
    failure['count'] -= 1
json.dump(base, open('fewer.json', 'w'))
base['failures'] = []
base['methods'].append({'name': 'somebody'})
json.dump(base, open('more.json', 'w'))
ours = json.load(open('ours.json'))
ours['laws'].append(999)
ours['cases'].append('0123456789abcdef')
ours['phases'][-1]['digest'] = '0123456789abcdef'
json.dump(ours, open('other.json', 'w'))
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
gate 2 --method fcl-libccd --against more.json
grep -q '^NOT ASKED: method somebody, which the base has$' out || fail 'a missing method of the base is not told'
gate 0 --against ours.json
gate 3 --against other.json
for what in 'law 999' '1 of [0-9]* cases' 'sample of close contacts: the pairs'; do
  grep -q "^NOT ASKED: $what, which the base has\$" out || fail "not told: $what"
done
gate 3 --method intersect --against ours.json
gate 3 --against ours.json --for 1ms
gate 64 --against fcl.json --pairs 100
gate 64 --against fcl.json --seed 2
gate 64 --pairs 0
printf '{"bucket":"nobody/hang","reason":"r","link":"-","owner":"ada","expires":"2999-12-31"}\n' >stale.jsonl
gate 2 --pairs 1000 --suppressions stale.jsonl
grep -q 'nobody/hang (line 1) matches no stored case' out || fail 'a stale suppression is not told'
gate 64 --method nobody
gate 64 --reproduce nonsense
gate 1 --against ours.xml
gate 0 --laws
grep -q ' swap ' out || fail 'the laws are not listed'
echo passed
