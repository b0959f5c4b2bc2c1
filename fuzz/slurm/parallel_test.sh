#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Shards under GNU parallel, one killed on its way, give what one run gives.
set -euo pipefail

export DAYLIGHT=$1
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
command -v parallel >/dev/null || exec "$here/../../.ci/skip" 'no GNU parallel here: apt-get install parallel'
# shellcheck source=SCRIPTDIR/same_run.sh
source "$here/same_run.sh"
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
cd -- "$scratch"

run=(--seed 7 --pairs 60000 --methods intersect,fcl-libccd,bullet --families tiny_and_huge,random --cases '')
"$DAYLIGHT" campaign "${run[@]}" --out whole >/dev/null 2>&1 || [[ $? == 2 ]]
"$here/parallel.sh" 3 out "${run[@]}" >merged 2>&1 &
first=$!
kill_shard "$scratch/out" 1
code=0
wait "$first" || code=$?
[[ $code == 2 ]] || { cat merged; exit 1; }
grep -q 'shard 1 of 3 .* is running or was killed' merged || { cat merged; exit 1; }
code=0
"$here/parallel.sh" 3 out "${run[@]}" >merged 2>&1 || code=$?
[[ $code == 2 ]] || { cat merged; exit 1; }
! grep '^incomplete' merged || { cat merged; exit 1; }
same_run whole out
