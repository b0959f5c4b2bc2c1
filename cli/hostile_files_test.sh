#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Files that a stranger made to hang, fill or crash a reader: each ends within 2 seconds of CPU time and 300 MB, and says
# why.
# shellcheck disable=SC2086  # commands are split into their words
set -euo pipefail
. "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/expect.sh"
export XDG_STATE_HOME=$scratch/state

# hostile CODE PATTERN COMMAND..: the exit code, and a line of the output.
hostile() {
  local code=$1 pattern=$2 got=0
  shift 2
  (ulimit -v 307200 -t 2 -c 0 && exec timeout 60 "$daylight" "$@") >out 2>err || got=$?
  [[ $got == "$code" ]] || failed "$*: exit code $got, not $code"
  grep -qE -- "$pattern" out err || failed "$*: no line matches $pattern"
  ! grep -q $'[\e\a\b]' out err || failed "$*: escape codes"
}

python3 - <<'END'
import os
def urdf(name, inside):
    with open(name + '.urdf', 'w') as file:
        file.write(f'<robot name="r">{inside}</robot>')
def mjcf(name, inside):
    with open(name + '.xml', 'w') as file:
        file.write(f'<mujoco>{inside}</mujoco>')
def mesh(name, *files):
    shapes = ''.join(f'<collision><geometry><mesh filename="{f}"/></geometry></collision>' for f in files)
    urdf(name, f'<link name="l">{shapes}</link>')
def chain(links, joint):
    return ''.join(f'<link name="l{i}"/>' for i in range(links)) + ''.join(
        f'<joint name="j{i}" {joint(i)}<parent link="l{i - 1}"/><child link="l{i}"/></joint>' for i in range(1, links))
def nested(tag, depth):
    return f'<{tag}>' * depth + f'</{tag}>' * depth

urdf('chain', chain(5000, lambda i: 'type="fixed">'))
urdf('long', chain(30000, lambda i: 'type="fixed">'))
urdf('mimics', chain(5000, lambda i: 'type="continuous"><axis xyz="0 0 1"/>' + (f'<mimic joint="j{i + 1}"/>' if i < 4999 else '')))
urdf('deep', nested('x', 20000))
urdf('tags', '<x/>' * 2000000)
urdf('attributes', '<link name="l" ' + ' '.join(f'a{i}=""' for i in range(50000)) + '/>')
urdf('removed', '<x/>' * 140000 + '<gazebo/>' * 140000)
urdf('shapes', '<link name="l">' + '<collision><geometry><sphere radius="1"/></geometry></collision>' * 40000 + '</link>')
urdf('names', '<link name="&#27;[2J&#7;evil"><collision><geometry><mesh filename="&#27;[2J.stl"/></geometry></collision></link>')
os.symlink('/dev/zero', 'zero.stl')
os.mkfifo('pipe.stl')
mesh('meshes', 'zero.stl', 'pipe.stl', '../../../../../../etc/passwd')
mjcf('endless', '<include file="/dev/zero"/>')
mjcf('outside', '<include file="../../../../../../etc/passwd"/>')
for i in range(40):
    mjcf(f'twice{i}', f'<include file="twice{i + 1}.xml"/>' * 2)
mjcf('twice40', '')
for i in range(40):
    mjcf(f'deeper{i}', nested('x', 900).replace('><', f'><include file="deeper{i + 1}.xml"/><', 900).replace(
        f'<include file="deeper{i + 1}.xml"/>', '', 899))
mjcf('deeper40', '')
mjcf('classes', '<default>' + ''.join(f'<geom a{i}=""/>' for i in range(20000)) + ''.join(
    f'<default class="c{i}"/>' for i in range(20000)) + '</default>')
mjcf('assets', '<asset>' + ''.join(f'<mesh name="m{i}"/>' for i in range(50000)) + '</asset><worldbody>' + ''.join(
    f'<geom type="mesh" mesh="m{49999 - i}"/>' for i in range(50000)) + '</worldbody>')
with open('line.jsonl', 'w') as file:
    file.write('[' * 100000000)
END
hostile 0 'no shapes; 5,000 links' scene chain.urdf --configurations 1
hostile 65 'long.urdf: it has more than 10000 links' scene long.urdf
hostile 65 'mimics.urdf: joints mimic each other in a circle, or in a chain of more than 100' scene mimics.urdf
hostile 65 'deep.urdf: elements are nested more than 1000 deep' scene deep.urdf
hostile 65 'tags.urdf: more than 300000 tags' scene tags.urdf
hostile 65 'attributes.urdf: an element has more than 100 attributes' scene attributes.urdf
hostile 65 'removed.urdf: No link elements found' scene removed.urdf
hostile 65 'shapes.urdf: it has more than 20000 shapes' scene shapes.urdf
hostile 3 'u001b.2J.u0007evil' scene names.urdf --configurations 1
hostile 3 'zero.stl: it is outside ' scene meshes.urdf --configurations 1 --table
for reason in 'pipe.stl: it is not a regular file' '\.\./etc/passwd: it is outside '; do holds 'a mesh' out "$reason"; done
hostile 65 'endless.xml: /dev/zero: it is outside ' scene endless.xml
hostile 65 'outside.xml: .*/etc/passwd: it is outside ' scene outside.xml
hostile 65 'twice0.xml: more than 1000 files are included' scene twice0.xml
hostile 65 'deeper0.xml: with its includes, elements are nested more than 1000 deep' scene deeper0.xml
hostile 65 'classes.xml: the classes of defaults have more than 1000000 values' scene classes.xml
hostile 3 'not read 50,000 meshes' scene assets.xml --configurations 1
hostile 65 'line.jsonl: line 1 is longer than 1 MiB' scene line.jsonl

