#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The gate of the executable given as $1, as a build server sees it: exit codes, files, what it says.
set -euo pipefail

# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"
gate() { expect "$1" "gate ${*:2}" "$daylight" gate "${@:2}"; }

# The known cases once; else ten of them, beside which a copy of the program stands.
gate 0 --pairs 1000 --junit ours.xml --keep ours.jsonl
holds 'what was proved' out '^The verdict of intersect is right on all '
equal 'the seed comes first' 'seed 1' "$(head -n 1 out)"
lacks 'no other seed is named' err 'seed='
lacks 'all was asked' out 'NOT ASKED'
[[ ! -s ours.jsonl ]] || failed 'cases were kept though nothing failed'
mkdir -p bin corpus/cases src
sed -n 70,79p "$source_tree/corpus/cases/hand_made.jsonl" >corpus/cases/few.jsonl
cp -- "$daylight" bin
daylight=$scratch/bin/daylight
gate 0 --method intersect,decide --pairs 500 --json ours.json

gate 2 --method libccd-mpr --pairs 500 --json mpr.json --keep mpr.jsonl
holds 'a broken law' out '^1\. libccd-mpr[-a-z0-9]* breaks law '
[[ -s mpr.jsonl ]] || failed 'no case was kept'
expect 0 'the kept cases are cases' "$daylight" check mpr.jsonl

# The same number of pairs and the same seed are the same gate.
without_times() {
  python3 - "$1" <<'END'
import json, sys
report = json.load(open(sys.argv[1]))
for part in [*report['phases'], *(method['counts'] for method in report['methods'])]:
    part.pop('milliseconds', part.pop('hung_seconds', None))
print(json.dumps(report, indent=1))
END
}
gate 2 --method libccd-mpr --pairs 500 --json again.json
without_times mpr.json >first
without_times again.json >second
expect 0 'the same' cmp first second
gate 2 --method libccd-mpr --pairs 500 --seed 2 --json other.json
without_times other.json >other
! cmp -s first other || failed 'another seed is the same gate'

# A cap on time cuts it: more pairs than any machine asks in a second.
gate 3 --for 1s --pairs 4000000000 --json cut.json --junit cut.xml
holds 'the cut' out '^NOT ASKED: sample of all strata: [0-9]+ of [0-9]+ rounds, since the time was over$'
holds 'a cut gate says that nothing fails' out '^Nothing that was asked fails the gate'
holds 'JSON has it' cut.json '"not_asked": \[$'
holds 'JUnit has it' cut.xml '<error type="not asked"'

# So does whoever stops it.
"$daylight" gate --for 1h --pairs 4000000000 --json stopped.json --junit stopped.xml >out 2>err &
stopped=$!
for _ in {1..6000}; do
  [[ -s err ]] && break
  sleep 0.1
done
kill -TERM "$stopped"
code=0
wait "$stopped" || code=$?
equal 'a stopped gate' 3 "$code"
holds 'what it did not ask' stopped.json 'rounds, since the gate was stopped"'
holds 'JUnit has it' stopped.xml '<error type="not asked"'

# What is sent about a guest has no path of ours.
liar='liar=while read -r q; do echo "{\"verdict\":\"disjoint\"}"; done'
gate 2 --command "$liar" --pairs 100 --junit liar.xml
! grep -qF -e "$source_tree" -e "$scratch" liar.xml || failed 'a path of ours is in what is sent'

# Against a base all of its pairs are asked, and what has grown is reported, or it is said what was not.
gate 0 --method libccd-mpr --against mpr.json
python3 - <<'END'
import json
base = json.load(open('mpr.json'))
grown = [failure for failure in base['failures'] if failure['severity'] == 'contract' and failure['count'] > 1
         and failure['kind'] != 'hang' and failure['failed_again'] == failure['reruns']]
assert grown, 'nothing failed on two pairs'
for failure in grown:
    failure['count'] -= 1
base['methods'].append({'name': 'somebody'})
json.dump(base, open('fewer.json', 'w'))
ours = json.load(open('ours.json'))
ours['laws'].append(999)
ours['cases'].append('0123456789abcdef')
ours['phases'][-1]['digest'] = '0123456789abcdef'
json.dump(ours, open('other.json', 'w'))
END
gate 2 --method libccd-mpr --against fewer.json
holds 'what has grown' out ' in the base'
holds 'a missing method' out '^NOT ASKED: method somebody, which the base has$'
again=$(sed -n '/^   replay */{s///p;q}' out)
[[ $again ]] || failed 'no line that replays'
expect 2 "$again" env PATH="$scratch/bin:$PATH" bash -c "$again"
holds 'what is true' out '^  truth: '
gate 0 --method intersect,decide --against ours.json
gate 3 --method intersect --against other.json
for what in 'method decide' 'law 999' '1 of [0-9]* cases' 'sample of close contacts: the pairs'; do
  holds 'not asked' out "^NOT ASKED: $what, which the base has\$"
done
gate 3 --method intersect,decide --against ours.json --for 1ms
gate 64 --against mpr.json --pairs 100
gate 64 --against mpr.json --seed 2
gate 64 --pairs 0
printf 'while read -r line; do echo '\''{"verdict":"undecided"}'\''; done\n' >src/silent.sh
gate 3 --command "silent=bash src/silent.sh" --cases '' --pairs 300
holds 'a doubt' out '^silent abstains on every pair'
gate 64 --method nobody
gate 65 --against ours.xml
gate 0 --laws
holds 'the laws' out ' swap '
