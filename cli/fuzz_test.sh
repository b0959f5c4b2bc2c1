#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# daylight fuzz: what it says where it cannot run; where clang has built the target, some seconds of it.
set -euo pipefail

daylight=$1
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

failures=0
expect() { # what, wanted, got
  [[ $2 == "$3" ]] && return
  printf 'FAILED: %s\n  wanted: %s\n  got:    %s\n' "$1" "$2" "$3"
  failures=$((failures + 1))
}
run() { # leaves out, err and code
  code=0
  "$daylight" fuzz "$@" >"$scratch/out" 2>"$scratch/err" </dev/null || code=$?
  out=$(<"$scratch/out") err=$(<"$scratch/err")
}

run --for never
expect 'no duration: exit code' 64 "$code"
run --target all
expect 'no such target: exit code' 64 "$code"
run --for 1s --out "$scratch/none" --program "$scratch/no program"
expect 'no program: exit code' 1 "$code"
expect 'no program: it says so' yes "$([[ $err == *'cannot run'* ]] && echo yes)"
mkdir "$scratch/alone"
cp -- "$daylight" "$scratch/alone/daylight"
code=0
"$scratch/alone/daylight" fuzz >"$scratch/out" 2>"$scratch/err" || code=$?
expect 'without clang: exit code' 1 "$code"
expect 'without clang: what to install' yes "$(grep -q 'apt-get install clang' "$scratch/err" && echo yes)"

here=$(dirname -- "$daylight")
for folder in "$here" "$here/../clang"; do
  [[ -x $folder/fuzz_core_libfuzzer ]] && program=$folder/fuzz_core_libfuzzer && break
done
if [[ -z ${program-} ]]; then
  "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../.ci/skip" 'a real run: apt-get install clang, ninja -C build/clang fuzz_core_libfuzzer' ||
    [[ $? == 77 ]]
else
  for seconds in 5 20 80 320; do # until both have worked
    rm -rf -- "$scratch/run"
    run --for "${seconds}s" --jobs 2 --seed 1 --out "$scratch/run" --program "$program"
    [[ $(grep -cE '^worker [12]: [1-9][0-9]+ executions' <<<"$out") == 2 ]] && break
  done
  expect 'a real run: exit code' 0 "$code"
  expect 'a real run: both workers worked' 2 "$(grep -cE '^worker [12]: [1-9][0-9]+ executions' <<<"$out")"
  expect 'a real run: strata were visited' yes "$(grep -qE '^strata: [1-9][0-9]+ of' <<<"$out" && echo yes)"
  # What is left of the corpora visits every stratum that the workers visited.
  (cd "$scratch/run/corpus" && DAYLIGHT_FUZZ_OUT=$scratch/again "$program" -runs=0 . >/dev/null 2>&1)
  expect 'the merged corpus visits all strata' '' "$(python3 - "$scratch" <<'PYTHON'
import sys
strata = lambda file: {i for i, seen in enumerate(open(file, 'rb').read()[8:]) if seen}
run = strata(sys.argv[1] + '/run/worker-1/visited') | strata(sys.argv[1] + '/run/worker-2/visited')
again = strata(sys.argv[1] + '/again/visited')
if not run or run - again: print(f'{len(run - again)} of {len(run)} strata lost')
PYTHON
)"
fi
((failures == 0))
