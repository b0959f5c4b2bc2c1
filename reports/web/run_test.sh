#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The tests of the page that need Node.js:
#     run_test.sh data       the prover, the filters, the charts, and that what is built was built from these sources
#     run_test.sh browser    a reader of the page; needs chromium, and npm ci in this folder
#     run_test.sh scene DAYLIGHT    the same of the page of a scene, written by the executable DAYLIGHT
#     run_test.sh robot DAYLIGHT    the robots on such pages: joints, gaps, proofs, words, and the CSV
#     run_test.sh wasm PRINT_ANSWERS PAIRS [SEED]    the solver in WebAssembly answers as the native one
#     run_test.sh build      the types are right, and a build gives the committed bytes; needs npm ci in this folder
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")"

scene() {
  scratch=$(mktemp -d)
  trap 'rm -rf -- "$scratch"' EXIT
  "$1" scene ../../corpus/scenes/twenty.urdf --configurations 300 --verify --page "$scratch/scene.html"
  node scene/page_test.mjs "$scratch/scene.html"
}

robot() {
  scratch=$(mktemp -d)
  trap 'rm -rf -- "$scratch"' EXIT
  for file in crane.urdf arm.urdf porter.urdf twenty.urdf hand.xml walker.xml crane.xml; do
    proving=()
    [[ $file != crane.urdf && $file != arm.urdf ]] || proving=(--prove --boxes 20000)
    # 3 where something is not known, as of boxes
    "$1" scene "../../corpus/scenes/$file" --configurations 200 "${proving[@]}" --page "$scratch/$file.html" ||
      [[ $? == 3 ]]
  done
  node scene/robot_test.mjs "$scratch"/*.html
}

build() {
  [[ node_modules/.package-lock.json -nt package-lock.json ]] ||
    exec ../../.ci/skip 'no npm packages here, or old ones: npm ci --prefix reports/web'
  node_modules/.bin/tsc
  node build.mjs --check
}

command -v node >/dev/null || exec ../../.ci/skip 'no Node.js here: apt-get install nodejs'
case $1 in
  data) node --test run/data_test.mjs parts/prove_test.mjs ;;
  browser) node run/page_test.mjs && node run/tasks_test.mjs ;;
  scene) scene "$2" ;;
  robot) robot "$2" ;;
  wasm) node wasm/compare_test.mjs "${@:2}" ;;
  build) build ;;
esac
