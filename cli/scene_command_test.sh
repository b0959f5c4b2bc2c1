#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scene as a person calls it: robots, lists of solids; exit codes, what is written.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"
scenes=$source_tree/corpus/scenes

expect 0 'a robot' "$daylight" scene "$scenes/twenty.urdf" --configurations 20 --json twenty.json
holds 'the verdict comes first' out '^clear +1[0-9]+ of 171 known pairs in 20 configurations of seed 1, clearance 0 '
holds 'what there is' out '^20 cylinders; 20 links, 18 moving joints$'
holds 'which pairs' out '^190 pairs: 171 checked\. Not checked: 1 in one rigid body, 18 of adjacent bodies'
holds 'the referee' out '^referee: 3,420 recommended answers judged, 0 wrong, 0 tolerated, 0 not proved$'
holds 'as JSON' twenty.json '"recommended":\['
expect 0 'a clearance' "$daylight" scene "$scenes/crane.xml" --configurations 20 --clearance 0.01 --tolerate 0.1
holds 'a plane' out '^1 sphere, 5 cylinders, 1 half-space; '
holds 'said' out ' in 20 configurations of seed 1, clearance 0.01 '
holds 'how sure that is' out 'each wrong in less than 15 % of all configurations, at 95 % confidence'
expect 0 'one configuration' "$daylight" scene "$scenes/crane.urdf" --at luff=-0.5 travel=1
holds 'one' out ' in 1 configuration of '
expect 0 'a list' "$daylight" scene "$scenes/shelf.jsonl"
holds 'four cylinders' out '^6 pairs: 6 checked\.'
expect 1 'no place for JSON' "$daylight" scene "$scenes/crane.urdf" --configurations 1 --json none/crane.json
holds 'which' err 'none/crane.json cannot be written'
for i in {1..201}; do printf '{"center":[%s,0,0],"axis":[0,0,1],"radius":0.4,"height":2}\n' "$i"; done >many.jsonl
for i in {1..5}; do cat many.jsonl; done >more.jsonl
expect 0 'more than a study lists' "$daylight" scene more.jsonl --prove
holds 'far apart' out '^504,510 pairs: 504510 checked.* [0-9,]+ of the checked pairs are far apart: '
holds 'with those' out '^never +502500 of 504,510 pairs, proved over all motions'
holds 'equal ones' out '^refuted +2010, '
expect 3 'no time' "$daylight" scene "$scenes/twenty.urdf" --prove --for 1ms
holds 'is left' out '^open +171: 171 because no time was left'
holds 'of each pair' out '^  open .*: no time was left \('
expect 64 'no duration' "$daylight" scene "$scenes/twenty.urdf" --for soon
printf '{"a":%s,"b":%s}\n' "$(head -n 1 many.jsonl)" "$(head -n 1 many.jsonl)" >pair.jsonl
expect 65 'pairs for a scene' "$daylight" scene pair.jsonl
holds 'what to do' err '^daylight: pair.jsonl: line 1: this is a pair, but a line of a scene is one solid: .*`daylight check` answers'
: >empty.jsonl
expect 0 'nothing in it' "$daylight" scene empty.jsonl --json empty.json
holds 'nothing to do' out '^nothing to check$'
expect 64 'no such file' "$daylight" scene none.urdf
expect 65 'a bad line' "$daylight" scene <(:) # no ending that is known
printf '{"center":[0,0,0],"axis":[0,0,0],"radius":1,"height":2}\n' >bad.jsonl
expect 65 'no axis' "$daylight" scene bad.jsonl
holds 'which line' err 'line 1: axis'
expect 64 'no scene' "$daylight" scene
expect 64 'an unknown joint' "$daylight" scene "$scenes/crane.urdf" --at elbow=1
expect 64 'no number' "$daylight" scene "$scenes/crane.urdf" --at luff=high
expect 64 'beyond a limit' "$daylight" scene "$scenes/crane.urdf" --at travel=9
holds 'the limits' err "^daylight: 'travel' moves from 0\.1 to [0-9.]+, but not to 9$"
for clearance in -1 inf nan; do
  expect 64 "a clearance of $clearance" "$daylight" scene "$scenes/crane.urdf" "--clearance=$clearance"
  holds 'why' err "^daylight: .*--clearance: $clearance is not a length: give a finite number, 0 or more"
