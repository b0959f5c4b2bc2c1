#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Files that a stranger made to hang, fill or crash a reader: each ends within 2 seconds of CPU time and 300 MB, and says
# why.
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
def sparse(name):
    with open(name, 'w') as file:
        file.truncate(10 << 30)
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
os.symlink('/dev/zero', 'zero.urdf')
sparse('sparse.urdf')
os.symlink('/dev/zero', 'zero.stl')
sparse('sparse.stl')
os.mkfifo('pipe.stl')
mesh('meshes', 'zero.stl', 'pipe.stl', 'sparse.stl', '../../../../../../etc/passwd', 'file:///etc/passwd',
     'package://../../../../../etc/passwd')
urdf('beside', '<link name="l"/>')
os.symlink('/dev/zero', 'beside.srdf')
mjcf('endless', '<include file="/dev/zero"/>')
mjcf('outside', '<include file="../../../../../../etc/passwd"/>')
for i in range(40):
    mjcf(f'twice{i}', f'<include file="twice{i + 1}.xml"/>' * 2)
mjcf('twice40', '')
for i in range(40):
    mjcf(f'deeper{i}', nested('x', 900).replace('><', f'><include file="deeper{i + 1}.xml"/><', 900).replace(
        f'<include file="deeper{i + 1}.xml"/>', '', 899))
mjcf('deeper40', '')
mjcf('deep', nested('body', 100000))
mjcf('classes', '<default>' + ''.join(f'<geom a{i}=""/>' for i in range(20000)) + ''.join(
    f'<default class="c{i}"/>' for i in range(20000)) + '</default>')
mjcf('assets', '<asset>' + ''.join(f'<mesh name="m{i}"/>' for i in range(50000)) + '</asset><worldbody>' + ''.join(
    f'<geom type="mesh" mesh="m{49999 - i}"/>' for i in range(50000)) + '</worldbody>')
os.symlink('/dev/zero', 'zero.jsonl')
sparse('sparse.csv')
with open('line.jsonl', 'w') as file:
    file.write('[' * 100000000)
END
hostile 0 '0 cylinders, .* 5000 links' scene chain.urdf --configurations 1
hostile 65 'long.urdf: it has more than 10000 links' scene long.urdf
hostile 65 'mimics.urdf: joints mimic each other in a circle, or in a chain of more than 100' scene mimics.urdf
hostile 65 'deep.urdf: elements are nested more than 1000 deep' scene deep.urdf
hostile 65 'tags.urdf: more than 300000 tags' scene tags.urdf
hostile 65 'attributes.urdf: an element has more than 100 attributes' scene attributes.urdf
hostile 65 'removed.urdf: .*root' scene removed.urdf
hostile 65 'shapes.urdf: it has more than 10000 shapes' scene shapes.urdf
hostile 3 'u001b.2J.u0007evil' scene names.urdf --configurations 1
hostile 65 'zero.urdf: it is neither a regular file nor a pipe' scene zero.urdf
hostile 65 'sparse.urdf: it is larger than 64 MiB' scene sparse.urdf
hostile 3 'zero.stl: it is outside ' scene meshes.urdf --configurations 1
for reason in 'pipe.stl: it is not a regular file' 'sparse.stl: it is larger than 64 MiB' \
  '\.\./etc/passwd: it is outside ' 'file:///etc/passwd: it is outside ' 'package://.*/etc/passwd: it is outside '; do
  holds 'a mesh' out "$reason"
done
hostile 65 'beside.srdf: it is outside ' scene beside.urdf
hostile 65 'endless.xml: /dev/zero: it is outside ' scene endless.xml
hostile 65 'outside.xml: .*/etc/passwd: it is outside ' scene outside.xml
hostile 65 'twice0.xml: more than 1000 files are included' scene twice0.xml
hostile 65 'deeper0.xml: with its includes, elements are nested more than 1000 deep' scene deeper0.xml
hostile 65 'deep.xml: elements are nested more than 1000 deep' scene deep.xml
hostile 65 'classes.xml: the classes of defaults have more than 1000000 values' scene classes.xml
hostile 3 'NOT TESTED: 50000 meshes' scene assets.xml --configurations 1
hostile 65 'zero.jsonl: it is neither a regular file nor a pipe' scene zero.jsonl
hostile 65 'zero.jsonl: it is neither a regular file nor a pipe' near zero.jsonl
hostile 65 'sparse.csv: it is larger than 1024 MiB' scene sparse.csv
hostile 65 'line.jsonl: line 1 is longer than 1 MiB' scene line.jsonl

