#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# daylight chart on a small run: what it draws, and what it says where Node.js is missing.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"
skip=$source_tree/.ci/skip

expect 2 'a run' "$daylight" campaign --pairs 300 --seed 3 --methods intersect,fcl-libccd --cases '' --out 'runs/a b' --jobs 1
mkdir empty
expect 1 'without Node.js' env PATH="$scratch/empty" "$daylight" chart 'runs/a b' --out charts
holds 'without Node.js' err 'apt-get install nodejs'
[[ ! -e charts ]] || failed 'without Node.js it leaves a folder'
expect 64 'a run that is not there' "$daylight" chart nowhere --out charts

command -v node >/dev/null || { "$skip" 'the drawing, no Node.js here: apt-get install nodejs' || exit; }
expect 0 'a drawing' "$daylight" chart 'runs/a b' --out 'my charts'
holds 'it names the file' out '^my charts/map-angle-margin-fcl-libccd.svg$'
holds 'the method is on the plot' 'my charts/map-angle-margin-fcl-libccd.svg' fcl-libccd
expect 0 'XML' xmllint --noout 'my charts/map-angle-margin-fcl-libccd.svg'
