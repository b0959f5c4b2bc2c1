# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# Sourced by the tests that call the executable as a person does. They begin in an empty folder that goes away with them;
# each failure is reported and counted, and any of them fails the test.
daylight=$(readlink -f -- "${1:-none}")
source_tree=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
scratch=$(mktemp -d)
failures=0
trap 'code=$?; rm -rf -- "$scratch"; exit $((failures ? 1 : code))' EXIT
cd -- "$scratch"
touch out err

# failed NAME: shows what the last command wrote.
failed() {
  printf 'FAILED: %s\n' "$1"
  head -c 4000 out err
  failures=$((failures + 1))
}
# expect CODE NAME COMMAND..: runs it into out and err.
expect() {
  local code=$1 name=$2 got=0
  shift 2
  timeout 800 "$@" >out 2>err || got=$?
  [[ $got == "$code" ]] || failed "$name: exit code $got, not $code"
}
# holds NAME FILE PATTERN, lacks NAME FILE PATTERN: some line matches, or none does.
holds() { grep -qE -- "$3" "$2" || failed "$1: no line of $2 matches $3"; }
lacks() { ! grep -E -- "$3" "$2" || failed "$1: a line of $2 matches $3"; }
# page_data FILE: the JSON that a page holds.
page_data() { "$source_tree/reports/web/page_data.py" "$1"; }
# equal NAME WANTED GOT
equal() { [[ $2 == "$3" ]] || failed "$1: '$3', not '$2'"; }
