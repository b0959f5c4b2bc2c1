#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A campaign on a Slurm cluster: one array task a shard, then a job that merges.
#     fuzz/slurm/submit.sh SHARDS OUT OPTION..      fuzz/slurm/submit.sh 64 runs/night --for 8h --fuzz 25%
# OUT lies where every node sees it. The options are those of `daylight campaign` but --shard and --out. A task that
# is requeued goes on where its store stands; to go on with a whole campaign, call this again. Prints the two job
# numbers. Slurm's own settings come from its environment: SBATCH_PARTITION, SBATCH_TIMELIMIT, ... . JOBS is the
# number of processors a task takes (1), DAYLIGHT the executable.
set -euo pipefail

[[ $# -ge 2 ]] || { sed -n '3,9s/^# \?//p' "$0" >&2; exit 64; }
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
DAYLIGHT=$(readlink -f -- "${DAYLIGHT:-$here/../../build/release/daylight}")
JOBS=${JOBS:-1}
export DAYLIGHT JOBS
shards=$1
mkdir -p -- "$2"
out=$(readlink -f -- "$2")
shift 2
"$here/create.sh" "$shards" "$out" "$@"

# %q: the text is read once by the shell of the job.
quote() { printf '%q ' "$@"; }
array=$(sbatch --parsable --job-name=daylight --requeue --open-mode=append --array="0-$((shards - 1))" \
  --cpus-per-task="$JOBS" --output="$out/task-%a.log" --wrap="exec $(quote "$here/shard.sh")\$SLURM_ARRAY_TASK_ID $(quote "$out")")
array=${array%%;*}
merge=$(sbatch --parsable --job-name=daylight-merge --requeue --open-mode=append --dependency="afterany:$array" \
  --output="$out/merge.log" --wrap="exec $(quote "$DAYLIGHT") merge $(printf %q "$out")/shard-* --out $(quote "$out")")
printf '%s %s\n' "$array" "${merge%%;*}"
