#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Every command that asks methods takes guests; what they do costs the guest, never the run; a run finds its own again.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"
mkdir -p runs elsewhere

# Always apart, but for a third of the pairs, by their height: then a crash, an exception or a strange word.
cat >bad.cpp <<'END'
#include <cstdlib>
#include <stdexcept>
#include "plugin.h"
static int ask(const double* a, const double*, double*) {
  const unsigned kind = static_cast<unsigned>(a[7] * 1e6) % 9;
  if (kind == 0) std::abort();
  if (kind == 1) throw std::runtime_error("no luck");
  if (kind == 2) return 77;
  return DAYLIGHT_DISJOINT;
}
static const DaylightMethod bad{DAYLIGHT_PLUGIN_ABI, "bad", "1", 0, 0, 0, ask, 0};
const DaylightMethod* daylight_method() { return &bad; }
END
c++ -std=c++17 -shared -fPIC -I "$source_tree/oracles" bad.cpp -o libbad.so
cat >worse.sh <<'END'
n=0
while read -r q; do
  n=$((n + 1))
  case $((n % 40)) in
    7) echo 'no shape' >&2; exit 3 ;;
    17) kill -SEGV $$ ;;
    27) echo 'loading' ;;
    37) head -c 100000 /dev/zero | tr '\0' ' '; echo ;;
    *) echo '{"verdict":"disjoint"}' ;;
  esac
done
END
cat >plain.sh <<'END'
while read -r q; do echo '{"verdict":"disjoint"}'; done
END
guests=(--plugin ./libbad.so --command 'sh worse.sh')
pair='{"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2.00000512},"b":{"center":[9,0,0],"axis":[0,0,1],"radius":1,"height":2}}'
printf '%s\n' "$pair" >pair.jsonl

expect 2 'campaign' "$daylight" campaign --pairs 400 --seed 7 --cases '' --methods decide,bad,worse "${guests[@]}" --table --out runs/bad
holds 'campaign' out '^bad +400 +[1-9][0-9]+ +[1-9]'
holds 'campaign' out '^worse +400 +[1-9][0-9]+ +[1-9]'
holds 'what it takes not' out '^unsupported by bad, so not asked: sphere, capsule, rounded, half_space, box, rounded_box$'
python3 - <<'END' || failed 'guests take families from others'
import sqlite3
counts = "SELECT asked - declined FROM tally WHERE family = 'sphere_sphere' AND method = ?"
asked = lambda method: sqlite3.connect('runs/bad/run.sqlite').execute(counts, (method,)).fetchone()[0]
assert asked('decide') > 0 and asked('bad') == 0
END
holds 'campaign' out '^decide +400 +- +- '
expect 2 'replay' "$daylight" replay runs/bad --methods bad
holds 'replay' out 'finding of bad, crash \(beyond its claim\): stands$'
holds 'replay' out '"failed":"crash","reason":"SIGABRT"'
holds 'replay' out '"failed":"exception","reason":"no luck"'
holds 'replay' out '"failed":"malformed","reason":"no answer: 77 is no word of plugin.h"'
expect 2 'replay' "$daylight" replay runs/bad --methods worse # the store of a run tells where its guests are, seen from anywhere
cd elsewhere
expect 2 'replay' "$daylight" replay ../runs/bad --methods bad,worse
expect 2 'campaign' "$daylight" campaign --resume ../runs/bad --pairs 500 --table
holds 'campaign' out '^worse +500 '
cd ..

expect 0 'check' "$daylight" check "${guests[@]}" --method bad pair.jsonl
holds 'check' out '^\{"verdict":"disjoint","method":"bad"\}$'
expect 0 'check' "$daylight" check --command 'sh worse.sh' pair.jsonl
holds 'check' out '^\{"verdict":"disjoint","method":"worse"\}$'
expect 64 'check' "$daylight" check "${guests[@]}" pair.jsonl
expect 0 'check' "$daylight" check --command 'us=sh worse.sh' --method us pair.jsonl
# A library that states what it supports is asked about that, and one built for interface 2 still loads.
cat >balls.c <<'END'
#include "plugin.h"

#include <math.h>
#include <stdlib.h>

static int ask(const double* a, const double* b, double* more) {
  if (a[6] != 0 || a[7] != 0 || b[6] != 0 || b[7] != 0 || a[8] < 0.01 || b[8] > 100) abort();
  more[0] = sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2])) - a[8] - b[8];
  return more[0] > 0 ? DAYLIGHT_DISJOINT : DAYLIGHT_INTERSECTING;
}

