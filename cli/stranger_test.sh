#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Files from a stranger start no program: not a run that names guests, nor any other file that a command reads.
set -euo pipefail
. "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/expect.sh"
export XDG_STATE_HOME=$scratch/state

cat >evil.sh <<END
: >>"$PWD/started"
while read -r q; do echo '{"verdict":"disjoint"}'; done
END
starts() { # NAME yes|no : whether the guest was started since the last time
  [[ $([[ -e started ]] && echo yes || echo no) == "$2" ]] || failed "$1: started: not $2"
  rm -f started
}

# Mine: what I started may start again, wherever the run is.
expect 2 campaign "$daylight" campaign --pairs 60 --seed 7 --cases '' --families random --methods decide,evil --command 'evil=sh evil.sh' --out run
starts campaign yes
mv run renamed
expect 2 'replay of a run of mine' "$daylight" replay renamed --methods evil
starts 'replay of a run of mine' yes

# The same run, opened by somebody else.
export XDG_STATE_HOME=$scratch/other
id=$(python3 -c 'import sqlite3; print(sqlite3.connect("renamed/run.sqlite").execute("SELECT id FROM finding WHERE method = ?", ["evil"]).fetchone()[0])')
expect 3 triage "$daylight" triage renamed --for 2s
holds triage err 'evil of renamed is not started'
key=$(python3 -c 'import json; print(json.load(open("causes.json"))[0]["key"])' 2>/dev/null || echo evil/wrong_disjoint)
try() { # NAME COMMAND.. : whatever the exit code
  "$daylight" "${@:2}" >out 2>err || true
  starts "$1" no
}
try triage triage renamed --for 1s
try 'export of a cause' export renamed "$key" --out sent
try replay replay renamed
try 'replay of a finding' replay "renamed:$id"
try export export "renamed:$id" --out sent
try worst worst --from renamed --method evil --evaluations 5
try chart chart renamed
try resume campaign --resume renamed --pairs 90
holds resume err 'cannot be resumed: evil of renamed is not started'
try merge merge renamed --out merged
expect 0 'the record of another' "$daylight" replay "renamed:$id" --methods decide
expect 2 'replay --run-guests' "$daylight" replay "renamed:$id" --methods evil --run-guests
starts 'replay --run-guests' yes
expect 2 'named again' "$daylight" replay "renamed:$id" --methods evil --command 'evil=sh evil.sh'
starts 'named again' yes

# A record of one guest lets no other start, though the run gives it the same name.
export XDG_STATE_HOME=$scratch/state
cp evil.sh other.sh
python3 - <<'END'
import sqlite3
with sqlite3.connect('renamed/run.sqlite') as run:
    run.execute("UPDATE run SET value = replace(value, 'sh evil.sh', 'sh other.sh') WHERE key = 'guests'")
END
try 'a run that was changed' replay "renamed:$id"

pair='"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2},"b":{"center":[9,0,0],"axis":[0,0,1],"radius":1,"height":2}'
printf '{%s}\n' "$pair" >pair.jsonl

# A folder whose name has a line in it forges no record.
folder=$'p\tx\ncommand\t\t/tmp\tsh evil.sh #'
mkdir -p "$folder"
(cd "$folder" && "$daylight" check --command 'mine=sh evil.sh' --method mine "$scratch/pair.jsonl") >out 2>err || true
holds 'a folder with a line in its name' err 'control character'

# What a run holds in the place of its files is not followed, and nothing outside is deleted.
echo thesis >victim
planted() { # NAME COMMAND.. : in a copy of the run
  "$daylight" "${@:2}" >out 2>err || true
  equal "$1: what is outside stays" thesis "$(cat victim)"
  starts "$1" no
}
for file in run triage; do
  rm -rf copy && cp -r renamed copy
  cat >plant.py <<'END'
import os, struct, sys
name, victim = sys.argv[1], sys.argv[2].encode()
magic = bytes.fromhex('d9d505f920a163d7')
pages = os.path.getsize(name) // 4096
with open(name + '-journal', 'wb') as journal:
    journal.write((magic + struct.pack('>IIIII', 0, 0, pages, 512, 4096)).ljust(512, b'\0'))
    journal.write(struct.pack('>I', 0x40000000 // 4096 + 1) + victim + struct.pack('>II', len(victim), sum(victim)) + magic)
END
  for words in 'replay copy' 'triage copy --for 1s' 'chart copy' 'merge copy --out joined'; do
    python3 plant.py "copy/$file.sqlite" "$scratch/victim"
    # shellcheck disable=SC2086
    planted "a journal of $file: $words" $words
  done
done
for link in charts.json.new charts.json report.html triage.sqlite run.sqlite causes/fcl-libccd.overflow.jsonl; do
  rm -rf copy && cp -r renamed copy && mkdir -p copy/causes && ln -sfn "$scratch/victim" "copy/$link"
  # shellcheck disable=SC2086
  for words in 'triage copy --for 1s' 'chart copy'; do planted "a link $link: $words" $words; done
done
rm -rf copy && cp -r renamed copy && rm -rf copy/causes && mkdir outside && ln -s "$scratch/outside" copy/causes
planted 'a link causes' triage copy --for 1s
equal 'nothing is written through it' '' "$(ls outside)"

# Other files: a field that names a program is refused or means nothing.
guest='"command":"sh evil.sh","plugin":"./evil.so","guests":"command\tevil\t.\tsh evil.sh"'
mkdir cases
printf '{%s,%s}\n' "$pair" "$guest" >cases/case.jsonl
printf '{"id":0,"verdict":"disjoint",%s}\n' "$guest" >answers.jsonl
"$daylight" gate --method decide --pairs 1 --json base.json >/dev/null
python3 - <<'END'
import json
base = json.load(open('base.json'))
base['methods'].append({'name': 'evil', 'command': 'sh evil.sh', 'plugin': './evil.so'})
json.dump(dict(base, guests='command\tevil\t.\tsh evil.sh'), open('base.json', 'w'))
END
cat >scene.urdf <<'END'
<robot name="r" command="sh evil.sh"><link name="l"><collision><geometry><mesh filename="| sh evil.sh"/></geometry></collision>
<collision><geometry><mesh filename="$(sh evil.sh)"/></geometry></collision></link></robot>
END
try check check cases/case.jsonl
try 'replay of a case' replay cases/case.jsonl
try 'campaign --cases' campaign --pairs 5 --cases cases --methods decide --out second
try judge judge answers.jsonl --pairs cases/case.jsonl --name mine
try 'gate --against' gate --method decide --against base.json
try scene scene scene.urdf --configurations 1
