#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The tests of the page that need Node.js:
#     run_test.sh data       the prover, the filters, the charts, and that what is committed was built from what is committed
#     run_test.sh browser    a reader of the page; needs chromium, and playwright-core from npm ci in this folder
#     run_test.sh scene DAYLIGHT    the same of the page of a scene, written by the executable DAYLIGHT
#     run_test.sh rebuild    a build from nothing gives the committed bytes; needs npm and its registry
# Exit status 77, and why, where something is missing.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")"

skip() {
  echo "skipped: $*"
  exit 77
}

scene() {
  scratch=$(mktemp -d)
  trap 'rm -rf -- "$scratch"' EXIT
  "$1" scene ../../corpus/scenes/twenty.urdf --configurations 300 --verify --page "$scratch/scene.html"
  node study_page_test.mjs "$scratch/scene.html"
}

rebuild() {
  command -v npm >/dev/null || skip "no npm here"
  copy=$(mktemp -d)
  trap 'rm -rf -- "$copy"' EXIT
  cp -- *.ts *.tsx *.mjs *.css *.html *.json .npmrc "$copy"
  cd "$copy"
  if ! npm ci --omit=dev --prefer-offline >"$copy/log" 2>&1; then
    timeout 20 npm ping >/dev/null 2>&1 || skip "the registry of npm cannot be reached"
    cat "$copy/log"
    exit 1
  fi
  node build.mjs --check
}

command -v node >/dev/null || skip "no Node.js here (apt-get install nodejs)"
case $1 in
  data) node --test data_test.mjs prove_test.mjs ;;
  browser) node page_test.mjs ;;
  scene) scene "$2" ;;
  rebuild) rebuild ;;
esac
