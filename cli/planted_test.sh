#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A campaign finds the faults that are planted on its way; one whose comparison sees nothing ends red.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"
mutants=$(dirname -- "$daylight")/daylight-mutants
mkdir -p runs props/mutants bin
cp -- "$source_tree/props/mutants/kill_matrix.jsonl" props/mutants/
cp -- "$daylight" bin/daylight

run=(campaign --seed 7 --cases '' --methods 'intersect,decide,distance,exact' --pairs 1024) # one moment lies below
expect 0 'a short run' "$daylight" "${run[@]}" --out runs/none
lacks 'it plants no faults unasked' out '[aA][lL][aA][rR][mM]'
expect 0 'awake' "$daylight" "${run[@]}" --alarm --out runs/awake
holds 'it finds one' out '^alarm: 1 planted fault found, each within its usual time, after [0-9]+ pairs at most'
expect 0 'going on' "$daylight" campaign --resume runs/awake --pairs 2048
holds 'it finds another' out '^alarm: 2 planted faults found'
expect 1 'alone' bin/daylight "${run[@]}" --alarm --out runs/alone
holds 'what is missing' err '--alarm: daylight-mutants is not beside this executable'

# Blind: the worker finds the program as it is, whatever is planted.
cat >bin/daylight-mutants <<END
#!/bin/sh
# alarm --mutant N --seed N --first N --pairs N: of these only a few, which is enough to see nothing
seed=\$5 first=\$7
shift 9
exec '$mutants' alarm --mutant 0 --seed "\$seed" --first "\$first" --pairs 2000 "\$@"
END
chmod +x bin/daylight-mutants
expect 1 'blind' bin/daylight "${run[@]}" --alarm --out runs/blind
holds 'which fault' out '^ALARM: planted fault [0-9]+ \(.*\), from index [0-9]+ on, was not found in [0-9]+ pairs'
holds 'what that means' err 'the harness sleeps'
