#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The package for Node.js as somebody without a network installs it: npx, node:test, what is excluded, what hangs.
set -euo pipefail

here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
# shellcheck source=SCRIPTDIR/../../cli/expect.sh
source "$here/../../cli/expect.sh"
for program in node npm; do
  command -v $program >/dev/null || exec "$source_tree/.ci/skip" "no $program here: apt-get install nodejs npm"
done

mkdir source # npm pack writes into the folder
cp -r "$source_tree/vectors" "$source_tree/LICENSE" source
expect 0 'npm pack' npm pack --silent --pack-destination "$scratch" ./source/vectors/js
[[ ! -e source/vectors/js/v1 && ! -e source/vectors/js/LICENSE ]] || failed 'npm pack left its copies'
equal 'what is packed' 'LICENSE asked.mjs command.mjs package.json runner.mjs v1/flags.json v1/schema.json v1/smoke.json v1/standard.json' \
  "$(tar tf daylight-vectors-*.tgz | sed 's|^package/||' | sort | paste -sd ' ')"
mkdir project && cd project
expect 0 'npm install' npm install --silent --offline ../daylight-vectors-*.tgz
cat >known.mjs <<'END_OF_FILE'
import { load } from 'daylight-vectors';
import { appendFileSync } from 'node:fs';
const numbers = (s) => [...s.center, ...s.axis, s.radius, s.height, s.rounding ?? 0].map((x) => String(x).replace('inf', 'Infinity').replace('nan', 'NaN'));
const key = (a, b) => [...numbers(a), ...numbers(b)].join();
const known = new Map(load('standard').map((v) => [key(v.a, v.b), v]));
export function of(a, b) {
  const v = known.get(key(a, b));
  appendFileSync('asked', `${v.id}\n`);
  return v;
}
END_OF_FILE
cat >right.mjs <<'END_OF_FILE'
import { of } from './known.mjs';
export function collide(a, b) {
  const { result, distance: [low, high] = [] } = of(a, b);
  if (result === 'invalid') throw new RangeError('no solid');
  return result === 'touching' ? result : a.radius < 1 ? (low + high) / 2 : result !== 'disjoint';
}
END_OF_FILE
cat >blind.mjs <<'END_OF_FILE'
import { collide as right } from './right.mjs';
export const collide = async (a, b) => (a.rounding > 0 ? false : right(a, b));
END_OF_FILE
cat >broken.mjs <<'END_OF_FILE'
import { existsSync, writeFileSync } from 'node:fs';
const faults = [() => { for (;;); }, () => process.exit(3), () => { throw new Error('no idea'); }, () => [1], () => 'far',
  () => NaN, () => { throw new RangeError('of a legal pair'); }, () => 'invalid'];
export function collide(a) {
  if (!(a.rounding > 0) || existsSync(`broke${process.env.FAULT}`)) return null;
  writeFileSync(`broke${process.env.FAULT}`, '');
  return faults[process.env.FAULT]();
}
END_OF_FILE

expect 0 'a function that is right' npx --offline daylight-vectors ./right.mjs --tier standard
holds 'all are asked' out '^2000 asked: 2000 right, 0 within the tolerance, 0 declined, 0 wrong; 0 excluded$'
[[ ! -e .daylight-vectors.json ]] || failed 'nothing failed, and something is stored'

expect 2 'a function that sees no rounding' npx --offline daylight-vectors ./blind.mjs
holds 'a failure' out '^Capsule 1e-0[0-9]: [0-9]+ wrong\. The simplest, v1-[0-9a-f]+: said false; they are intersecting, at'
holds 'its class of bug' out 'Class of bug: WRONG_VERDICT.*Met by .*jrouwe/JoltPhysics#2103'
grep -o 'v1-[0-9a-f]*' .daylight-vectors.json | sort >failed
((3 < $(wc -l <failed))) || failed 'few ids are stored'
rm asked
expect 0 'right again' npx --offline daylight-vectors ./right.mjs
equal 'what failed is asked first' "$(<failed)" "$(head -n "$(wc -l <failed)" asked | sort)"
equal 'what is right again is forgotten' '[]' "$(<.daylight-vectors.json)"

sed 's/$/ spheres are not ours/' failed >excluded
echo '# all of them' >>excluded
expect 0 'all excluded' npx --offline daylight-vectors ./blind.mjs --exclude excluded
holds 'they are counted' out "; $(wc -l <failed) excluded\$"
head -n 1 failed >excluded
expect 64 'without a reason' npx --offline daylight-vectors ./blind.mjs --exclude excluded
expect 0 'a wide tolerance' npx --offline daylight-vectors ./blind.mjs --tolerance 1e999
holds 'acceptable' out ' right, [1-9][0-9]* within the tolerance'
for wrong in '' nowhere.mjs known.mjs './right.mjs --tier' './right.mjs --tolerance wide'; do
  # shellcheck disable=SC2086 # arguments are words
  expect 64 "usage: $wrong" npx --offline daylight-vectors $wrong
done

fault=0
while read -r said; do
  FAULT=$fault expect 2 "fault $fault" npx --offline daylight-vectors ./broken.mjs --limit 1
  holds "fault $fault" out "1 wrong. The simplest, v1-[0-9a-f]+: $said"
  holds "the run goes on after fault $fault" out '^200 asked: 0 right, 0 within the tolerance, 199 declined, 1 wrong; 0 excluded$'
  fault=$((fault + 1))
done <<'END_OF_FILE'
gave no answer within 1 s
threw Error: called process.exit\(3\)
threw Error: no idea
said \[1\], which is no answer
said 'far', which is none of
said NaN; they are
threw RangeError: of a legal pair
said invalid of a pair that is
END_OF_FILE
rm .daylight-vectors.json

cat >all.test.mjs <<'END_OF_FILE'
import { tests } from 'daylight-vectors';
tests(new URL(process.env.MODULE, import.meta.url), { tolerance: 1e-9 });
END_OF_FILE
expect 0 'node:test' env MODULE=./right.mjs node --test --test-reporter=tap all.test.mjs
holds 'a test for each flag and decade' out '^ +ok [0-9]+ - daylight Coaxial 1e-0[0-9]$|^ok [0-9]+ - daylight Coaxial 1e-0[0-9]$'
expect 1 'node:test fails' env MODULE=./blind.mjs node --test --test-reporter=tap all.test.mjs
holds 'which' out 'not ok [0-9]+ - daylight Capsule 1e-0[0-9]$'
holds 'why' out '[0-9]+ wrong. The simplest, v1-'
expect 1 'node:test again' env MODULE=./blind.mjs node --test --test-reporter=tap all.test.mjs
equal 'what failed comes first' not "$(grep -m 1 -oE '^ *(not )?ok 1 - ' out | sed 's/ok.*//; s/ //g')"
echo 'export const collide = () => undefined;' >unable.mjs
expect 0 'node:test skips' env MODULE=./unable.mjs node --test --test-reporter=tap all.test.mjs
holds 'what is declined' out 'ok 1 - daylight .* # SKIP declined'
