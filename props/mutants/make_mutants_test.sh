#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# make_mutants_test.sh MAKE_MUTANTS.PY: it refuses what has rotted, and its copies are the originals but for switches.
set -euo pipefail
make=$1
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
mkdir -p "$folder/props/mutants" "$folder/solver"
printf 'int f(int a) {\n  return a + 1;\n}\nint g(int a) { return a + 2; }\n' >"$folder/solver/x.cpp"

entry() { printf '{"number":%s,"file":"solver/x.cpp","find":"%s","replace":"%s","what":"w","like":"l"%s}\n' "$@"; }
accepts() { "$make" "$folder" "$folder/out" || { echo "refused: $1"; exit 1; }; }
refuses() {
  if "$make" "$folder" "$folder/out" 2>"$folder/error"; then echo "accepted: $1"; exit 1; fi
  grep "$2" "$folder/error" >/dev/null || { echo "wrong reason for $1:"; cat "$folder/error"; exit 1; }
}
list() { cat >"$folder/props/mutants/mutants.jsonl"; }

{ entry 1 'a + 1' 'a - 1' ''; entry 2 'a + 1' 'a' ''; entry 3 'return a + 1;' 'return 0;' ''
  entry 4 'a' '9' ',"near":"a + 2"'; } | list
accepts 'expression, twice, within a statement'
sed -n 3,99p "$folder/out/solver/x.cpp" | diff - <(cat <<'EOF'
int f(int a) {
  { if (::cyl::mutant_is(3)) { return 0; } else { return (::cyl::mutant_is(2) ? (a) : ((::cyl::mutant_is(1) ? (a - 1) : (a + 1)))); } }
}
int g(int a) { return (::cyl::mutant_is(4) ? (9) : (a)) + 2; }
EOF
)
entry 1 'a + 3' 'a' '' | list; refuses 'a text that is gone' 'mutant 1: `find` is 0 times'
entry 1 'int a' 'a' '' | list; refuses 'a text found twice' 'is 2 times'
entry 1 'a' 'b' ',"near":"a + 5"' | list; refuses 'a place that is gone' '`near` is 0 times'
entry 1 'a + 1' 'a + 1' '' | list; refuses 'a mutant that changes nothing' 'changes nothing'
entry 0 'a + 1' 'a' '' | list; refuses 'number 0' 'its number'
{ entry 1 'a + 1' 'a' ''; entry 1 'a + 2' 'a' ''; } | list; refuses 'a number twice' 'its number'
{ entry 1 'return a + 1' 'x' ''; entry 2 '+ 1;' 'x;' ''; } | list; refuses 'texts that overlap' 'overlaps'
entry 1 'a + 1' 'a' ',"ask":"decide"' | list; refuses 'an unknown field' "unknown: \['ask'\]"
echo 'no json' | list; refuses 'no JSON' 'not JSON'
