#!/bin/bash -eu
# SPDX-License-Identifier: MIT
# Builds the targets as OSS-Fuzz and ClusterFuzzLite ask for it: $CC $CXX $CFLAGS $CXXFLAGS $LIB_FUZZING_ENGINE, sources
# in $SRC/daylight, into $OUT.
build=${WORK:-/tmp}/daylight
cmake -S "$SRC/daylight/fuzz/oss-fuzz" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None \
  -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_CXX_FLAGS="$CXXFLAGS"
ninja -C "$build" fuzz_core_libfuzzer fuzz_xcheck_libfuzzer make_records
"$build/make_records" "$SRC/daylight/corpus/cases" "$build/records"
for target in core xcheck; do
  cp "$build/fuzz_${target}_libfuzzer" "$OUT/fuzz_$target"
  (cd "$build/records" && python3 -m zipfile -c "$OUT/fuzz_${target}_seed_corpus.zip" ./*)
  printf '[libfuzzer]\nmax_len = 272\nlen_control = 0\ntimeout = 25\n' >"$OUT/fuzz_$target.options"
done
