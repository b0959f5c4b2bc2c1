#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Follows every guide as it is written: writes its files, runs its commands with the executable given as $1, and
# compares the exit code of the last of each block with the one that the block states (0 where it states none). Of
# those before it any may find something (2).
set -euo pipefail

daylight=$(readlink -f -- "$1")
guides=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
mkdir -p -- "$scratch/bin"
ln -s -- "$daylight" "$scratch/bin/daylight"
export PATH=$scratch/bin:$PATH DAYLIGHT_SOURCE=${guides%/*/*}

# Each block becomes a file: of the name it states, or N.sh with its exit code in N.code.
split='
/^```/ && open   { close(name); open = 0; next }
/^```[a-z]+ file=/ { name = $0; sub(/.*file=/, "", name); open = 1; printf "" > name; next }
/^```sh/         { n = sprintf("%02d", ++count); name = n ".sh"; open = 1; printf "" > name
                   code = /exit=/ ? substr($0, index($0, "exit=") + 5) : 0; print code > (n ".code"); close(n ".code"); next }
open             { print > name }
'
for guide in "$guides"/*.md; do
  folder=$scratch/$(basename -- "$guide" .md)
  mkdir -- "$folder"
  cd -- "$folder"
  awk "$split" "$guide"
  ls [0-9]*.sh >/dev/null || { echo "$guide has no commands"; exit 1; }
  for block in [0-9]*.sh; do
    got=0
    timeout 1200 bash -Ec 'trap "code=\$?; ((code == 2)) || exit \$code" ERR; source "./$1"' guide "$block" >out 2>err || got=$?
    [[ $got == "$(cat "${block%.sh}.code")" ]] || { echo "$guide, block $block: exit code $got"; cat "$block"; tail -n 40 out err; exit 1; }
    cp out "${block%.sh}.out"
  done
done

# What two of them promise: the fault of the example is found, each way of asking it.
cd -- "$scratch"
holds() { grep -q -- "$2" "$1" || { echo "no line of $1 matches $2"; tail -n 40 "$1" | cut -c1-200; exit 1; }; }
holds library/01.out '^1\. mine breaks law '
holds library/failing.jsonl '"bucket\|mine/wrong_intersecting/'
holds library/02.out '^\* mine/wrong_intersecting'
holds library/02.out '^as asked: .*: proved'
holds library/02.out '^WRONG$'
holds any-language/01.out '^1\. balls breaks law '
echo passed
