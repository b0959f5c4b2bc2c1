#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What scene --srdf-out disables as "Never" never touches, as a sampler sees it that shares no line with us.
set -euo pipefail

here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
# shellcheck source=SCRIPTDIR/expect.sh
source "$here/expect.sh"
for python in python3 /usr/bin/python3; do "$python" -c 'import numpy' 2>/dev/null && break; done
"$python" -c 'import numpy' 2>/dev/null || exec "$here/../.ci/skip" 'no NumPy here: apt-get install python3-numpy'

samples=("$python" "$here/../tools/sample_srdf.py" "$here/every_joint.urdf")
expect 3 'an SRDF' "$daylight" scene "$here/every_joint.urdf" --configurations 20 --srdf-out every.srdf
expect 0 'no Never touches' "${samples[@]}" every.srdf --configurations 5000
holds 'of all kinds' out '^44 pairs "Never", 0 wrong in 5000 configurations'
for pair in 'vane" link2="peg' 'cart" link2="drone'; do
  sed "s|</robot>|<disable_collisions link1=\"$pair\" reason=\"Never\"/></robot>|" every.srdf >false.srdf
  expect 1 "a false Never of $pair" "${samples[@]}" false.srdf --configurations 5000
  holds 'which' out '^WRONG: '
done
