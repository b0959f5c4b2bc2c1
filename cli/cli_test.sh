#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The executable given as $1, as a shell sees it: what it prints where, and its exit codes.
set -euo pipefail

# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"
# says NAME CODE PATTERN ARGUMENT..: the pattern matches the whole of standard output; standard input is the file `in`
says() {
  expect "$2" "$1" "$daylight" "${@:4}" <in
  [[ $(<out) =~ ^($3)$ ]] || failed "$1: standard output is not /$3/"
}
# The same, of one line given to check.
line() { # what, exit code, pattern, line
  printf '%s\n' "$4" >in
  says "$1" "$2" "$3" check
}
cylinder() { printf '{"center":[%s],"axis":[%s],"radius":%s,"height":%s}' "$@"; }
pair() { printf '{"a":%s,"b":%s}' "$1" "$2"; }

unit=$(cylinder 0,0,0 0,0,1 1 2)
apart=$(pair "$unit" "$(cylinder 3,0,0 0,1,0 1 2)")
overlapping=$(pair "$unit" "$(cylinder 0.5,0,0 0,1,0 1 2)")
other=$(cylinder 3,0,0 0,1,0 1 2)
disjoint='\{"verdict":"disjoint",[^'$'\n'']*\}'
intersecting='\{"verdict":"intersecting",[^'$'\n'']*\}'
invalid='\{"verdict":"invalid","error":"(two: )?line [0-9]+[^'$'\n'']*\}'

# corpus/pairs/pair_io_test.cpp has every way in which a line is no pair.
line 'disjoint' 0 "$disjoint" "$apart"
line 'intersecting' 0 "$intersecting" "$overlapping"
line 'garbage' 65 "$invalid" 'garbage'
line 'negative radius' 65 "$invalid" "$(pair "$(cylinder 0,0,0 0,0,1 -1 2)" "$other")"
line 'text after the pair' 65 "$invalid" "$apart x"
line 'radius and height 0' 0 "$disjoint" "$(pair "$(cylinder 0,0,0 0,0,1 0 0)" "$other")"

printf '%s\n\n  \nnonsense\n%s\r\n\n%s' "$apart" "$overlapping" "$apart" >in
says 'good lines around a bad one' 65 "$disjoint"$'\n'"$invalid"$'\n'"$intersecting"$'\n'"$disjoint" check
[[ $(<out) == *'line 4'* ]] || failed 'the line of an error'

: >in
says 'no input' 0 '' check

printf '%s\n' "$apart" >in
cp in one
printf '%s\nnonsense\n' "$overlapping" >two
says 'files' 65 "$disjoint"$'\n'"$intersecting"$'\n''.*"error":"two: line 2.*' check one two
says 'a file and standard input' 0 "$disjoint"$'\n'"$disjoint" check one -
# A file that is named and not there, or is a folder, is wrong usage, of every command.
for command in check judge replay scene 'export --method ode --out sent' 'worst --method ode --from'; do
  read -ra words <<<"$command"
  says "$command: no such file" 64 '' "${words[@]}" missing
done
says 'a folder' 64 '' check .
says 'judge: no such pairs' 64 '' judge one --pairs missing
says 'no such cases' 64 '' campaign --pairs 1 --cases missing
# What is in a file is bad input.
says 'replay: a line that is no pair' 65 '' replay two
says 'worst: a line that is no pair' 65 '' worst --method ode --from two
printf '{}\n' >results
mkdir empty
says 'no results of a bench' 65 '' chart empty --bench results
[[ $(<err) == 'daylight: results is not a result of `daylight bench --json`' ]] || failed 'no results of a bench: the error'
# Files are opened before the work begins.
for command in 'bench --json' 'gate --json' 'gate --junit' 'gate --keep' 'triage empty --json' 'judge one --keep' \
    'worst --method ode --out' 'scene one --json' 'scene one --srdf-out'; do
  read -ra words <<<"$command"
  says "$command: no such folder" 1 '' "${words[@]}" none/file
  [[ $(<err) == 'daylight: none/file cannot be written' ]] || failed "$command: the error"
