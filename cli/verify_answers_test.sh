#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# verify_answers_test.sh DAYLIGHT: certificates hold in exact arithmetic that is not ours, and not for other pairs.
set -euo pipefail
daylight=$1
exact=$(dirname -- "$(dirname -- "$(readlink -f -- "$0")")")/vectors/exact.py
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
{
  "$daylight" families flat_disks --count 100 --seed 3
  for family in {sphere,capsule}_{sphere,capsule,cylinder,rounded} {cylinder,rounded}_rounded; do
    [[ $family == capsule_sphere ]] || "$daylight" families "$family" --count 200 --seed 3
  done
} >"$folder/drawn.jsonl"
"$daylight" check --distance --clearance 0.02 "$folder/drawn.jsonl" >"$folder/answers.jsonl" || [[ $? == 3 ]]
python3 "$exact" "$folder/drawn.jsonl" "$folder/answers.jsonl"
cat "${exact%vectors/*}"corpus/cases/*.jsonl "$folder/drawn.jsonl" >"$folder/pairs.jsonl"
"$daylight" check --distance "$folder/pairs.jsonl" >"$folder/answers.jsonl" || [[ $? == 3 ]]
python3 "$exact" "$folder/pairs.jsonl" "$folder/answers.jsonl"
grep -q '"points"' "$folder/answers.jsonl" || { echo 'no certificate of two points'; exit 1; }
tac "$folder/answers.jsonl" >"$folder/reversed.jsonl"
! python3 "$exact" "$folder/pairs.jsonl" "$folder/reversed.jsonl" >"$folder/out" ||
  { echo 'answers to other pairs are believed'; exit 1; }
[[ $(grep -c 'does not separate' "$folder/out") -gt 10 && $(grep -c 'not in both' "$folder/out") -gt 10 &&
  $(grep -c 'not in the cores' "$folder/out") -gt 10 ]] ||
  { echo 'too few certificates fail for other pairs'; cat "$folder/out"; exit 1; }
