#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The manual page and the shell's completion of the executable $1 know every command and option that --help has.
set -euo pipefail

daylight=$1
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
cd -- "$scratch"
fail() { printf 'FAILED: %s\n' "$1"; exit 1; }

"$daylight" --man-page >page
"$daylight" --bash-completion >completion
commands=$("$daylight" --help | sed -n 's/^  \([a-z]*\)  .*/\1/p')
[[ $(wc -w <<<"$commands") -ge 17 ]] || fail 'no commands in --help'
# shellcheck disable=SC1091
source ./completion
completed() { # words of a command line, the last to be completed
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
  _daylight
  printf '%s\n' "${COMPREPLY[@]}"
}
for command in $commands; do
  grep -q "^\.SH daylight $command\$" page || fail "no section of $command"
  completed daylight "${command:0:2}" | grep -qx -- "$command" || fail "$command is not completed"
  for option in $("$daylight" "$command" --help | sed -n 's/^  \(--[a-z-]*\).*/\1/p'); do
    grep -qF -- "${option//-/\\-}" page || fail "the page lacks $option of $command"
    completed daylight "$command" "$option" | grep -qx -- "$option" || fail "$option of $command is not completed"
  done
done
[[ -z $(completed daylight campaign --nothing) ]] || fail 'what is no option is completed'
if command -v man >/dev/null; then
  [[ -z $(MANROFFSEQ='' LC_ALL=C.UTF-8 MANWIDTH=100 man --warnings -l page 2>&1 >/dev/null) ]] || fail 'man complains of the page'
fi
echo passed
