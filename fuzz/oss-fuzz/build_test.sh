#!/bin/bash
# SPDX-License-Identifier: MIT
# Runs build.sh as the service does, with the clang at hand, then what it has built, with nothing but $OUT.
set -euo pipefail
source=$(cd -- "$(dirname -- "$0")/../.." && pwd)
command -v clang++ >/dev/null || exec "$source/.ci/skip" 'no clang++ here: apt-get install clang'
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/src" "$folder/out" "$folder/work" "$folder/seeds"
ln -s "$source" "$folder/src/daylight"
export SRC=$folder/src OUT=$folder/out WORK=$folder/work CC=clang CXX=clang++
export CFLAGS='-O1 -g -fsanitize=address,fuzzer-no-link' LIB_FUZZING_ENGINE=-fsanitize=fuzzer
export CXXFLAGS=$CFLAGS
"$SRC/daylight/fuzz/oss-fuzz/build.sh"
for target in core xcheck; do
  for file in "" .options _seed_corpus.zip; do [ -s "$OUT/fuzz_$target$file" ] || { echo "no fuzz_$target$file"; exit 1; }; done
done
python3 -m zipfile -e "$OUT/fuzz_core_seed_corpus.zip" "$folder/seeds"
cd "$folder"
env -i "$OUT/fuzz_core" -max_len=272 -len_control=0 -seed=1 -runs=0 seeds
# The methods as printed are wrong, so this one must abort, and name the cause.
python3 -m zipfile -e "$OUT/fuzz_xcheck_seed_corpus.zip" "$folder/seeds"
if env -i "$OUT/fuzz_xcheck" -max_len=272 -len_control=0 -seed=1 -max_total_time=600 seeds 2>log; then
  echo 'nothing found in the methods as printed'; exit 1
fi
grep -E '^DEDUP_TOKEN: [a-p]{12}$' log
