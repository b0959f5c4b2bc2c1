#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# daylight fuzz: what it reports if it cannot run, and a campaign over a corpus. A real run is fuzz/guided/engine_test.sh.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"

expect 64 'no duration' "$daylight" fuzz --for never
expect 64 'no such target' "$daylight" fuzz --target all
mkdir alone
cp -- "$daylight" alone/daylight
expect 1 'without clang' alone/daylight fuzz
holds 'what to install' err 'apt-get install clang'

expect 64 'no time' "$daylight" campaign --fuzz 25% --pairs 100 --out none
holds 'no time' err 'is a share of the time'
for share in 25 0% 100% x%; do expect 64 'no share' "$daylight" campaign --fuzz "$share" --for 1s --out none; done
expect 2 'no fuzzer' alone/daylight campaign --fuzz 50% --for 1s --cases '' --methods ode --seed 1 --out without
holds 'no fuzzer' out '^not fuzzed: no fuzzer is built here'

# A campaign asks every method about the pairs of a corpus, once, and then about changes of them. The second pair is not
# finite, the fourth is the first again, and the third is right.
mkdir -p corpus/core
python3 - <<'END'
import struct
coins = [0, 0, 0, 0, 0, 1, 3, 1, 0, 2, 0, 1, -1, 0, 25, 4, 1, 0]
right = coins[:9] + [9, 0, 0, 0, 0, 1, 1, 1, 0]
box = [0, 0, 0, 1, 0, 0, 0]  # no edges, the quaternion of no rotation
for name, numbers in ('coins', coins), ('infinite', [float('inf')] + coins[1:]), ('right', right), ('core/coins', coins):
    open('corpus/' + name, 'wb').write(struct.pack('Q16dQ16d', 0, *numbers[:9], *box, 0, *numbers[9:], *box))
END
asks=(campaign --cases '' --families random --methods 'ode,decide' --seed 1)
expect 2 'a corpus' "$daylight" "${asks[@]}" --corpus corpus --pairs 90 --table --out run
holds 'a corpus' out '^ode +90 '
python3 - <<'END'
import sqlite3
asked = dict(sqlite3.connect('run/run.sqlite').execute("SELECT family, asked FROM tally WHERE method='ode'"))
assert asked == {'fuzzed': 80, 'random': 10}, asked
END
expect 2 'its finding' "$daylight" replay run:1
holds 'its finding' out '^  ode .*wrong_disjoint'
rm -r corpus # the run has its own
expect 2 'resumed' "$daylight" campaign --resume run --pairs 180 --table
holds 'resumed' out '^decide +180 '
expect 2 'another run' "$daylight" "${asks[@]}" --corpus run/corpus --pairs 90 --out again
for shard in 0 1; do
  expect 2 'a shard' "$daylight" "${asks[@]}" --corpus run/corpus --pairs 5000 --shard "$shard/2" --out "shard-$shard"
done
rm shard-1/corpus/right
expect 2 'merged' "$daylight" merge shard-0 shard-1 --out merged
equal 'the corpora are merged' 'coins core core/coins infinite right' "$(cd merged/corpus && echo $(find * | sort))"
rm run/corpus/right
expect 1 'another corpus' "$daylight" campaign --resume run --pairs 200
holds 'another corpus' err 'its corpus_fingerprint was'
head -c 128 /dev/zero >again/corpus/short
expect 1 'an old record' "$daylight" campaign --corpus again/corpus --out none
holds 'an old record' err 'corpus/short is not a record of this version'
expect 1 'no corpus' "$daylight" campaign --corpus nothing --out none
