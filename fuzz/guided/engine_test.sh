#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# engine_test.sh DAYLIGHT PROGRAM: some seconds of daylight fuzz with a target that libFuzzer drives.
set -euo pipefail
# shellcheck source=SCRIPTDIR/../../cli/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../../cli/expect.sh"
program=$2 # absolute

for seconds in 5 20 80 320; do # until both have worked
  rm -rf run
  expect 0 'a real run' "$daylight" fuzz --for "${seconds}s" --jobs 2 --seed 1 --out run --program "$program"
  [[ $(grep -cE '^worker [12]: [1-9][0-9]+ executions' out) == 2 ]] && break
done
equal 'both workers worked' 2 "$(grep -cE '^worker [12]: [1-9][0-9]+ executions' out)"
holds 'strata were visited' out '^strata: [1-9][0-9]+ of'
# What is left of the corpora visits every stratum that the workers visited.
(cd run/corpus && DAYLIGHT_FUZZ_OUT=$scratch/again "$program" -runs=0 . >/dev/null 2>&1)
expect 0 'the merged corpus visits all strata' python3 - <<'PYTHON'
strata = lambda folder: {i for i, seen in enumerate(open(folder + '/visited', 'rb').read()[8:]) if seen}
run = strata('run/worker-1') | strata('run/worker-2')
assert run and not run - strata('again'), f'{len(run - strata("again"))} of {len(run)} strata lost'
PYTHON