done
expect 64 'nothing to tolerate' "$daylight" scene "$scenes/crane.urdf" --tolerate=-1
holds 'which' err '--tolerate: -1 is not a length'
expect 3 'capsules' "$daylight" scene "$scenes/arm.urdf" --configurations 20 --clearance 0.02
holds 'shapes first' out '^8 spheres, 5 capsules \(3 written as a cylinder and two spheres\), 4 cylinders, 1 box;'
holds 'nothing hidden' out '^not read 1 mesh \(camera\)$'
holds 'why' out 'A mesh of camera cannot be read: package://arm/camera.stl: it is not there.$'
holds 'proved' out '^referee: 1,980 recommended answers judged, 0 wrong'
expect 0 'a proof' "$daylight" scene "$scenes/crane.urdf" --configurations 20 --prove --srdf-out out.srdf --json out.json
holds 'over all motions' out '^never +[0-9]+ of [0-9]+ pairs, proved over all motions to be farther apart than 0 '
holds 'the bound' out.json '"a":"tower","b":"hook","bodies":\[[0-9,]+\],"verdict":"never","bound":0\.0[12]'
holds 'what the SRDF says' out '^"Never" in the SRDF, 1 link pair: 1 proved, 0 REFUTED, 0 open$'
holds 'an SRDF' out.srdf '<disable_collisions link1="tower" link2="hook" reason="Never"/>  <!-- proved: at least 0'
expect 64 'an SRDF of one configuration' "$daylight" scene "$scenes/crane.urdf" --at luff=-0.5 --srdf-out at.srdf
holds 'why' err '^daylight: .*--srdf-out covers all motions, but --at covers one configuration'
expect 0 'an SRDF proves by itself' "$daylight" scene "$scenes/crane.urdf" --configurations 20 --srdf-out by_itself.srdf
holds 'what is proved' by_itself.srdf '<disable_collisions link1="tower" link2="hook" reason="Never"/>  <!-- proved: at least 0'
printf '<robot><disable_collisions link1="trolley" link2="tower" reason="Never"/></robot>' >false.srdf
expect 2 'a Never that is none' "$daylight" scene "$scenes/crane.urdf" --configurations 20 --prove --srdf false.srdf
holds 'where' out '^  refuted  trolley - tower, "Never" in the SRDF: distance -0\.[0-9]+ --at luff=0\.[0-9]+ travel=0'
at=$(sed -n 's/^  refuted  trolley - tower, .* --at \(.*\)$/\1/p' out)
# shellcheck disable=SC2086
expect 0 'the same there' "$daylight" scene "$scenes/crane.urdf" --srdf "$scenes/crane.srdf" --at $at
holds 'they meet' out '^closest call: tower - trolley in configuration 0, [0-9.e-]+ below the clearance'
printf '<robot><disable_collisions link1="hook" link2="tower" reason="Never"/></robot>' >near.srdf
expect 0 'the same, shorter' "$daylight" scene "$scenes/crane.urdf" --configurations 20 --prove
lacks 'no line for each' out '^  never +tower - hook'
expect 0 'near, but never touching' "$daylight" scene "$scenes/crane.urdf" --configurations 20 --prove --srdf near.srdf --clearance 0.1 --table
holds 'how near' out '^  within   hook - tower, "Never" in the SRDF: comes within the clearance: distance 0\.[0-9]+ --at .*, but never touches \(proved: at least 0\.[0-9]+\)$'
expect 3 'what boxes do not close' "$daylight" scene "$scenes/twenty.urdf" --configurations 20 --prove --table
holds 'what ended the search' out '^open +2: 2 after up to [0-9,]+ boxes$'
holds 'what is left' out '^  open     base - left_6: nothing proved for [0-9.]+ % of the range of their 6 joints'
expect 64 'no such SRDF' "$daylight" scene "$scenes/crane.urdf" --srdf none.srdf
expect 3 'MJCF of today' "$daylight" scene "$scenes/hand.xml" --configurations 20
holds 'near a bound' out '^open +1, because the bounding solid of a mesh or ellipsoid comes within the clearance \(palm/pad - th_tip/th_bone\)$'
holds 'bounds' out ' 2 boxes, 1 ellipsoid \(as a bounding solid\), 1 mesh \(as a bounding solid\); 27 links'
holds 'what was skipped' out '  Not needed and not read: actuator, option, sensor, tendon.$'
expect 3 'boxes and meshes' "$daylight" scene "$scenes/porter.urdf" --configurations 20
holds 'what does not move' out '^  NOT MOVED: rolls, swivel$'
