#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# daylight fuzz: what it says where it cannot run; where clang has built the target, some seconds of it.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"

expect 64 'no duration' "$daylight" fuzz --for never
expect 64 'no such target' "$daylight" fuzz --target all
expect 1 'no program' "$daylight" fuzz --for 1s --out none --program 'no program'
holds 'it says so' err 'cannot run'
mkdir alone
cp -- "$daylight" alone/daylight
expect 1 'without clang' alone/daylight fuzz
holds 'what to install' err 'apt-get install clang'

here=$(dirname -- "$daylight")
for folder in "$here" "$here/../clang"; do
  [[ -x $folder/fuzz_core_libfuzzer ]] && program=$folder/fuzz_core_libfuzzer && break
done
if [[ -z ${program-} ]]; then
  "$source_tree/.ci/skip" 'a real run: apt-get install clang, ninja -C build/clang fuzz_core_libfuzzer' || [[ $? == 77 ]]
  exit
fi
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
