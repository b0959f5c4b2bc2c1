#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# create.sh SHARDS OUT OPTION.. : makes the run folders OUT/shard-0 .. of a campaign with these options, all at one
# time, so that they agree in seed and build whenever their turn comes. A campaign that is there stays.
set -euo pipefail

shards=$1 out=$2
shift 2
[[ $shards =~ ^[1-9][0-9]*$ ]] || { echo "a number of shards is expected, not '$shards'" >&2; exit 64; }
daylight=${DAYLIGHT:-$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../../build/release/daylight}

if [[ ! -e $out/seed ]]; then # written last: what a kill left half is made again
  rm -rf -- "$out"/shard-*
  mkdir -p -- "$out"
  seed=$(od -An -N4 -tu4 /dev/urandom | tr -d ' ')
  [[ " $* " =~ \ --seed[=\ ]([0-9]+)\  ]] && seed=${BASH_REMATCH[1]}
  given=()
  while (($#)); do
    case $1 in
      --seed) shift ;;
      --seed=*) ;;
      *) given+=("$1") ;;
    esac
    shift
  done
  for ((i = 0; i < shards; ++i)); do
    "$daylight" campaign --create-only --shard "$i/$shards" --seed "$seed" --out "$out/shard-$i" "${given[@]}" >/dev/null
  done
  printf '%s\n' "$seed" >"$out/seed"
fi
