#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Pairs out, answers in: judged as a campaign of the same pairs would, in any order; a line that is wrong costs itself.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"

# Balls around the two: wrong of many, declines some, breaks on some.
cat >balls.py <<'END_OF_PROGRAM'
import json, math, sys

print(json.dumps({'name': 'balls', 'version': '1', 'claim': {'relative': 1e-3, 'source': 'a guess'}}), flush=True)
for line in sys.stdin:
    pair = json.loads(line)
    a, b = pair['a'], pair['b']
    reach = sum(math.hypot(c['radius'], c['height'] / 2) for c in (a, b))
    apart = math.dist(a['center'], b['center']) > reach
    said = {'verdict': 'disjoint' if apart else 'intersecting'}
    if a['radius'] == 0:
        said = {'declined': 'a segment'}
    elif b['radius'] == 0:
        said = {'error': 'no convergence'}
    if 'id' in pair:
        said['id'] = pair['id']
    print(json.dumps(said), flush=True)
END_OF_PROGRAM

expect 0 'pairs out' "$daylight" ask --pairs 1500 --seed 7 --out pairs.jsonl
[[ $(wc -l <pairs.jsonl) == 1500 ]] || failed 'not 1500 pairs'
expect 0 'pairs to standard output' "$daylight" ask --pairs 1500 --seed 7
cmp -s out pairs.jsonl || failed 'standard output has other pairs'
expect 0 'they are pairs' "$daylight" check pairs.jsonl
python3 balls.py <pairs.jsonl >answers.jsonl

# counts FILE: what the table says of the method and its families, but for the time.
counts() { awk '/^(balls|  [a-z_]+) / { NF = 7; print }' "$1" | sed '/^referee/,$d'; }
expect 2 'a campaign of the same' "$daylight" campaign --pairs 1500 --seed 7 --command 'python3 balls.py' --methods balls --table --out run
counts out >campaign
expect 2 'answers in' "$daylight" judge answers.jsonl --pairs pairs.jsonl --keep failing.jsonl
counts out >judged
diff campaign judged || failed 'judged otherwise than a campaign'
[[ $(wc -l <judged) -gt 5 ]] || failed 'no table'
holds 'the worst' out '^wrong_intersecting \(beyond its claim, margin .*: [0-9]+ findings\. The worst has the id [0-9]+, answers.jsonl:[0-9]+:$'
holds 'its proof' out '^  truth: disjoint\. A plane with normal'
holds 'what it said' out '^  balls: \{"verdict":"intersecting"\}$'
holds 'its claim' out '^claim: always right if the gap or overlap exceeds 0\.001 size'
[[ ! -s err ]] || failed 'complains of nothing'
expect 2 'what is kept' "$daylight" replay failing.jsonl --command 'python3 balls.py' --methods balls
holds 'all of it fails' out "^$(wc -l <failing.jsonl) replayed, $(wc -l <failing.jsonl) beyond a claim"
holds 'with the proof' failing.jsonl '"truth":"disjoint","note":"balls: wrong_intersecting .*, proof \{.*direction'

(head -n 1 answers.jsonl; tail -n +2 answers.jsonl | shuf --random-source=pairs.jsonl) >shuffled.jsonl
expect 2 'in any order' "$daylight" judge shuffled.jsonl --pairs pairs.jsonl
counts out | sort >judged_shuffled
sort judged | diff - judged_shuffled || failed 'the order of the answers counts'
expect 2 'from a pipe' bash -c '"$1" judge - --pairs pairs.jsonl <answers.jsonl' - "$daylight"
counts out | diff judged - || failed 'a pipe is judged otherwise'

# A claim of the command line is the one that counts; whoever claims less is less at fault.
expect 2 'another claim' "$daylight" judge answers.jsonl --pairs pairs.jsonl --claim 0.9 --name other
holds 'all within it' out '^other +1500 +[0-9]+ +[0-9]+ +- +[0-9]+ '

# Right answers: only what was wrong with the lines counts.
"$daylight" check --method exact pairs.jsonl | awk '{ sub(/}$/, ",\"id\":" NR "}"); print }' >right.jsonl
expect 0 'right answers' "$daylight" judge right.jsonl --pairs pairs.jsonl --name right
holds 'no fault' out '^right +1500 +- +- +- +- +- '
expect 64 'nobody is named' "$daylight" judge right.jsonl --pairs pairs.jsonl
holds 'says so' err 'do not name their method'
sed -e '11d' -e '20s/.*/&\n&/' -e '30s/.*/{"id":30,"verdict":"perhaps"}/' -e '40s/^./(/' -e '50s/"id":50/"id":"x50"/' \
  -e '60s/,"id":60//' right.jsonl >wrong.jsonl
expect 2 'wrong lines' "$daylight" judge wrong.jsonl --pairs pairs.jsonl --name right
holds 'they cost themselves' out '^right +1500 +- +6 +- +- +- '
holds 'a doubled one' err '^wrong.jsonl:20: id "20" was answered on line 19 already$'
holds 'a strange word' err '^wrong.jsonl:30: the verdict is "perhaps"'
holds 'no JSON' err '^wrong.jsonl:40: not JSON'
holds 'an unknown id' err '^wrong.jsonl:50: id "x50" is of no question$'
holds 'no id' err '^wrong.jsonl:60: no id'
holds 'a missing one' err '^pairs.jsonl:11: no answer$'
holds 'what it costs' err '^pairs.jsonl:40: no answer$'
holds 'passed over' out '^3 lines do not answer a pair$'
[[ $(wc -l <err) == 9 ]] || failed 'not 9 lines reported'
sed 's/.*/&\n/; 5s/"radius":[^,]*/"radius":-1/; 6s/"id":"6"/"id":"7"/' pairs.jsonl >bad_pairs.jsonl
expect 2 'wrong pairs' "$daylight" judge right.jsonl --pairs bad_pairs.jsonl --name right
holds 'no pair' err '^bad_pairs.jsonl:9: column [0-9]+: a.radius is negative'
holds 'an id twice' err '^bad_pairs.jsonl:13: id "7" stands on line 11 already$'
holds 'its answer is of nothing' err '^right.jsonl:5: id "5" is of no question$'
holds 'the rest counts' out '^right +1498 '

# Answers that have their own pairs need no other file.
paste -d, <(sed 's/,"id".*//' pairs.jsonl) <(sed 's/^{//' right.jsonl) >both.jsonl
expect 0 'pairs within' "$daylight" judge both.jsonl --name right
holds 'all of them' out '^right +1500 +- +- +- +- +- '