static const struct DaylightMethod balls = {.abi = ABI, .name = "balls", .claim_relative = 1e-9, .ask = ask, .takes_rounding = 1,
    .shapes = DAYLIGHT_SPHERE + SHAPES, .least_length = 0.01, .greatest_length = 100};
const struct DaylightMethod* daylight_method(void) { return &balls; }
END
balls() { cc -shared -fPIC -I "$source_tree/oracles" -DABI="$1" -DSHAPES="$2" balls.c -lm -o "$3"; }
balls 3 0 libballs.so && balls 2 0 libballs2.so && balls 3 16 libshapes.so
expect 0 'gate of spheres' "$daylight" gate --plugin ./libballs.so --pairs 3000 --json balls.json
python3 - <<'END' || failed 'the gate draws what the library supports'
import json
[method] = json.load(open('balls.json'))['methods']
assert method['rounded']['pairs'] >= 2800 and method['counts']['declined'] == 0, method['counts']
END
expect 0 'campaign of spheres' "$daylight" campaign --plugin ./libballs.so --methods balls --pairs 300 --seed 1 --cases '' --table --out runs/of_balls
holds 'campaign of spheres' out '^balls +300 '
# A new version is asked about the pairs that an earlier run drew: the eight of its own run are right.
mkdir -p nights
sed 's/  return more\[0\] >/  if (a[8] > 5 * b[8]) return DAYLIGHT_DISJOINT;\n&/' balls.c >newer.c
cc -shared -fPIC -I "$source_tree/oracles" -DABI=3 -DSHAPES=0 newer.c -lm -o libnewer.so
for night in balls:1000:1 newer:8:2; do
  IFS=: read -r version pairs seed <<<"$night"
  expect 0 "a night of $version" "$daylight" campaign --plugin "balls=./lib$version.so" --methods balls --cases '' --pairs "$pairs" --seed "$seed" \
    --out "nights/$version"
done
expect 0 'a night' "$daylight" triage nights/balls
expect 2 'a fault of the new version' "$daylight" triage nights/newer
holds 'a fault of the new version' out '^1 new cause$'
holds 'a fault of the new version' out '^balls \([0-9a-f]+\) is wrong beyond its claim on [1-9][0-9]+ of the [0-9]+ pairs of balls that were asked again, on which version \([0-9a-f]+\) was right$'
# A fault that is wrong on more pairs of the same kind is new too, although the run kept only the first of them.
sed 's/5 \* b\[8\]/3 * b[8]/' newer.c >newest.c
cc -shared -fPIC -I "$source_tree/oracles" -DABI=3 -DSHAPES=0 newest.c -lm -o libnewest.so
mkdir -p more
for version in newer newest; do
  expect 2 "a night of $version" "$daylight" campaign --plugin "balls=./lib$version.so" --methods balls --cases '' --pairs 1000 --seed 1 \
    --out "more/$version"
  expect 2 "triage of $version" "$daylight" triage "more/$version" --new-only
done
holds 'more of a known fault' out '^2 new causes \(1 beyond a claim\)$'
holds 'more of a known fault' out 'is wrong beyond its claim on [1-9][0-9]+ of the [0-9]+ pairs of newer that were asked again'
expect 0 'its pair' "$daylight" export nights/newer balls/wrong_disjoint --out newer
expect 0 'the version before' "$daylight" replay newer/case.jsonl --methods balls --plugin balls=./libballs.so
# A library may limit positions, return upper bounds of depths, and stop measuring at a length.
# bounds NAME BEYOND DEPTH: measures up to 2, but says so of gaps above BEYOND. Its depths are DEPTH times the true ones.
bounds() {
  sed "s/abort();/&\n  for (int i = 0; i < 3; ++i) if (fabs(a[i]) > 50 || fabs(b[i]) > 50) abort();/
    s/  return more\[0\] > 0/  if (more[0] > 5.001) abort();\n  if (more[0] > $2) { more[0] = 2; return DAYLIGHT_BEYOND; }\n  if (more[0] < 0) more[0] *= $3;\n&/
    s/= ABI,/= 4, .greatest_coordinate = 50, .greatest_gap = 5, .depth = DEPTH,/" balls.c >bounds.c
  cc -shared -fPIC -I "$source_tree/oracles" -DDEPTH="${4:-1}" -DSHAPES=0 bounds.c -lm -o "$1.so"
}
asked() { expect "$1" "$2" "$daylight" gate --plugin "./$2.so" --pairs 3000 --cases ''; }
bounds kept 2 3 && asked 0 kept
bounds not_so_far 1.5 3 && asked 2 not_so_far
holds 'apart by more than 2' out 'distance_at_least|distance'
bounds deeper 2 0.5 && asked 2 deeper
bounds exact 2 3 0 && asked 2 exact
bounds other 2 3 7
expect 64 'a depth that is none' "$daylight" gate --plugin ./other.so --pairs 100
holds 'a depth that is none' err 'its depth is not one of DaylightDepth'
expect 2 'interface 2' "$daylight" gate --plugin ./libballs2.so --pairs 100 --cases ''
holds 'interface 2' out 'crash'
expect 64 'shapes that are none' "$daylight" gate --plugin ./libshapes.so --pairs 100
holds 'shapes that are none' err 'its shapes are not a sum of DaylightShapes'

