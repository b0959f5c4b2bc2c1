#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# campaign and replay as a person calls them: what goes to which stream, the exit codes, going on, running again.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"
mkdir -p runs

run=(campaign --pairs 600 --seed 7 --cases '')

expect 0 'our methods' "$daylight" "${run[@]}" --methods intersect,decide --families random --table --out runs/ours
[[ $(head -n 1 out) == 'seed 7, run runs/ours' ]] || failed 'the seed comes first'
holds 'a row for the referee' out '^referee +600 '
holds 'what was judged' out '^pairs: 600, 0 undecided$'
holds 'ours' out '^our methods: 0 of 2 wrong beyond the claim or failed$'
holds 'the page is named' out 'runs/ours/report.html'
[[ -s runs/ours/report.html && $(readlink runs/latest) == ours ]] || failed 'page and latest'

expect 2 'a library beyond its claim' "$daylight" "${run[@]}" --methods fcl-libccd --families tiny_and_huge --out runs/fcl
[[ $(sed -n 2p out) == 'pairs: 600, '* ]] || failed 'no table without --table'
[[ $(grep -n '^CPU time' out | cut -d: -f1) -le 13 ]] || failed '13 lines'
holds 'who is wrong' out '^wrong beyond the claim: ([1-9] methods|1 method), [1-9][0-9,]* answers$'
holds 'who most' out '^  most: fcl-libccd[a-z0-9-]* [1-9]'
holds 'the worst is named' out '^worst finding( at ordinary sizes)?: fcl-libccd wrong_[a-z]+ \(beyond its claim\): daylight replay runs/fcl:[0-9]+$'
worst=$(sed -n 's/^worst finding.*: .* //p' out)

expect 2 'the worst stands' "$daylight" replay "$worst"
holds 'it says so' out '^  finding of fcl-libccd, wrong_[a-z]+ \(beyond its claim\): stands$'
holds 'the truth has a certificate' out '^  truth: (disjoint\. A plane with normal|intersecting\. The point)'
grep -m 1 -oE '\{"a".*\}$' out >cases.jsonl
expect 0 'without its method it does not' "$daylight" replay "$worst" --methods intersect
expect 2 'the whole run' "$daylight" replay runs/fcl --methods fcl-libccd
expect 2 'a file of cases' "$daylight" replay cases.jsonl --methods fcl-libccd
# Apart by 2^-4298 of their size, which no search of the referee reaches.
undecided='{"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2},"b":{"center":[-5e-324,2,0],"axis":[1,5e-324,0],"radius":1,"height":2}}'
printf '%s\n' "$undecided" >undecided.jsonl
expect 3 'an undecided truth' "$daylight" replay undecided.jsonl --methods intersect
holds 'it is counted' out '^1 replayed, 0 beyond a claim, 1 of undecided truth$'
expect 2 'a finding comes before it' "$daylight" replay undecided.jsonl cases.jsonl --methods fcl-libccd
printf '%s,"truth":"touching"}\n%s,"truth":"intersecting"}\n' "${undecided%\}}" '{"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2},"b":{"center":[0,3,0],"axis":[0,0,1],"radius":1,"height":2}' >wrong.jsonl
expect 65 'a wrong truth of a file' "$daylight" replay wrong.jsonl --methods intersect
holds 'it says so' out '^  the stored truth, intersecting, is refuted$'
holds 'one of two' out '^1 stored truth is wrong$'
cp -r runs/fcl runs/forged
python3 -c 'import sqlite3
with sqlite3.connect("runs/forged/run.sqlite") as run: run.execute("UPDATE judged_pair SET truth = ?", ["{\"verdict\":\"touching\"}"])'
expect 65 'a wrong truth of a run' "$daylight" replay runs/forged:1
rm -r runs/forged
expect 64 'no such finding' "$daylight" replay runs/fcl:999999
expect 64 'a resume that names no run' "$daylight" campaign --resume '' --pairs 3
expect 64 'no such run' "$daylight" replay nowhere

expect 0 'going on' "$daylight" campaign --resume runs/ours --pairs 900
holds 'to the new end' out '^pairs: 900, '
expect 0 'with time and pairs' "$daylight" "${run[@]}" --for 1h --methods intersect --families random --out runs/limits
expect 0 'a limit that is not given stays' "$daylight" campaign --resume runs/limits --for 1h
holds 'so nothing is left to do' out '^pairs: 600, '
expect 64 'no such run to go on with' "$daylight" campaign --resume nowhere
expect 64 'a folder without a run' "$daylight" replay runs
expect 64 'other cases' "$daylight" campaign --resume runs/limits --cases ''
holds 'the reason is said' err '^daylight: --cases cannot be given with --resume, because a resumed run keeps its settings'
for i in 0 1; do
  expect 0 "shard $i" "$daylight" "${run[@]}" --methods intersect --families random --shard "$i/2" --out "parts/$i"
done
expect 0 'merged' "$daylight" merge parts/0 parts/1 --out runs/merged
holds 'to all pairs' out '^pairs: 600, '
expect 3 'one is missing' "$daylight" merge parts/1 --out runs/merged
holds 'which is said' out '^  shard 0 of 2 is missing$'
expect 64 'not shards of one run' "$daylight" merge parts/0 runs/ours --out runs/other
expect 64 'no such shard' "$daylight" "${run[@]}" --shard 2/2 --out parts/2
expect 64 'going on with another seed' "$daylight" campaign --resume runs/ours --seed 8
expect 64 'over another run' "$daylight" "${run[@]}" --out runs/ours
expect 64 'no duration' "$daylight" campaign --for 5x
expect 64 'no method' "$daylight" campaign --methods nobody
expect 0 'the list' "$daylight" campaign --list
holds 'its families' out '^  random '

# What is printed names the same run tomorrow, when runs/latest is another.
cp -r runs/fcl runs/named && ln -sfn named runs/latest
expect 2 'triage of the latest' "$daylight" triage runs/latest --for 1s
holds 'the run it was' out '^page: runs/named/report.html$'
page_data runs/named/report.html >page.json
lacks 'no command of the latest' page.json 'runs/latest'
expect 2 'replay of the latest' "$daylight" replay "runs/latest/:${worst##*:}"
holds 'the finding it was' out '^runs/named:[0-9]+$'

"$daylight" campaign --for 1h --seed 7 --cases '' --methods intersect --out runs/gone >out 2>err &
campaign=$!
for _ in {1..600}; do
  [[ $(readlink runs/latest) == *gone ]] && break
  sleep 0.1
done
rm -rf runs/gone
code=0
wait "$campaign" || code=$?
equal 'a run that was removed: the exit code' 1 "$code"
holds 'a run that was removed' err '^daylight: runs/gone was removed while it was written$'

"$daylight" campaign --for 1h --seed 7 --cases '' --methods intersect --out runs/stopped >out 2>err &
campaign=$!
stored() {
  python3 -c 'import sqlite3
db = sqlite3.connect("file:runs/stopped/run.sqlite?mode=rw", uri=True)
print(db.execute("SELECT next FROM progress").fetchone()[0])' 2>/dev/null || echo 0
}
for _ in {1..6000}; do
  [[ $(stored) != 0 ]] && break
  sleep 0.1
done
expect 64 'a run that is being written' "$daylight" campaign --resume runs/stopped --pairs 300
holds 'a run that is being written' err 'runs/stopped is written by another process'
kill -INT "$campaign"
code=0
wait "$campaign" || code=$?
equal 'stopped: the exit code' 3 "$code"
holds 'how to go on' err 'stopped, resume with: daylight campaign --resume runs/stopped'
