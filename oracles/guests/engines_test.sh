#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The engines answer pairs of cylinders, boxes and half-spaces, right where that is easy, and a campaign asks them.
# Skipped without node or without their packages: npm ci --prefix oracles/guests
set -euo pipefail

daylight=$(readlink -f -- "$1")
guests=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
skip=$guests/../../.ci/skip
command -v node >/dev/null || exec "$skip" 'no Node.js here: apt-get install nodejs'
engines='rapier jolt physx havok ammo cannon crashcat oimo mujoco'
methods=${engines/mujoco/mujoco3}
for package in @babylonjs/havok @dimforge/rapier3d-compat @mujoco/mujoco ammo.js cannon-es crashcat jolt-physics oimophysics physx-js-webidl; do
  [[ -d $guests/node_modules/$package ]] || exec "$skip" "no $package here: npm ci --prefix oracles/guests"
done
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
cd -- "$scratch"

# Apart and overlapping by a tenth or more: side by side, end to end, crossed, a rim on a cap; one axis upside down.
solid='"axis":[0,0,1],"radius":1,"height":2}'
while read -r center axis verdict; do
  printf '{"a":{"center":[7,8,9],%s,"b":{"center":%s,"axis":%s,"radius":1,"height":2}}\n' "$solid" "$center" "$axis" >>pairs.jsonl
  echo "$verdict" >>wanted
done <<'END'
[9.2,8,9] [0,0,-3] disjoint
[8.8,8,9] [0,0,-3] intersecting
[7,8,11.2] [0,0,1] disjoint
[7,8,10.8] [0,0,1] intersecting
[9.2,8,9] [0,1,0] disjoint
[8.8,8,9] [0,-1,0] intersecting
[7,8,11.6] [1,0,1] disjoint
[7,8,11.3] [-1,0,-1] intersecting
END
while read -r normal center verdict; do
  plane=$(printf '{"shape":"half_space","point":[7,8,9],"normal":%s}' "$normal")
  for pair in '{"a":%s,"b":{"center":%s,%s}\n' '{"b":%s,"a":{"center":%s,%s}\n'; do
    # shellcheck disable=SC2059
    printf "$pair" "$plane" "$center" "$solid" >>planes.jsonl
    echo "$verdict" >>wanted_of_planes
  done
done <<'END'
[0,0,1] [7,8,10.2] disjoint
[0,0,1] [7,8,9.8] intersecting
[0,-2,0] [7,6.8,9] disjoint
[0,-2,0] [7,7.2,9] intersecting
[0,3,0] [7,9.2,9] disjoint
[0,3,0] [7,4,9] intersecting
[-1,0,-1] [5.87,8,7.87] disjoint
[-1,0,-1] [6.08,8,8.08] intersecting
[1,-0.1,2] [9,8,12] disjoint
END
# A box that is 2, 6 and 4 long along x, y and z. Most are a tenth apart, or overlap by that.
box='{"shape":"box","center":[7,8,9],"edges":[2,4,6],"quaternion":[3,3,0,0]'
while read -r of rounding other verdict; do
  printf '{"a":%s,"rounding":%s},"b":%s}\n{"b":%s,"rounding":%s},"a":%s}\n' "$box" "$rounding" "$other" "$box" "$rounding" "$other" >>"$of.jsonl"
  printf '%s\n' "$verdict" "$verdict" >>"wanted_of_$of"
done <<END
boxes 0 {"center":[9.1,8,9],$solid disjoint
boxes 0 {"center":[8.9,8,9],$solid intersecting
boxes 0 {"center":[7,12.1,9],"axis":[0,-3,0],"radius":1,"height":2} disjoint
boxes 0 {"center":[7,11.9,9],"axis":[0,-3,0],"radius":1,"height":2} intersecting
boxes 0 {"shape":"box","center":[7,8,12.1],"edges":[2,2,2]} disjoint
boxes 0 {"shape":"box","center":[7,8,11.9],"edges":[2,2,2]} intersecting
boxes 0 {"shape":"box","center":[9.5,8,9],"edges":[2,2,2],"quaternion":[2.414,0,0,1]} disjoint
boxes 0 {"shape":"box","center":[9.3,8,9],"edges":[2,2,2],"quaternion":[2.414,0,0,1]} intersecting
boxes 0 {"shape":"box","center":[9.5,13.5,9],"edges":[8,1,1],"quaternion":[1.732,0,0,-1]} disjoint
boxes 0 {"shape":"box","center":[9.5,13.5,9],"edges":[8,1,1],"quaternion":[1.732,0,0,1]} intersecting
boxes_on_planes 0 {"shape":"half_space","point":[7,4.9,9],"normal":[0,2,0]} disjoint
boxes_on_planes 0 {"shape":"half_space","point":[7,5.1,9],"normal":[0,2,0]} intersecting
boxes_on_planes 0 {"shape":"half_space","point":[8.1,8,9],"normal":[-1,0,0]} disjoint
boxes_on_planes 0 {"shape":"half_space","point":[7.9,8,9],"normal":[-1,0,0]} intersecting
rounded_boxes 0.5 {"shape":"box","center":[7,8,12.6],"edges":[2,2,2]} disjoint
rounded_boxes 0.5 {"shape":"box","center":[7,8,12.4],"edges":[2,2,2]} intersecting
rounded_boxes 0.5 {"shape":"sphere","center":[8.4,11.4,11.4],"radius":0.1} disjoint
rounded_boxes 0.5 {"shape":"sphere","center":[8.3,11.3,11.3],"radius":0.1} intersecting
END
easy() { # ENGINE PAIRS WANTED
  "$daylight" check --command "node '$guests/$1.mjs'" "$2" >said
  sed 's/.*"verdict":"\([a-z]*\)".*/\1/' said | diff "$3" - || { echo "$1 is wrong where that is easy"; exit 1; }
}
for engine in $engines; do
  easy "$engine" pairs.jsonl wanted
  others=boxes
  case $engine in havok | oimo) ;; *) others+=' planes boxes_on_planes' ;; esac
  case $engine in rapier | physx) others+=' rounded_boxes' ;; esac
  for other in $others; do easy "$engine" "$other.jsonl" "wanted_of_$other"; done
done
all=(--methods "${methods// /,}")
commands=()
for engine in $engines; do commands+=(--command "node '$guests/$engine.mjs'"); done
code=0
"$daylight" campaign --pairs 60 --seed 3 --cases '' "${all[@]}" --table --out runs/engines "${commands[@]}" >out || code=$?
[[ $code == 0 || $code == 2 ]] || { echo "campaign: exit code $code"; cat out; exit 1; }
for method in $methods; do grep -qE "^$method +60 " out || { cat out; exit 1; }; done
code=0
"$daylight" replay runs/engines "${all[@]}" >out || code=$?
[[ $code == 0 || $code == 2 ]] || { echo "replay: exit code $code"; cat out; exit 1; }
! grep -q 'not asked' out || { cat out; exit 1; }
echo passed
