#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# errata as a person calls it: every fault is shown today as errata.md states, and each fault is a method.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"

expect 0 'all' "$daylight" errata
holds 'the first' out '^2017-coincident-centers$'
holds 'the last' out '^book-equal-eigenvalues$'
holds 'one wrong' out '^  wrong     seed2008-only-radius answers disjoint$'
holds 'one right' out '^  proof     .*"verdict":"intersecting"'
holds 'its kind' out '^In section .* Kind: gap in the argument\.$'
holds 'its numbers' out 'rho = 3/2: printed 2 <'
while read -r test; do
  grep -rqE "TEST(_P|_F)?\(${test/./, }\)" "$source_tree/solver/literature" || failed "no test $test"
done < <(grep -A 1 '^\* \*\*Checked by\*\*' out | grep -o '`[^`]*`' | tr -d '`')
holds 'who has <= 0' out 'In section 1 two capsules intersect if'
holds 'who returns false' out 'as section 6 does'
holds 'minimizers tend to do well' out 'numerical minimizers'
holds 'where the determinant is 0' out 'Only then, or if r0 r1 = 0'
holds 'what we polish' "$source_tree/solver/literature/readings.md" '^\* We polish, as no document does'

# A section that states another pair or another answer is not so today.
mkdir -p "$PWD/other/share/daylight/solver/literature" other/bin
cp "$daylight" other/bin
cp -r "$source_tree/corpus" other/share/daylight
sed 's/`seed2008-only-radius` answers disjoint/`seed2008-only-radius` answers intersecting/' "$source_tree/solver/literature/errata.md" \
  >other/share/daylight/solver/literature/errata.md
expect 2 'a wrong section' other/bin/daylight errata
[[ $(grep -c 'THIS IS NOT SO TODAY' out) == 1 ]] || failed 'one section is wrong'

expect 0 'one, counted' "$daylight" errata book-sign-of-p0 --pairs 200
holds 'its rate, which no polish mends' out 'wrong of 200 pairs a family: .*touching_rim_rim [456][0-9]'
expect 64 'an unknown one' "$daylight" errata 2017-nothing
holds 'what there is' err '2017-one-octant'

grep '"id":"erratum-2017-one-octant"' "$source_tree/corpus/cases/errata.jsonl" >case.jsonl
expect 0 'one fault alone' "$daylight" check --method seed2017-only-one-octant case.jsonl
holds 'is wrong' out '"verdict":"intersecting"'
expect 0 'without it' "$daylight" check --method seed2017-without-one-octant case.jsonl
expect 2 'a campaign asks it' "$daylight" campaign --pairs 200 --seed 1 --families touching_disks --cases '' \
  --methods seed2017-only-one-octant --table --out run
holds 'that one alone' out '^seed2017-only-one-octant +200 '
expect 2 'a run with it is replayed' "$daylight" replay run
holds 'by its name' out 'seed2017-only-one-octant'