# Runs: tables that never end, triggers, endless text, numbers that are none, names that steer a terminal.
expect 2 'a campaign' "$daylight" campaign --pairs 1500 --seed 7 --cases '' --methods ode,decide --out run
expect 2 'its triage' "$daylight" triage run --for 4s  # which finds causes on a busy machine, too
changed() { # SQL..: a copy of the run in which somebody ran it
  rm -rf copy && cp -r run copy
  python3 -c 'import sqlite3, sys
with sqlite3.connect("copy/" + sys.argv[1]) as run: [run.execute(sql) for sql in sys.argv[2:]]' "$@"
}
endless='WITH RECURSIVE r(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM r) SELECT'
changed run.sqlite 'ALTER TABLE finding_group RENAME TO was' "CREATE VIEW finding_group AS $endless x, x, x, x, x, x FROM r"
for command in 'triage copy --for 1s' 'replay copy' 'merge copy --out merged' 'export copy:1 --out sent' \
  'worst --from copy --method ode --evaluations 5' 'chart copy' 'campaign --resume copy'; do
  hostile 65 "run.sqlite: its view 'finding_group' is none that this build writes" $command
done
changed run.sqlite 'CREATE TRIGGER evil AFTER UPDATE ON progress BEGIN DELETE FROM wrong_answer; END'
hostile 65 "run.sqlite: its trigger 'evil' is none that this build writes" campaign --resume copy --pairs 3000
changed run.sqlite 'UPDATE wrong_answer SET reason = zeroblob(70000000) WHERE id = 1'
hostile 65 'run.sqlite: string or blob too big' replay copy
changed run.sqlite "UPDATE judged_pair SET pair = '['"
for command in 'triage copy --for 1s' 'replay copy' 'export copy:1 --out sent'; do
  hostile 65 '1: line 1, column 1: ' $command
done
changed run.sqlite 'UPDATE judged_pair SET pair_index = -1 - pair_index'
hostile 65 'run.sqlite: it counts [0-9]+ findings of ode .*, and pairs of 0: it is damaged or forged' triage copy
changed run.sqlite 'UPDATE progress SET next = 9223372036854775807'
for command in 'campaign --resume copy --for 1s' 'merge copy --out merged'; do
  hostile 65 'it did 9223372036854775807 pairs, and its referee judged 1500' $command
done
changed run.sqlite 'UPDATE finding_group SET count = 1000000
  WHERE (method, kind, severity, family) = (SELECT method, kind, severity, family FROM wrong_answer WHERE id = 1)' "INSERT INTO wrong_answer
  WITH RECURSIVE r(x) AS (SELECT 1000 UNION ALL SELECT x + 1 FROM r WHERE x < 300000)
  SELECT x, pair_index, family, family_index, method, kind, severity, margin_lo, margin_hi, reason FROM r, wrong_answer WHERE id = 1"
for command in 'replay copy' 'merge copy --out merged' 'triage copy --for 1s'; do
  hostile 65 'has rows of 29[0-9]{4}, and pairs' $command
done
changed run.sqlite "INSERT OR REPLACE INTO run VALUES('shard', '0/2 of batches of 10')" "UPDATE run SET value = '1e9' WHERE key = 'pairs'" \
  'UPDATE progress SET next = 3000'
hostile 65 "the pairs of the run is '1e9', no whole number" merge copy --out merged
changed run.sqlite "UPDATE run SET value = char(27) || '[2J' WHERE key = 'seed'"
hostile 65 "the seed of the run is '.u001b.2J', no whole number" campaign --resume copy
evil="char(27, 91, 50, 74, 7, 10) || 'evil' || char(8238)"
for table in wrong_answer tally method; do
  column=$([[ $table == method ]] && echo name || echo method)
  changed run.sqlite "UPDATE $table SET $column = $evil || $column" \
    "UPDATE finding_group SET method = $evil || method WHERE '$table' = 'wrong_answer'"
  for command in 'triage copy --for 1s' 'replay copy' 'merge copy --out merged' 'export copy:1 --out sent' \
    'chart copy' 'campaign --resume copy'; do
    "$daylight" $command >out 2>err || true
    ! grep -qE $'\e|\a|\xe2\x80\xae|^evil' out err || failed "escape codes of $table: $command"
    [[ $table != wrong_answer || $command != replay* ]] || holds 'a name' out 'finding of .u001b.2J.u0007.nevil.u202eode'
  done
done

# What a stranger's triage holds is made anew.
changed triage.sqlite 'ALTER TABLE note RENAME TO was' "CREATE VIEW note AS $endless 'asked' AS key, x AS value FROM r"
hostile 65 "triage.sqlite: its view 'note' is none that this build writes" export copy ode/any --out sent
changed triage.sqlite 'CREATE TRIGGER evil AFTER INSERT ON cause BEGIN DELETE FROM cause; END'
expect 2 'its triage again' "$daylight" triage copy --for 1s
equal 'no trigger is left' 0 "$(python3 -c 'import sqlite3; print(sqlite3.connect("copy/triage.sqlite").execute("SELECT count(*) FROM sqlite_master WHERE type = ?", ["trigger"]).fetchone()[0])')"
