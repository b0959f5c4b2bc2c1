#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Follows every guide as it is written: writes its files, runs its commands with the executable given as $1, and
# compares the exit code of the last of each block with the one that the block states (0 where it states none). Of
# those before it any may find something (2). Gates draw fewer pairs, triage has less time and scenes have fewer
# configurations, and compilers do not optimize, unless a second argument, `whole`, is given.
set -euo pipefail
# shellcheck source=SCRIPTDIR/../../cli/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../../cli/expect.sh"
guides=$source_tree/docs/guides
mkdir bin
if [[ ${2-} == whole ]]; then
  ln -s -- "$daylight" bin/daylight
else
  cat >bin/daylight <<'END'
#!/usr/bin/env bash
words=() last=
for word; do
  case $last in
    --pairs) [[ $word != [0-9]* ]] || word=400 ;;
    --for) word=2s ;;
  esac
  words+=("$word") last=$word
done
case "$*" in
  gate*--pairs* | gate*--for* | gate*--against*) words+=(--cases '') ;;
  gate*) words+=(--cases '' --pairs 400) ;;
  scene*--configurations*) ;;
  scene*) words+=(--configurations 50) ;;
esac
exec "$real_daylight" "${words[@]}"
END
  printf '#!/bin/sh\nexec %s "$@" -O0\n' "$(command -v c++)" >bin/c++
  chmod +x bin/*
fi
export PATH=$scratch/bin:$PATH DAYLIGHT_SOURCE=$source_tree real_daylight=$daylight

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
  [[ -e 01.sh ]] || failed "$guide has no commands"
  for block in [0-9]*.sh; do
    expect "$(<"${block%.sh}.code")" "$guide, block $block" \
      bash -Ec 'trap "code=\$?; ((code == 2)) || exit \$code" ERR; source "./$1"' guide "$block"
    cp out "${block%.sh}.out"
  done
done

# What two of them promise: the fault of the example is found, each way of asking it.
cd -- "$scratch"
holds 'a broken law' library/01.out '^1\. mine breaks law '
holds 'a case' library/failing.jsonl '"id":"mine/wrong_intersecting/'
holds 'a cause' library/02.out '^\* mine/wrong_intersecting'
holds 'asked again' library/02.out '^as asked: .*: proved'
holds 'a command breaks one' any-language/01.out '^1\. balls breaks law '
