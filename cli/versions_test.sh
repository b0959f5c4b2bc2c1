#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# versions finds when a fault came and went, asks only new versions, and survives a kill. The registry is a folder here.
set -euo pipefail
# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"
command -v node >/dev/null || exec "$source_tree/.ci/skip" 'no Node.js here: apt-get install nodejs'

export XDG_CACHE_HOME=$PWD/cache npm_log=$PWD/npm_log packages=$PWD/packages
# What `npm view` and `npm install` do for versions in a folder; the one named in `deadly` kills who asked for it.
mkdir -p bin packages
cat >bin/npm <<'END_NPM'
#!/usr/bin/env bash
echo "$1 ${PWD##*@}" >>"$npm_log"
[[ -d $packages ]] || { echo '{"error":{"code":"ENOTFOUND"}}'; exit 1; }
[[ $1 != view || $2 == @dimforge/rapier3d-compat ]] || { echo '{"error":{"code":"E404"}}'; exit 1; }
if [[ $1 == view ]]; then
  cd "$packages" && times=$(for v in *; do printf ',"%s":"2025-01-1%s"' "$v" "${v:4:1}"; done)
  echo "{\"time\":{\"created\":\"2025-01-01T00:00:00Z\"$times},\"dist-tags\":{\"latest\":\"0.1.4\"}}"
  exit
fi
version=$(sed 's/.*: "\([0-9.]*\)".*/\1/' package.json)
mkdir -p node_modules/@dimforge/rapier3d-compat
[[ $version != "${deadly-}" ]] || kill -KILL "$PPID"
cd node_modules/@dimforge/rapier3d-compat && cp "$packages/$version" index.mjs && echo '{"exports":"./index.mjs"}' >package.json
END_NPM
chmod +x bin/npm
PATH=$PWD/bin:$PATH
release() { # VERSION TRUE-OR-FALSE: one whose solids always meet, or never
  cat >"packages/$1" <<END_JS
class Shape { intersectsShape() { return $2; } }
export default { init() {}, version: () => '$1', Ball: Shape, Capsule: Shape, Cylinder: Shape, RoundCylinder: Shape };
END_JS
}
release 0.1.0 true
release 0.1.1 false
release 0.1.2 false
echo 'this is no JavaScript' >packages/0.1.3
release 0.1.4 true
release 0.1.5-beta false

rapier=("$daylight" versions --npm @dimforge/rapier3d-compat --pairs 60)
expect 2 'all but the prerelease' "${rapier[@]}" --page page.md
holds 'counts' out '^4 versions answered [0-9]+ pairs each'
holds 'came and went' out '^\| cylinder - cylinder: disjoint \| 0.1.0 \(2025-01-10\) \| 0.1.1 \(2025-01-11\) \| 0.1.4 \(2025-01-14\) \|'
holds 'went and came again' out '^\| cylinder - cylinder: intersecting \| - \| 0.1.0 \(2025-01-10\) \| 0.1.1 \(2025-01-11\) \|'
holds 'equal ones' out '^\| 2 \| 0.1.1 \| 0.1.2 \|'
holds 'a broken one' out '^Not asked, .*: 0.1.3\.$'
cp out before
diff <(sed -n '/^## /,$p' page.md) out || failed 'the page differs from what is printed'
equal 'versions installed' 5 "$(grep -c install npm_log)"

# Only new versions are asked, and a broken one again.
expect 2 'again' "${rapier[@]}"
equal 'the same report' "$(<before)" "$(<out)"
holds 'the broken one is asked again' err '0\.1\.3'
lacks 'no other is' err '0\.1\.[0124]'
expect 2 'other pairs' "${rapier[@]/60/61}"
holds 'other pairs are asked' err '0\.1\.0'

# Killed half way, it continues: two versions are there, and the third is installed anew.
rm -r cache npm_log
deadly=0.1.2 expect 137 'killed' "${rapier[@]}"
expect 2 'continued' "${rapier[@]}"
lacks 'no result is lost' err '0\.1\.[01] '
equal 'the same report after a kill' "$(<before)" "$(<out)"
equal 'installs' '0 1 2 2 3 4' "$(sed -n 's/^install 0\.1\.\([0-9]\).*/\1/p' npm_log | paste -sd ' ')"

# Ranges and errors.
expect 2 'a range' "${rapier[@]}" --from 0.1.1 --to 0.1.2
holds 'nothing changed' out '^2 versions .* None of these came or went. Nothing changed'
expect 64 'no version' "${rapier[@]}" --from 7
holds 'what there is' err 'no version from 7 to latest: it has 0.1.0 to 0.1.4'
expect 64 'not a version' "${rapier[@]}" --from new
expect 64 'no guest' "$daylight" versions --npm left-pad
holds 'the guests' err 'no guest for left-pad. It has .*jolt-physics'
expect 64 'unknown' "$daylight" versions --npm jolt-physics
holds 'unknown' err 'npm knows no package jolt-physics'
expect 64 'nothing to ask' "$daylight" versions --plugin ./one.so
mv packages away
expect 2 'offline' "${rapier[@]}"
holds 'kept ones' err 'only the kept versions'
holds 'kept ones' out '^4 versions'
XDG_CACHE_HOME=$PWD/empty expect 1 'offline, nothing kept' "${rapier[@]}"
holds 'the remedy' err 'try again with a network'
mkdir none
ln -s "$(python3 -c 'import sys; print(sys.executable)')" none/python3
ln -s "$(command -v node)" none
expect 1 'no npm' env PATH="$PWD/none" "$daylight" versions --npm jolt-physics
holds 'the remedy' err 'npm is not here: apt-get install npm'
expect 1 'no Python' env PATH=/nowhere "$daylight" versions --npm jolt-physics
holds 'the remedy' err 'python3: .*; install it: apt-get install python3'

# Plug-ins and programs: daylight itself is the one that is right.
cat >bad.c <<'END_C'
#include "plugin.h"
static int ask(const double* a, const double* b, double* point) { return DAYLIGHT_DISJOINT; }
static const struct DaylightMethod bad = {DAYLIGHT_PLUGIN_ABI, "bad", "1", 1e-6, 0, 0, ask, 0};
const struct DaylightMethod* daylight_method(void) { return &bad; }
END_C
cc -shared -fPIC -I "$source_tree/oracles" bad.c -o libbad.so
printf 'while read -r q; do echo "{\\"verdict\\":\\"disjoint\\"}"; done\n' >bad.sh
local=("$daylight" versions --pairs 60 --plugin ./libbad.so --command "good='$daylight' check -" --command 'sh bad.sh')
expect 2 'three' "${local[@]}"
holds 'first bad, and good again' out '^\| cylinder - cylinder: disjoint \| - \| ./libbad.so \| good=.* \|'
holds 'each is asked' out '^\| 1 \| sh bad.sh \|'
expect 2 'again' "${local[@]}"
equal 'none is asked' '' "$(<err)"
echo '# changed' >>bad.sh
expect 2 'a changed program' "${local[@]}"
equal 'it is asked' 'daylight: plug-ins and commands sh bad.sh ...' "$(<err)"
expect 64 'one that does not start' "$daylight" versions --pairs 60 --command 'exit 3' --command 'exit 4'
holds 'which' err "'exit 3'"