# Structs: the plug-in of the guide is right, and all three ways to ask it say the same. A wrong plane is found.
awk '/^```cpp file=planes.cpp/ { open = 1; next } /^```/ { open = 0 } open' "$source_tree/docs/guides/library.md" >planes.cpp
sed 's|^const DaylightMethod planes|void ask_many(std::size_t n, const DaylightSolid* p, int* verdicts, double* more) {\
  for (std::size_t i = 0; i < n; ++i) verdicts[i] = ask(p + 2 * i, p + 2 * i + 1, more + 7 * i);\
}\
void ask_all(std::size_t n, const DaylightSolid* p, signed char* verdicts) {\
  double more[7];\
  for (std::size_t i = 0; i < n; ++i) verdicts[i] = static_cast<signed char>(ask(p + 2 * i, p + 2 * i + 1, more));\
}\
&|; s|  method.ask_solids = .*|&\
  method.ask_many_solids = ask_many;\
  method.ask_all_solids = ask_all;|' planes.cpp >planes_many.cpp
sed 's/r\[8\];/r[7];/' planes_many.cpp >planes_wrong.cpp
sed 's/ask_solids = .*/ask = [](const double*, const double*, double*) { return -1; };/' planes.cpp >planes_flat.cpp
for version in planes planes_many planes_wrong planes_flat; do
  c++ -std=c++17 -shared -fPIC -I "$source_tree/oracles" $version.cpp -o lib$version.so
done
for version in planes:0 planes_many:0 planes_wrong:2 planes_flat:64; do
  expect "${version#*:}" "$version" "$daylight" gate --plugin "./lib${version%:*}.so" --pairs 1000 --cases ''
done
holds 'half-spaces in doubles' err 'it lists half-spaces or boxes; set ask_solids'
for version in planes planes_many; do
  expect 0 "campaign of $version" "$daylight" campaign --plugin ./lib$version.so --methods planes --pairs 300 --seed 1 --cases '' --table --out runs/$version
  holds "campaign of $version" out '^planes +300 '
done
expect 0 'bench of half-spaces' "$daylight" bench --plugin ./libplanes_many.so --methods planes --families half_space_sphere --pairs 20 --min-time 0.001 --passes 1
holds 'bench of half-spaces' out '^planes +.*batch'

# A program that crashes on every pair is not started for each of 3,000 pairs.
printf '%s\n' 'echo start >>starts' 'read -r _' "echo '{\"verdict\":\"disjoint\"}'" 'read -r _' 'exit 1' >dies.sh
expect 2 'a program that crashes' "$daylight" gate --command 'sh dies.sh' --pairs 3000 --cases '' --json dies.json
holds 'a program that crashes' out "^NOT ASKED: dies, after it had crashed too often: a program that catches exceptions"
(($(wc -l <starts) < 400)) || failed "a program that crashes: $(wc -l <starts) starts"

expect 2 'gate' "$daylight" gate --plugin ./libbad.so --pairs 100 --cases ''
holds 'gate' out '^bad +1 \([0-9a-f]{8}\) '
holds 'gate' out "\| .*replay - --methods bad --plugin '?bad="
expect 0 'bench' "$daylight" bench "${guests[@]}" --methods bad,worse,decide --families random --pairs 20 --min-time 0.001 --passes 1
holds 'bench' out '^bad +verdict'
holds 'bench' out '^worse: times of a line there and a line back through a pipe'
expect 2 'worst' "$daylight" worst --plugin ./libbad.so --method bad --evaluations 20 --feature side-side --from pair.jsonl
expect 0 'campaign' "$daylight" campaign --list "${guests[@]}"
holds 'campaign' out '^  worse +unversioned'

