#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# mutants_test.sh ANSWERS MUTANT_ANSWERS DAYLIGHT DAYLIGHT_MUTANTS
# With no mutant selected the mutated build answers bit for bit as the ordinary one; with one, it does not; the
# ordinary executable has no switch in it.
set -euo pipefail
answers=$1 mutant_answers=$2 daylight=$3 daylight_mutants=$4
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

"$answers" >"$folder/ordinary"
DAYLIGHT_MUTANT=0 "$mutant_answers" >"$folder/mutated"
[[ $(wc -l <"$folder/ordinary") -gt 10000 ]] || { echo 'too few answers'; exit 1; }
cmp "$folder/ordinary" "$folder/mutated" || { echo 'the switches change answers though no mutant is selected'; exit 1; }
DAYLIGHT_MUTANT=101 "$mutant_answers" >"$folder/selected" || true
! cmp -s "$folder/ordinary" "$folder/selected" || { echo 'mutant 101 changes no answer: is it selected?'; exit 1; }

nm -C "$daylight_mutants" | grep ' cyl::selected_mutant$' >/dev/null || { echo 'no switch in daylight-mutants: does nm see names?'; exit 1; }
! nm -C "$daylight" | grep 'cyl::\(selected_mutant\|mutant_is\)' || { echo 'a switch in daylight'; exit 1; }
