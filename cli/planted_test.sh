#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A campaign finds the faults that are planted on its way; one whose comparison sees nothing ends red.
set -euo pipefail

daylight=$(readlink -f -- "$1")
mutants=$(dirname -- "$daylight")/daylight-mutants
source_tree=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
cd -- "$scratch"
mkdir -p runs props/mutants bin
cp -- "$source_tree/props/mutants/kill_matrix.jsonl" props/mutants/
cp -- "$daylight" bin/daylight

# expect CODE COMMAND.. : runs it into out and err.
expect() {
  local code=$1 got=0
  shift
  "$@" >out 2>err || got=$?
  [[ $got == "$code" ]] || { echo "exit code $got, not $code: $*"; cat out err; exit 1; }
}
holds() { grep -qE -- "$2" "$1" || { echo "no line of $1 matches $2"; cat -- "$1"; exit 1; }; }

run=(campaign --seed 7 --cases '' --methods 'intersect,decide,distance,exact' --pairs 1024) # one moment lies below
expect 0 "$daylight" "${run[@]}" --out runs/none
! grep -i alarm out || { echo 'a short run plants no faults unasked'; exit 1; }
expect 0 "$daylight" "${run[@]}" --alarm --out runs/awake
holds out '^alarm: 1 planted fault found, each within its usual time, after [0-9]+ pairs at most'
expect 0 "$daylight" campaign --resume runs/awake --pairs 2048
holds out '^alarm: 2 planted faults found'
expect 1 bin/daylight "${run[@]}" --alarm --out runs/alone
holds err '--alarm: daylight-mutants is not beside this executable'

# Blind: the worker finds the program as it is, whatever is planted.
cat >bin/daylight-mutants <<END
#!/bin/sh
# alarm --mutant N --seed N --first N --pairs N: of these only a few, which is enough to see nothing
seed=\$5 first=\$7
shift 9
exec '$mutants' alarm --mutant 0 --seed "\$seed" --first "\$first" --pairs 2000 "\$@"
END
chmod +x bin/daylight-mutants
expect 1 bin/daylight "${run[@]}" --alarm --out runs/blind
holds out '^ALARM: planted fault [0-9]+ \(.*\), from index [0-9]+ on, was not found in [0-9]+ pairs'
holds err 'the harness sleeps'
