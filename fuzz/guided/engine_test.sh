#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# engine_test.sh DAYLIGHT: nights of some seconds with the programs that libFuzzer drives, which are beside it.
set -euo pipefail
# shellcheck source=SCRIPTDIR/../../cli/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../../cli/expect.sh"

for seconds in 5 20 80 320; do # until a job has ended
  rm -rf run
  expect 0 'a real run' "$daylight" fuzz --for "${seconds}s" --jobs 2 --seed 1 --out run --target core
  [[ $(find run/corpus/core -type f | wc -l) -gt 1 ]] && break
done
holds 'it worked' out '^fuzzed core: [1-9][0-9]* executions'
holds 'no harmless input ends a process' out 'deaths 0'
holds 'its corpus was asked' out '^pairs: [1-9]'

# A night that is killed leaves no process once its jobs have ended, and goes on when it is resumed.
"$daylight" campaign --fuzz 50% --for 40s --jobs 2 --seed 2 --methods ode,decide --out killed >/dev/null 2>&1 &
until compgen -G 'killed/fuzz/core/jobs/*/C1/*' >/dev/null; do sleep 0.1; done
kill -KILL $!
for _ in {1..600}; do pgrep -f "$scratch/killed" >/dev/null || break; sleep 0.1; done
! pgrep -fa "$scratch/killed" || failed 'no process is left'
expect 2 'resumed' "$daylight" campaign --resume killed
holds 'it fuzzed' out '^fuzzed core: [1-9]'
holds 'both targets' out '^fuzzed xcheck: [1-9]'
[[ -n $(ls killed/corpus/core) && -n $(ls killed/corpus/xcheck) && ! -e killed/fuzz/core ]]
expect 2 'what it found is in the run' "$daylight" triage killed --for 10s

# A plug-in is asked in the fuzzer's process. Its crashes and hangs are findings and end nothing.
cat >mine.cpp <<'END'
#include <cstdlib>
#include "plugin.h"
namespace {
int ask(const double* a, const double* b, double*) {
  if (a[7] > 40 * a[6]) std::abort();
  if (b[7] > 40 * b[6]) *static_cast<volatile int*>(nullptr) = 1;
  if (a[6] > 40 * a[7])
    for (volatile int i = 0;; i = 1) continue;
  return DAYLIGHT_DECLINED;
}
const DaylightMethod mine{DAYLIGHT_PLUGIN_ABI, "mine", "1", 1e-6, 0, "a guess", ask};
}  // namespace
const DaylightMethod* daylight_method() { return &mine; }
END
clang++ -O1 -shared -fPIC -fsanitize=fuzzer-no-link -I "$source_tree/oracles" mine.cpp -o libmine.so
expect 2 'a plug-in' "$daylight" fuzz --plugin ./libmine.so --for 30s --jobs 2 --seed 1 --out guest
holds 'fuzzed' out '^fuzzed plugin-mine: [1-9]'
python3 - <<'END' || failed 'crashes and hangs are findings'
import sqlite3
db = sqlite3.connect('guest/run.sqlite')
kinds = sorted(row[0] for row in db.execute("SELECT DISTINCT kind FROM finding WHERE method='mine'"))
assert kinds and set(kinds) <= {'crash', 'hang'}, kinds
END
