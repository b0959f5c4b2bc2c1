#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# shard.sh I OUT : goes on with shard I of the campaign in OUT. What it found is in its store; only a harness that
# failed is a failure here.
set -euo pipefail

daylight=${DAYLIGHT:-$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../../build/release/daylight}
code=0
"$daylight" campaign --resume "$2/shard-$1" --jobs "${JOBS:-1}" || code=$?
case $code in
  0 | 2 | 3) exit 0 ;;
  *) exit "$code" ;;
esac
