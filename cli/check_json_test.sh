#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# check_json_test.sh DAYLIGHT: each line that check writes is JSON, one for each line in, whatever that holds.
set -euo pipefail
daylight=$1
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
solid='{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2}'
fault() { printf '{"a":%s,"b":%s}\n' "$solid" "${solid/"$1"/"$2"}"; }
{
  # Distances beyond the doubles, numbers that are none, ids and keys of every kind of byte.
  fault '[0,0,0]' '[1.7e308,1.7e308,0]' | sed 's/\[0,0,0\]/[-1.7e308,0,0]/'
  printf '{"a":%s,"b":%s}\n' "${solid/:1,/:1.7e308,}" "${solid/:1,/:1.7e308,}" | sed 's/:2}/:1.7e308}/g'
  for number in 1e999 -1e999 1e-999 NaN Infinity inf null '"1"' 0x1p3 -1 1e-308 5e-324 '' '\u0000'; do
    fault :1, ":$number,"
    fault '[0,0,0]' "[0,$number,0]"
  done
  for id in 'a\u0000\u001b[31m\u2028\ud83d\ude00' 'quo\"te\\' $'\x7f' $'\xc3\xa9'; do
    printf '{"a":%s,"b":%s,"id":"%s"}\n' "$solid" "$solid" "$id"
    printf '{"a":%s,"b":%s,"truth":"%s"}\n' "$solid" "$solid" "$id"
    printf '{"a":%s,"%s":1}\n' "$solid" "$id"
  done
  printf '{"a":{"\xff":1}}\n[\n"\xed\xa0\x80"\n\x01\n{"a":\x00}\n'
  "$daylight" families tiny_and_huge --count 50 --seed 3
} >"$folder/lines"
for options in '' --distance '--method decide' '--method distance' '--method exact'; do
  read -ra words <<<"$options"
  "$daylight" check "${words[@]}" "$folder/lines" >"$folder/answers" || [[ $? == 65 ]]
  python3 - "$folder/lines" "$folder/answers" <<'END'
import json, sys
def refuse(word):
    raise ValueError(word)
lines = open(sys.argv[1], 'rb').read().splitlines()
answers = [json.loads(line, parse_constant=refuse) for line in open(sys.argv[2], 'rb').read().split(b'\n')[:-1]]
assert len(answers) == len([x for x in lines if x.strip()]), (len(lines), len(answers))
assert all('verdict' in answer or 'declined' in answer for answer in answers)
if any('distance' in x and isinstance(x['distance'], list) for x in answers):
    assert any('6.3e308' in x['distance'] for x in answers if 'distance' in x), 'no end beyond the doubles'
END
done