# Triage: causes, simple pairs, proofs and programs as of any method's findings.
expect 2 'campaign' "$daylight" campaign --pairs 150 --seed 7 --cases '' --methods decide,bad,worse,plain "${guests[@]}" --command 'sh plain.sh' --out runs/three
# triage RUN OPTION..: with more time until every finding of a guest that is here was looked at.
triage() {
  local seconds code
  for seconds in 2 8 32 128; do
    code=0
    "$daylight" triage "$@" --for "${seconds}s" >out 2>err || code=$?
    grep -q 'findings remain: run triage again' out || break
  done
  equal 'triage' 2 "$code"
}
causes() { triage runs/three "$@"; }
causes
for key in bad/wrong_disjoint bad/crash/sigabrt bad/exception/no-luck bad/malformed/ worse/crash/ plain/wrong_disjoint; do
  holds 'triage' out "^\* $key"
done
expect 2 'replay' "$daylight" replay "$(grep -l bad/wrong_disjoint runs/three/causes/*.jsonl | head -n 1)" --methods bad
sed 's/int ask(.*/&\n  return DAYLIGHT_INTERSECTING;/' bad.cpp >good.cpp
sed 's/int ask(.*/&\n  if (a[7] >= 0) for (volatile int i = 0;;) i = i + 1;/' bad.cpp >endless.cpp
for name in good endless; do c++ -std=c++17 -shared -fPIC -I "$source_tree/oracles" $name.cpp -o $name.so; done
expect 0 'export' "$daylight" export runs/three bad/wrong_disjoint --out sent
holds 'export' out ': sent/case.jsonl, exact.py, issue.md$'
holds 'export' out '^ask it again: .* replay sent/case.jsonl --methods bad --plugin bad=/.*/libbad.so$'
expect 0 'sent/exact.py' python3 sent/exact.py
! grep -rIF -- "$PWD" sent || failed 'what is sent knows this machine'
again=$(sed -n 's/^    daylight //p' sent/issue.md)
equal 'the command' 'replay case.jsonl --methods bad --plugin bad=libbad.so' "$again"
cp libbad.so sent
cd sent
# shellcheck disable=SC2086
expect 2 'asked again' "$daylight" $again
holds 'asked again' out '^  bad .*wrong_disjoint'
cp ../good.so libbad.so
# shellcheck disable=SC2086
expect 0 'asked once it is right' "$daylight" $again
cd ..
expect 64 'export' "$daylight" export runs/three bad/wrong_disjoint --method decide --out sent
# One that was built anew is reported anew; one that hangs ends with the rest, one that is gone leaves its findings unreported.
causes --plugin good.so
holds 'triage' out '^\* bad/not-again'
lacks 'the cause of another build is kept' out bad/wrong_disjoint
expect 2 'campaign' "$daylight" campaign --pairs 12 --seed 7 --cases '' --methods bad --plugin ./libbad.so --out runs/few
triage runs/few --plugin ./endless.so
holds 'triage' out '^\* bad/'

# Shards.
for shard in 0 1; do
  expect 2 'campaign' "$daylight" campaign --shard $shard/2 --pairs 1200 --seed 7 --cases '' --methods decide,bad,worse "${guests[@]}" --out shards/$shard
done
expect 2 'merge' "$daylight" merge shards/0 shards/1 --out shards/all
expect 2 'replay' "$daylight" replay shards/all --methods bad

# What is missing or strange is said.
expect 64 'check' "$daylight" check --plugin ./nothing.so pair.jsonl
holds 'check' err 'nothing.so.*cannot open shared object'
lacks 'the file is named once' err 'nothing.so.*nothing.so'
expect 64 'check' "$daylight" check --command ./nothing pair.jsonl
holds 'check' err "'./nothing': asked about an easy pair, it failed: ended with status 127"
expect 64 'check' "$daylight" check --command 'decide=sh worse.sh' pair.jsonl
holds 'check' err 'there is a method decide already'
expect 64 'campaign' "$daylight" campaign --resume runs/bad --command 'sh worse.sh' --command 'new=sh worse.sh'
holds 'campaign' err 'has not asked new: a resumed run keeps its methods'
mv libbad.so moved.so
expect 1 'campaign' "$daylight" campaign --resume runs/bad --pairs 600
holds 'campaign' err 'runs/bad cannot be resumed: bad of runs/bad is not here: --plugin .*/libbad.so'
expect 0 'replay' "$daylight" replay runs/bad:1 --methods decide
holds 'replay' err 'bad of runs/bad is not here'
causes
holds 'triage' err '^daylight: bad of runs/three is not here'
[[ $(grep -c 'is not here' err) == 1 ]] || failed 'reported more than once'
holds 'triage' out '^[1-9][0-9]* findings are of guests that this machine does not have$'
holds 'triage' out '^\* plain/wrong_disjoint'
lacks 'something is reported of what is not here' out 'bad/'
expect 2 'campaign' "$daylight" campaign --resume runs/bad --pairs 600 --plugin ./moved.so
