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
"$daylight" check --distance "$folder/pairs.jsonl" >"$folder/answers.jsonl" || [[ $? == 3 ]]
python3 "$root/tools/verify_answers.py" "$folder/pairs.jsonl" "$folder/answers.jsonl"
tac "$folder/answers.jsonl" >"$folder/reversed.jsonl"
! python3 "$root/tools/verify_answers.py" "$folder/pairs.jsonl" "$folder/reversed.jsonl" >"$folder/out" ||
  { echo 'answers to other pairs are believed'; exit 1; }
[[ $(grep -c 'does not separate' "$folder/out") -gt 10 && $(grep -c 'not in both' "$folder/out") -gt 10 ]] ||
  { echo 'too few certificates fail for other pairs'; cat "$folder/out"; exit 1; }
