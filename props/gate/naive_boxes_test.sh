#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The gate passes naive_boxes.c, and not with a planted fault: some of the faults, or with `all` as $2 each of them.
set -euo pipefail
# shellcheck source=SCRIPTDIR/../../cli/expect.sh
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../../cli/expect.sh"
boxes=$source_tree/props/gate/naive_boxes.c
list() { sed -n 's/^ \* FAULT \([0-9]*\): \(.*[^ */]\).*/\1 \2/p' "$boxes"; }
pairs=3000 some='^(4|12|21|30) '
[[ ${2:-} == all ]] && pairs=30000 some='^[0-9]'
gate() { # CODE FAULT WHAT
  cc -std=c99 -O2 -shared -fPIC -I "$source_tree/oracles" -DFAULT="$2" "$boxes" -lm -o "boxes$2.so"
  expect "$1" "fault $2: $3" "$daylight" gate --plugin "./boxes$2.so" --pairs $pairs --cases '' --json gate.json
}

gate 0 0 none
python3 - <<END || failed 'the gate asks about boxes'
import json
[method] = json.load(open('gate.json'))['methods']
assert method['rounded']['pairs'] > 0.8 * $pairs and method['counts']['declined'] == 0, method
END
while read -r fault what; do gate 2 "$fault" "$what"; done < <(list | grep -E "$some")
