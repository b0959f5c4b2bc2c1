#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# daylight fuzz: what it reports if it cannot run. A real run is fuzz/guided/engine_test.sh.
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
