#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# daylight fuzz: what it reports if it cannot run, and a campaign over a corpus. A real run is fuzz/guided/engine_test.sh.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"

expect 64 'no duration' "$daylight" fuzz --for never
expect 64 'no such target' "$daylight" fuzz --target all
expect 1 'no program' "$daylight" fuzz --for 1s --out none --program 'no program'
holds 'it says so' err 'cannot run'
mkdir alone
cp -- "$daylight" alone/daylight
expect 1 'without clang' alone/daylight fuzz
holds 'what to install' err 'apt-get install clang'

# A campaign asks every method about the pairs of a corpus. The middle one is not finite, and the last is right.
mkdir corpus
python3 - <<'END'
import struct
coins = [0, 0, 0, 0, 0, 1, 3, 1, 2, 0, 1, -1, 0, 25, 4, 1]
for name, numbers in ('coins', coins), ('infinite', [float('inf')] + coins[1:]), ('right', coins[:8] + [9, 0, 0, 0, 0, 1, 1, 1]):
    open('corpus/' + name, 'wb').write(struct.pack('16d', *numbers))
END
expect 2 'a corpus' "$daylight" campaign --corpus corpus --cases '' --methods ode,decide --pairs 2 --seed 1 --table --out run
holds 'a corpus' out '^ode +2 +- +- +1 '
expect 2 'its finding' "$daylight" replay run:1
holds 'its finding' out '^  ode .*wrong_disjoint'
expect 2 'resumed' "$daylight" campaign --resume run --pairs 10 --table
holds 'resumed' out '^decide +10 '
rm corpus/right
expect 1 'another corpus' "$daylight" campaign --resume run --pairs 20
holds 'another corpus' err 'its case_count was'
head -c 5 /dev/zero >corpus/short
expect 1 'no record' "$daylight" campaign --corpus corpus --out none
holds 'no record' err 'corpus/short: a record has 128 bytes'
