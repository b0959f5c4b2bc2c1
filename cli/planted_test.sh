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
lacks 'it plants no faults unasked' out '[sS][eE][lL][fF]-'
expect 0 'awake' "$daylight" "${run[@]}" --self-check --out runs/awake
holds 'it finds one' out '^self-check: 1 planted fault found, each after at most [0-9]+ pairs'
expect 0 'going on' "$daylight" campaign --resume runs/awake --pairs 2048
holds 'it finds another' out '^self-check: 2 planted faults found'
expect 1 'alone' bin/daylight "${run[@]}" --self-check --out runs/alone
holds 'what is missing' err '--self-check: daylight-mutants is not beside this executable'

# Blind: the worker finds the program as it is, whatever is planted.
cat >bin/daylight-mutants <<END
#!/bin/sh
# self-check --mutant N --seed N --first N --pairs N: of these only a few, which is enough to see nothing
seed=\$5 first=\$7
shift 9
exec '$mutants' self-check --mutant 0 --seed "\$seed" --first "\$first" --pairs 2000 "\$@"
END
chmod +x bin/daylight-mutants
expect 1 'blind' bin/daylight "${run[@]}" --self-check --out runs/blind
holds 'which fault' out '^SELF-CHECK FAILED: planted fault [0-9]+ \(.*\) was not found from index [0-9]+ on in [0-9]+ pairs'
holds 'what that means' err 'self-check failed'
