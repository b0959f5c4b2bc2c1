#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# daylight chart on a small run: what it draws, and what it says where Node.js is missing.
set -euo pipefail
daylight=$1
skip=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")/.ci/skip
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cd -- "$work"

fail() {
  echo "FAILED: $*"
  exit 1
}

"$daylight" campaign --pairs 300 --seed 3 --methods intersect,fcl-libccd --cases '' --out 'runs/a b' --jobs 1 >/dev/null || [[ $? == 2 ]]

mkdir empty
if PATH=$work/empty /bin/bash -c '"$0" chart "runs/a b" --out charts' "$daylight" 2>said; then fail 'it draws without Node.js'; fi
grep -q 'apt-get install nodejs' said || fail "without Node.js it says: $(cat said)"
[[ ! -e charts ]] || fail 'without Node.js it leaves a folder'
if "$daylight" chart nowhere --out charts 2>/dev/null; then fail 'a run that is not there is drawn'; fi

command -v node >/dev/null || { "$skip" 'the drawing, no Node.js here: apt-get install nodejs' || exit; }
"$daylight" chart 'runs/a b' --out 'my charts' >files
grep -qx 'my charts/families.svg' files || fail "it names $(cat files)"
grep -q 'fcl-libccd' 'my charts/families.svg' || fail 'the method is not on the plot'
xmllint --noout 'my charts/families.svg' || fail 'no XML'
if command -v rsvg-convert >/dev/null; then
  [[ $(head -c 4 'my charts/families.png' | tail -c 3) == PNG ]] || fail 'no PNG'
else
  "$skip" 'PNG: apt-get install librsvg2-bin' || [[ $? == 77 ]]
fi
echo 'chart_test: all well'
