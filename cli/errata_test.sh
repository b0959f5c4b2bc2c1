#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# errata as a person calls it: every fault is shown today, the list is what the program writes, each fault is a method.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"

expect 0 'all' "$daylight" errata
holds 'the first' out '^2017-coincident-centers: '
holds 'the last' out '^book-equal-eigenvalues: '
holds 'one wrong' out '^  wrong     seed2008-only-radius says disjoint$'
holds 'one right' out '^  proof     .*"verdict":"intersecting"'

expect 0 'the list' "$daylight" errata --markdown
cmp -s out "$source_tree/solver/literature/errata.md" ||
  failed 'solver/literature/errata.md is not what daylight errata --markdown writes'

expect 0 'one, counted' "$daylight" errata book-sign-of-p0 --pairs 200
holds 'its rate' out 'wrong of 200 pairs a family: .*touching_rim_rim [0-9]'
expect 64 'an unknown one' "$daylight" errata 2017-nothing
holds 'what there is' err '2017-one-octant'

grep '"id":"erratum-2017-one-octant"' "$source_tree/corpus/cases/errata.jsonl" >case.jsonl
expect 0 'one fault alone' "$daylight" check --method seed2017-only-one-octant case.jsonl
holds 'is wrong' out '"verdict":"intersecting"'
expect 0 'without it' "$daylight" check --method seed2017-without-one-octant case.jsonl
expect 2 'a campaign asks it' "$daylight" campaign --pairs 200 --seed 1 --families touching_disks --cases '' \
  --methods seed2017-only-one-octant --table --out run
holds 'that one alone' out '^seed2017-only-one-octant +25 '
expect 2 'a run with it is replayed' "$daylight" replay run
holds 'by its name' out 'seed2017-only-one-octant'
