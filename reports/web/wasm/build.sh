#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compiles the solver to WebAssembly: reports/web/solver.wasm, which is committed, as the template of the pages is.
#     build.sh            writes it
#     build.sh --check    compares it with what these sources give; exit status 1 if it differs
# The same sources and packages give the same bytes. Contraction and fast mathematics are off, as in the native build.
set -euo pipefail
root=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../../.." && pwd)
cd -- "$root"
committed=reports/web/solver.wasm
packages='clang-14 lld-14 wasi-libc libc++-14-dev-wasm32 libclang-rt-14-dev-wasm32'

for needed in /usr/bin/clang++-14 /usr/bin/wasm-ld-14 /usr/include/wasm32-wasi/stdlib.h /usr/lib/llvm-14/include/wasm32-wasi/c++/v1/cmath \
  /usr/lib/llvm-14/lib/clang/14.0.6/lib/wasi/libclang_rt.builtins-wasm32.a /usr/include/eigen3/Eigen/Core; do
  [[ -e $needed ]] || exec .ci/skip "no $needed here, so nothing compiles the solver for the pages: apt-get install $packages"
done

scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
sources=()
for file in solver/*.cpp solver/detail/*.cpp reports/web/wasm/{answers,solver_main}.cpp; do
  [[ $file == *_test.cpp || $file == *_batch*.cpp ]] || sources+=("$file")
done
clang++-14 --target=wasm32-wasi -std=c++20 -O2 -ffp-contract=off -fno-math-errno -fno-exceptions -fno-rtti -DNDEBUG \
  -I. -isystem /usr/include/eigen3 -nostartfiles -fuse-ld=/usr/bin/wasm-ld-14 -Wl,--no-entry -Wl,--strip-all \
  -Wl,-z,stack-size=65536 -o "$scratch/solver.wasm" "${sources[@]}"
if [[ ${1-} == --check ]]; then
  cmp -- "$scratch/solver.wasm" "$committed" || { echo "$committed is not what the solver gives; run $0" && exit 1; }
else
  cp -- "$scratch/solver.wasm" "$committed"
fi
echo "$committed: $(stat -c %s "$committed") bytes"
