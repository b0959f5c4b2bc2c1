# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# Sourced by the tests that call the executable as a person does: what is held, each failure told and counted.
failures=0

# expect CODE NAME COMMAND..: runs it into out and err.
expect() {
  local code=$1 name=$2 got=0
  shift 2
  "$@" >out 2>err || got=$?
  if [[ $got != "$code" ]]; then
    printf '%s: exit code %s, not %s\n' "$name" "$got" "$code"
    cat out err
    failures=$((failures + 1))
  fi
}
# holds NAME FILE PATTERN
holds() {
  if ! grep -qE -- "$3" "$2"; then
    printf '%s: no line of %s matches %s\n' "$1" "$2" "$3"
    cat -- "$2"
    failures=$((failures + 1))
  fi
}
