#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The manual page and the shell's completion of the executable $1 know every command and option that --help has.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"

"$daylight" --man-page >page
"$daylight" --bash-completion >completion
commands=$("$daylight" --help | sed -n 's/^  \([a-z]*\)  .*/\1/p')
[[ $(wc -w <<<"$commands") -ge 17 ]] || failed 'no commands in --help'
# shellcheck disable=SC1091
source ./completion
completed() { # words of a command line, the last to be completed
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
  _daylight
  printf '%s\n' "${COMPREPLY[@]}"
}
for command in $commands; do
  holds 'a section' page "^\.SH daylight $command\$"
  grep -qx -- "$command" <<<"$(completed daylight "${command:0:2}")" || failed "$command is not completed"
  for option in $("$daylight" "$command" --help | sed -n 's/^  \(--[a-z-]*\).*/\1/p'); do
    grep -qF -- "${option//-/\\-}" page || failed "the page lacks $option of $command"
    grep -qx -- "$option" <<<"$(completed daylight "$command" "$option")" ||
      failed "$option of $command is not completed"
  done
done
equal 'what is no option' '' "$(completed daylight campaign --nothing)"
if command -v man >/dev/null; then
  equal 'man complains of nothing' '' "$(MANROFFSEQ='' LC_ALL=C.UTF-8 MANWIDTH=100 man --warnings -l page 2>&1 >/dev/null)"
fi
