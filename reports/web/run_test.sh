#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The tests of the page that need Node.js:
#     run_test.sh data       the prover, the filters and the charts
#     run_test.sh browser    a reader of the page; needs chromium, and npm ci in this folder
#     run_test.sh build      the types are right, and a build gives the committed bytes; needs npm ci in this folder
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")"

build() {
  [[ node_modules/.package-lock.json -nt package-lock.json ]] ||
    exec ../../.ci/skip 'no npm packages here, or old ones: npm ci --prefix reports/web'
  node_modules/.bin/tsc
  node build.mjs --check
}

command -v node >/dev/null || exec ../../.ci/skip 'no Node.js here: apt-get install nodejs'
case $1 in
  data) node --test run/data_test.mjs parts/prove_test.mjs ;;
  browser) node run/page_test.mjs ;;
  build) build ;;
esac
