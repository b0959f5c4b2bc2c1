#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# engine_test.sh DAYLIGHT PROGRAM: some seconds of daylight fuzz with a target that libFuzzer drives.
set -euo pipefail
# shellcheck source=SCRIPTDIR/../../cli/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../../cli/expect.sh"
program=$2 # absolute

for seconds in 5 20 80 320; do # until two jobs have ended
  rm -rf run
  expect 0 'a real run' "$daylight" fuzz --for "${seconds}s" --jobs 2 --seed 1 --out run --program "$program"
  grep -qE '^features: [1-9]' out && break
done
holds 'it worked' out '^executions: [1-9]'
holds 'jobs have ended' out '^features: [1-9]'
holds 'no harmless input ends a process' out '^inputs that ended a process: 0$'
visited=$(sed -n 's/^strata: \([0-9]*\) of.*/\1/p' out)
# What is left of the corpora visits every stratum that the jobs visited.
(cd run/corpus && DAYLIGHT_FUZZ_OUT=$scratch/again "$program" -runs=0 . >/dev/null 2>&1)
again=$(python3 -c 'import sys; print(sum(seen != 0 for seen in open(sys.argv[1], "rb").read()[8:]))' again/visited)
equal 'the merged corpus visits all strata' "$visited" "$again"

# A killed run leaves no process once its jobs have ended, and the next one completes it.
"$daylight" fuzz --for 10m --jobs 2 --seed 2 --out killed --program "$program" >/dev/null 2>&1 &
until compgen -G 'killed/unfinished/jobs/*/C1/*' >/dev/null; do sleep 0.1; done
kill -KILL $!
for _ in {1..600}; do pgrep -f "$scratch/killed" >/dev/null || break; sleep 0.1; done
! pgrep -fa "$scratch/killed" || failed 'no process is left'
expect 0 'the next run' "$daylight" fuzz --for 1s --jobs 1 --out killed --program "$program"
holds 'it has the inputs' out '^corpus: [1-9][0-9]* inputs'