done
cp one in
says 'distance' 0 '.*"distance":\[[0-9.e-]+,[0-9.e-]+\].*' check --distance
# The clearance, and what the rounding of decimals decides.
ball() { printf '{"center":[%s,0,0],"axis":[0,0,1],"radius":0,"height":0,"rounding":%s}' "$1" "$2"; }
balls() { printf '{"a":%s,"b":%s}\n' "$(ball 0 "$1")" "$(ball "$2" "$3")" >in; }
balls 1 2.5 1
says 'within a clearance' 0 '\{"verdict":"intersecting",.*"distance":\[-0\.5000[0-9]*,-0\.4999[0-9]*\],.*"clearance":1\}' check --distance --clearance 1
says 'beyond a clearance' 0 '\{"verdict":"disjoint",.*"clearance":0\.25\}' check --clearance 0.25
says 'at a clearance' 0 '\{"verdict":"touching",.*"clearance":0\.5\}' check --clearance 0.5
says 'no clearance' 64 '' check --clearance -1
balls 0.1 0.3 0.2
says 'decimals that touch' 0 '\{"verdict":"intersecting",.*"within_rounding":true\}' check
balls 1 2 1
[[ $("$daylight" check <in) != *within_rounding* ]] || failed 'whole numbers are not rounded'
# Methods that decline are one line.
says 'a sphere replayed' 0 '.*'$'\n''  2 methods decline: "it has no sphere" \(2\)'$'\n''1 replayed.*' \
  replay - --methods decide,nlopt-sign-600,seed2008-printed,seed2017-printed
[[ $(grep -c 'no sphere' out) == 1 ]] || failed 'methods that decline are one line'
cp one in
[[ $("$daylight" check <in) != *'"distance"'* ]] || failed 'a distance nobody asked for'
says 'another method' 0 '\{"verdict":"disjoint","method":"intersect"\}' check --method intersect
says 'an unknown method' 64 '' check --method nobody
says 'a name of several methods' 64 '' check --method nlopt
says 'a name that begins others' 0 '.*"disjoint".*"method":"fcl-libccd"\}' check --method fcl-libccd
# Each fault of the published texts is a method, for whoever names it.
grep '"id":"erratum-2017-one-octant"' "$source_tree/corpus/cases/errata.jsonl" >in
says 'one fault alone' 0 '\{"verdict":"intersecting",.*' check --method seed2017-only-one-octant
says 'without it' 0 '\{"verdict":"disjoint",.*' check --method seed2017-without-one-octant
expect 2 'a campaign asks it' "$daylight" campaign --pairs 200 --seed 1 --families touching_disks --cases '' \
  --methods seed2017-only-one-octant --table --out run
holds 'that one alone' out '^seed2017-only-one-octant +200 '
expect 2 'a run with it is replayed' "$daylight" replay run
holds 'by its name' out 'seed2017-only-one-octant'
cp one in
says 'another method, nonsense in' 65 '.*"disjoint".*'$'\n''.*"intersecting".*'$'\n'"$invalid" check --method intersect one two

says 'no command' 64 ''
# what is wrong, how the message ends, arguments
refused() {
  local what=$1 wanted=$2
  shift 2
  says "$what" 64 '' "$@"
  [[ $(<err) == "daylight: $wanted" ]] || failed "$what: the message is not '$wanted'"
}
refused 'a misspelt command' $'no command \'chekc\'. Do you mean \'check\'?\n--help shows more' chekc
refused 'a misspelt option' $'check has no option --distances. Do you mean \'--distance\'?\n--help shows more' check --distances
refused 'a word too many' $'campaign does not take \'100\'\n--help shows more' campaign --pairs 100 100
refused 'an empty value' $'--methods= gives no value\n--help shows more' campaign --methods= --pairs 100
says 'an unknown command' 64 '' nonsense
[[ $(<err) == *"'nonsense'; there are check, "*', families'* ]] || failed 'an unknown command lists those there are'
says 'an unknown option' 64 '' check --nonsense
says 'a number that is none' 64 '' families random --count many
says 'version' 0 'daylight [0-9.]+ \(.*\)' --version
for command in check families bench campaign replay worst; do
  says "help of $command" 0 '.*Examples:.*' "$command" --help
