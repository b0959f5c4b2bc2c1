#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# export as a person calls it: a case of a file, a stored finding, exit codes, what is written.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"

unit='{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2}'
{
  printf '{"a":%s,"b":{"center":[3,0,0],"axis":[0,1,0],"radius":1,"height":2}}\n\n' "$unit"
  printf '{"a":%s,"b":{"center":[0,0,2.0000005],"axis":[0,0,1],"radius":1,"height":2}}\n' "$unit"
} >cases.jsonl

expect 0 'export' "$daylight" export cases.jsonl:3 --method fcl-indep --out sent
holds 'it was tried' out '^tested: it was built and run here, and shows the failure$'
for file in issue.md build.sh reproduce.cpp exact.py; do
  [[ -s sent/$file ]] || holds "sent/$file" out '^WRITTEN$'
done
expect 0 'the proof' python3 sent/exact.py
# One that shows nothing is not offered; one that cannot be built is said not to be tried.
printf '#!/bin/sh\nprintf "#!/bin/sh\\necho right\\n" >reproduce && chmod +x reproduce\n' >tame && chmod +x tame
expect 1 'a program that says "right"' env CXX="$PWD/tame" "$daylight" export cases.jsonl:3 --method fcl-indep --out tame_sent
holds 'what it printed' err '^right$'
[[ ! -e tame_sent ]] || failed 'a program that says "right" is offered'
expect 3 'no compiler' env CXX=false "$daylight" export cases.jsonl:3 --method fcl-indep --out untried
holds 'no compiler' out '^not tested: '

expect 64 'a pair on which it is right' "$daylight" export cases.jsonl:1 --method fcl-indep --out sent
holds 'what it says there' err 'is right on .*disjoint'
expect 64 'two pairs at once' "$daylight" export cases.jsonl --method fcl-indep --out sent
expect 64 'an empty line' "$daylight" export cases.jsonl:2 --method fcl-indep --out sent
expect 64 'no method' "$daylight" export cases.jsonl:3 --out sent
expect 64 'a method of ours' "$daylight" export cases.jsonl:3 --method seedbook-printed --out sent
expect 1 'nowhere to write' "$daylight" export cases.jsonl:3 --method fcl-indep --out cases.jsonl/sent
expect 0 'replay takes lines too' "$daylight" replay cases.jsonl:3 --methods intersect
holds 'one case' out '^1 replayed,'

mkdir runs
expect 2 'a run with findings' "$daylight" campaign --pairs 3000 --seed 3 --cases '' --methods libccd-mpr-tol1e-10 --out runs/one
id=$(grep -oE 'runs/one:[0-9]+' out | tail -n 1)
expect 0 'a stored finding names its method' "$daylight" export "$id" --out sent
holds 'the method' out '^libccd-mpr-tol1e-10, '
expect 64 'a cause of no run' "$daylight" export cases.jsonl libccd-mpr/wrong_disjoint --out sent
expect 64 'a run without that cause' "$daylight" export runs/one nobody/hang --out sent
holds 'what to do' err "runs/one has no cause 'nobody/hang': .daylight triage runs/one. lists its 0 causes"
