#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A campaign in shards on this machine, or on those that PARALLEL names, with GNU parallel; then the merge.
#     fuzz/slurm/parallel.sh SHARDS OUT OPTION..      fuzz/slurm/parallel.sh 8 runs/night --for 8h --fuzz 25%
# Called again it goes on where the stores stand. The exit code is that of `daylight merge`.
set -euo pipefail

[[ $# -ge 2 ]] || { sed -n '3,5s/^# \?//p' "$0" >&2; exit 64; }
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
DAYLIGHT=$(readlink -f -- "${DAYLIGHT:-$here/../../build/release/daylight}")
export DAYLIGHT
shards=$1
mkdir -p -- "$2"
out=$(readlink -f -- "$2")
shift 2
"$here/create.sh" "$shards" "$out" "$@"
seq 0 "$((shards - 1))" | parallel --will-cite --joblog "$out/jobs.log" "$here/shard.sh" {} "$out" '>>' "$out/task-{}.log" '2>&1' || true
exec "$DAYLIGHT" merge "$out"/shard-* --out "$out"