done

# A command has few options; those of guests count as one. More need a reason.
declare -A more=(
  [campaign]=15 # each changes what a night draws, asks or keeps
  [scene]=12    # it draws and proves; an SRDF is read and written
  [gate]=14     # a build server needs its files and a baseline; --laws prints what it checks
)
for command in $("$daylight" --help | sed -n '/^Examples/q; s/^  \([a-z]\+\) .*/\1/p'); do
  "$daylight" "$command" --help >out
  count=$(sed -n 's/^  \(--[a-z-]\+\).*/\1/p' out | sed 's/^--\(plugin\|command\|claim\|run-guests\)$/--guests/' | sort -u | wc -l)
  ((count <= ${more[$command]:-10})) || failed "$command has $count options, not at most ${more[$command]:-10}"
done

says 'families' 0 '.*random .*' families
says 'an unknown family' 64 '' families nobody
says 'pairs of a family' 0 '.*"id":"random/7/5".*'$'\n''.*"id":"random/7/6".*' families random --seed 7 --from 5 --count 2
"$daylight" families random --count 1000 | "$daylight" check >out || failed 'a family through check'
[[ $(wc -l <out) == 1000 ]] || failed 'a family through check: an answer a line'

says 'the worst of nobody' 64 '' worst --method nobody
worst='.*ode-contacts-8 side-rim margin [0-9.e-]+ wrong_[a-z]+ \(beyond its claim\) \{.*\}'
says 'the worst of a library' 2 "$worst" worst --method ode-contacts-8 --feature side-rim --evaluations 200 --out worst.jsonl
says 'the worst replayed' 2 '.* replayed, [12] beyond a claim.*' replay worst.jsonl --methods ode-contacts-8

# An answer comes before the next question is asked.
coproc "$daylight" check
for _ in 1 2 3; do
  printf '%s\n' "$apart" >&"${COPROC[1]}"
  read -rt 20 answer <&"${COPROC[0]}" || { failed 'no answer until the input ends'; break; }
done
[[ $answer == '{"verdict":"disjoint",'* ]] || failed 'the answer in a conversation'
exec {COPROC[1]}>&-

# A reader that goes away is no error worth a word; a full disk is.
(set +o pipefail; "$daylight" families random --count 100000 2>err | head -n 1 >out)
[[ ! -s err && $(wc -l <out) == 1 ]] || failed 'a closed pipe'
if [[ -w /dev/full ]]; then
  code=0
  "$daylight" families random >/dev/full 2>err || code=$?
  [[ $code == 1 && -s err ]] || failed "a full disk: exit code $code"
fi

# Whole numbers: digits only, in base ten, in range; what is wrong is said by the option's name.
: >in
for number in -1 +1 1x 1.5 0x10 '' 18446744073709551616; do
  says "a count '$number'" 64 '' families random --count "$number"
  grep -qF -- "--count: '$number' is not a whole number from " err || failed "a count '$number': what is wrong"
done
says 'no pairs' 64 '' bench --pairs 0
says 'help of chart' 0 '.*Examples:.*' chart --help
says 'no run to chart' 64 '' chart nowhere
says 'a folder that holds no run' 64 '' chart empty
says 'no jobs' 64 '' campaign --jobs 0
says 'too many jobs' 64 '' campaign --jobs 1025
[[ $(<err) == *"--jobs: '1025' is not a whole number from 1 to 1024"* ]] || failed 'the range of an option'
says 'the greatest seed' 0 '.*"id":"random/18446744073709551615/0".*' families random --seed 18446744073709551615 --count 1
says 'a leading zero' 0 '.*"id":"random/10/0".*' families random --seed 010 --count 1
