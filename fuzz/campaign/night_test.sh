#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A night that is killed over and over ends as one that is left alone, and takes no more memory as it goes on.
#     fuzz/campaign/night_test.sh DAYLIGHT SECONDS INTERVAL [SUMMARY]
# Two campaigns of the same pairs, about SECONDS of work, run side by side on half of the processors each. One is left
# alone, and its memory watched; the other, with all its workers, is killed INTERVAL seconds after each start, or when it
# has stored something since, whichever is later (the first time as soon as it has), and gone on with. The figures go to
# standard output and to the file SUMMARY.
set -euo pipefail

[[ $# -ge 3 ]] || { sed -n '3,9s/^# \?//p' "$0" >&2; exit 64; }
daylight=$(readlink -f -- "$1")
seconds=$2 interval=$3 summary=$(readlink -f -- "${4:-/dev/null}")
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
# shellcheck source=SCRIPTDIR/slurm/same_run.sh
source "$here/../slurm/same_run.sh"
scratch=$(mktemp -d)
cd -- "$scratch"

# tree PID : it and all its descendants.
tree() {
  ps -e -o pid= -o ppid= | awk -v root="$1" '
    function walk(p,   i, n, kids) { print p; n = split(of[p], kids); for (i = 1; i <= n; ++i) walk(kids[i]) }
    { of[$2] = of[$2] " " $1 }
    END { walk(root) }'
}
kill_tree() { tree "$1" | xargs kill -KILL 2>/dev/null || true; }
clean_up() {
  local job
  for job in $(jobs -p); do kill_tree "$job"; done
  rm -rf -- "$scratch"
}
trap clean_up EXIT
trap 'exit 143' TERM INT

# All packaged methods but NLopt, which alone would take nearly all of the time. The case files may change meanwhile.
mkdir cases
cp -- "$here"/../../corpus/cases/*.jsonl cases/
jobs=$((($(nproc) + 1) / 2))
run=(--seed 20261122 --methods=-nlopt --cases cases)

# went_well CODE RUN : findings, and truths that nobody can prove, are no failure here.
went_well() {
  [[ $1 == 0 || $1 == 2 || $1 == 3 ]] && return
  echo "the campaign $2 ended with exit code $1"
  tail -n 20 "$2.log"
  return 1
}

# How many pairs are SECONDS of work, from a twentieth of that time.
code=0
"$daylight" campaign "${run[@]}" --jobs "$jobs" --for "$((seconds / 20 + 2))s" --out trial >trial.log 2>&1 || code=$?
went_well "$code" trial
read -r next milliseconds <<<"$(done_of trial)"
pairs=$((next * seconds * 1000 / milliseconds))
run+=(--pairs "$pairs")

"$daylight" campaign "${run[@]}" --jobs "$jobs" --out alone >alone.log 2>&1 &
alone=$!

killed_and_resumed() {
  local kills=0 stored='0 0' started code pid
  while true; do
    if [[ -e killed/run.sqlite ]]; then
      stored=$(done_of killed)
      "$daylight" campaign --resume killed --jobs "$jobs" >killed.log 2>&1 &
    else
      "$daylight" campaign "${run[@]}" --jobs "$jobs" --out killed >killed.log 2>&1 &
    fi
    pid=$!
    started=$SECONDS
    while kill -0 "$pid" 2>/dev/null && { ((kills > 0 && SECONDS - started < interval)) ||
      [[ $(done_of killed 2>/dev/null || echo "$stored") == "$stored" ]]; }; do
      sleep 0.1
    done
    if kill -0 "$pid" 2>/dev/null; then
      kill_tree "$pid"
      kills=$((kills + 1))
      echo "$kills" >kills
    fi
    code=0
    wait "$pid" 2>/dev/null || code=$?
    [[ $code == 137 ]] && continue
    went_well "$code" killed
    return
  done
}
killed_and_resumed 2>/dev/null & # bash tells each kill
killed=$!

# Seconds, KiB of the whole tree (what is shared counted once), KiB of the campaign's own process; 600 times or less. The
# page, which is written at the end, takes memory of its own, once: those samples do not count.
step=$((seconds / 600 + 1))
while kill -0 "$alone" 2>/dev/null && [[ $(done_of alone 2>/dev/null) != "$pairs "* ]]; do
  own=$(awk '/^VmRSS:/ { print $2 }' "/proc/$alone/status" 2>/dev/null) || own=
  all=$(for pid in $(tree "$alone"); do cat "/proc/$pid/smaps_rollup" 2>/dev/null || true; done | awk '/^Pss:/ { sum += $2 } END { print sum + 0 }')
  [[ $own ]] && echo "$SECONDS $all $own" >>memory
  sleep "$step"
done
code=0
wait "$alone" || code=$?
went_well "$code" alone
wait "$killed"

same=yes
same_run alone killed || same=no
kills=$(cat kills 2>/dev/null || echo 0)
python3 - "$pairs" "$kills" "$interval" "$same" "$(done_of alone)" "$(done_of killed)" <<'PY' | tee -- "$summary"
import sqlite3
import sys
pairs, kills, interval, same, alone, killed = sys.argv[1:]
failures = []
def check(holds, what):
    if not holds:
        failures.append(what)

# What the caches of SQLite (2 MB) and of malloc may take until they are full, and no more: a run that kept the text of
# each batch would gain that in some hundred batches.
rise_cap = 8192  # KiB over the run

def slope(samples):
    """Of a least squares line, and its standard error."""
    n = len(samples)
    mean_t, mean_y = sum(t for t, _ in samples) / n, sum(y for _, y in samples) / n
    spread = sum((t - mean_t) ** 2 for t, _ in samples)
    k = sum((t - mean_t) * (y - mean_y) for t, y in samples) / spread
    rest = sum((y - mean_y - k * (t - mean_t)) ** 2 for t, y in samples)
    return k, (rest / (n - 2) / spread) ** 0.5

def seconds(progress):
    return int(progress.split()[1]) / 1000

rows = [tuple(map(int, line.split())) for line in open('memory')]
rows = rows[len(rows) // 10:]  # what comes first is start
hours = (rows[-1][0] - rows[0][0]) / 3600
print(f'{pairs} pairs, left alone {seconds(alone):.0f} s; killed {kills} times, every {interval} s, and gone on with: '
      f'{seconds(killed):.0f} s in what it stored')
count = lambda run, what: sqlite3.connect(run + '/run.sqlite').execute(f'SELECT {what}').fetchone()[0]
print(f"findings {count('alone', '(SELECT count(*) FROM finding)')} kept of "
      f"{count('alone', '(SELECT sum(count) FROM finding_group)')}, in "
      f"{count('alone', '(SELECT count(*) FROM finding_group)')} groups; "
      f"tallies of {count('alone', '(SELECT sum(asked) FROM tally)')} calls: the same in both: {same}")
check(same == 'yes', 'the two runs differ')
check(alone.split()[0] == killed.split()[0] == pairs, 'not all pairs were done')
check(int(kills) > 0, 'it was never killed')
# Below that the campaign's own start is most of it.
shortest = 60  # seconds
if 3600 * hours < shortest:
    print(f'{3600 * hours:.0f} s of samples are too short to tell whether memory rises')
for name, column in () if 3600 * hours < shortest else (('the campaign with all its workers', 1), ("the campaign's own process", 2)):
    samples = [(row[0], row[column]) for row in rows]
    k, error = slope(samples)
    rise = k * (rows[-1][0] - rows[0][0])
    at = [samples[i][1] / 1024 for i in (0, len(samples) // 2, -1)]
    print(f'memory of {name}: {at[0]:.1f}, {at[1]:.1f}, {at[2]:.1f} MiB at the start, the middle and the end, at most '
          f'{max(y for _, y in samples) / 1024:.1f}; slope {k / 1024 * 3600:+.2f} +- {error / 1024 * 3600:.2f} MiB/h, '
          f'{rise / 1024:+.2f} MiB over the {len(rows)} samples')
    check(rise - 3 * error * hours * 3600 < rise_cap, f'memory of {name} rises')
for failure in failures:
    print('FAILED:', failure)
sys.exit(bool(failures))
PY
