#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# verify_answers_test.sh DAYLIGHT: certificates hold in exact arithmetic that is not ours, and not for other pairs.
set -euo pipefail
daylight=$1
root=$(dirname -- "$(dirname -- "$(readlink -f -- "$0")")")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cat "$root"/corpus/cases/*.jsonl >"$folder/pairs.jsonl"
"$daylight" families flat_disks --count 100 --seed 3 >>"$folder/pairs.jsonl"
rounded='sphere_sphere sphere_capsule sphere_cylinder sphere_rounded capsule_capsule capsule_cylinder capsule_rounded
cylinder_rounded rounded_rounded'
for family in $rounded; do "$daylight" families "$family" --count 200 --seed 3; done >>"$folder/pairs.jsonl"
for clearance in 0.02 0; do
  "$daylight" check --distance --clearance "$clearance" "$folder/pairs.jsonl" >"$folder/answers.jsonl" || [[ $? == 3 ]]
  python3 "$root/tools/verify_answers.py" "$folder/pairs.jsonl" "$folder/answers.jsonl"
done
grep -q '"points"' "$folder/answers.jsonl" || { echo 'no certificate of two points'; exit 1; }
tac "$folder/answers.jsonl" >"$folder/reversed.jsonl"
! python3 "$root/tools/verify_answers.py" "$folder/pairs.jsonl" "$folder/reversed.jsonl" >"$folder/out" ||
  { echo 'answers to other pairs are believed'; exit 1; }
[[ $(grep -c 'does not separate' "$folder/out") -gt 10 && $(grep -c 'not in both' "$folder/out") -gt 10 &&
  $(grep -c 'not in the cores' "$folder/out") -gt 10 ]] ||
  { echo 'too few certificates fail for other pairs'; cat "$folder/out"; exit 1; }
