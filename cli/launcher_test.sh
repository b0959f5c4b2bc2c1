#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The launcher, copied into a project of one file: what it prints where, what it exits with, what it installs.
set -euo pipefail

# shellcheck source=SCRIPTDIR/expect.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/expect.sh"
launcher=$source_tree/daylight
home="$scratch/a checkout" # the path holds a space
mkdir -p "$home" "$scratch/no packages" "$scratch/elsewhere"
cp -- "$launcher" "$home/daylight"
ln -s "$home/daylight" "$scratch/link"

cat >"$home/CMakePresets.json" <<'JSON'
{"version": 6, "configurePresets": [
  {"name": "release", "generator": "Ninja", "binaryDir": "${sourceDir}/build/release"},
  {"name": "clang", "generator": "Ninja", "binaryDir": "${sourceDir}/build/clang"}]}
JSON
cat >"$home/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(toy LANGUAGES CXX)
add_executable(daylight main.cpp)
add_executable(fuzz_core_libfuzzer EXCLUDE_FROM_ALL main.cpp)
enable_testing()
add_test(NAME toy COMMAND daylight)
CMAKE
cat >"$home/main.cpp" <<'CPP'
#include <cstdio>
int main(int argc, char**) { std::puts("hello"); return argc - 1; }
CPP

# Runs a launch in the folder elsewhere/; leaves out, err and code.
launch() {
  code=0
  (cd "$scratch/elsewhere" && "$@") >"$scratch/out" 2>"$scratch/err" </dev/null || code=$?
  out=$(<"$scratch/out") err=$(<"$scratch/err")
}

# Without the packages and without a terminal an ordinary user reads the command; nothing is built.
printf '#!/bin/sh\nexit 1\n' >"$scratch/no packages/dpkg-query"
printf '#!/bin/sh\necho 1000\n' >"$scratch/no packages/id"
chmod +x "$scratch/no packages/"*
launch env PATH="$scratch/no packages:$PATH" "$home/daylight"
equal 'missing packages: exit code' 1 "$code"
equal 'missing packages: standard output' '' "$out"
equal 'missing packages: the command is shown' yes "$([[ $err == *"apt-get install -y --no-install-recommends cmake g++ "* ]] && echo yes)"
equal 'missing packages: nothing is built' no "$([[ -e $home/build/release ]] && echo yes || echo no)"

# Root installs them. (The package tools of this test say so and do nothing.)
printf '#!/bin/sh\necho 0\n' >"$scratch/no packages/id"
printf '#!/bin/sh\necho "$*" >>"%s/installed"\n' "$scratch" >"$scratch/no packages/apt-get"
chmod +x "$scratch/no packages/apt-get"
launch env PATH="$scratch/no packages:$PATH" "$home/daylight"
equal 'root: exit code' 0 "$code"
equal 'root: packages are installed' update "$(head -n 1 "$scratch/installed")"

# What is piped in is the command's, though tools that install and build would read it.
rm -rf "$home/build"
printf '#!/bin/sh\necho "$*" >>"%s/installed"\ncat >/dev/null\n' "$scratch" >"$scratch/no packages/apt-get"
printf '#!/bin/sh\ncat >/dev/null\nexec %s "$@"\n' "$(command -v cmake)" >"$scratch/no packages/cmake"
printf '#!/bin/sh\ncat >/dev/null\nexec %s "$@"\n' "$(command -v ninja)" >"$scratch/no packages/ninja"
chmod +x "$scratch/no packages/"*
cp "$home/main.cpp" "$scratch/main.cpp"
printf '#include <cstdio>\nint main() { for (int c; (c = std::getchar()) != EOF;) std::putchar(c); }\n' >"$home/main.cpp"
equal 'first use in a pipe' 'a pair' "$(printf 'a pair\n' | PATH="$scratch/no packages:$PATH" "$home/daylight" 2>/dev/null)"
cp "$scratch/main.cpp" "$home/main.cpp"

# Two first builds at once, one through a link.
rm -rf "$home/build/release"
(cd "$scratch" && ./link >"$scratch/out2" 2>/dev/null) &
launch "$home/daylight" one two three
wait $!
equal 'arguments and exit code' 3 "$code"
equal 'standard output' hello "$out"
equal 'through a link, at the same time' hello "$(<"$scratch/out2")"

launch "$home/daylight"
equal 'nothing to build: standard error' '' "$err"
equal 'nothing to build: exit code' 0 "$code"

# What is built starts without the build tool; a file that came, went or changed calls it.
mkdir "$scratch/no ninja"
printf '#!/bin/sh\necho called >&2\nexit 1\n' >"$scratch/no ninja/ninja"
chmod +x "$scratch/no ninja/ninja"
launch env PATH="$scratch/no ninja:$PATH" "$home/daylight"
equal 'nothing to build: no build tool is called' 'hello' "$out$err"
mkdir "$home/runs"
launch env PATH="$scratch/no ninja:$PATH" "$home/daylight"
equal 'a run is not a source' 'hello' "$out$err"
mkdir "$home/room"
touch "$home/room/new.cpp"
launch env PATH="$scratch/no ninja:$PATH" "$home/daylight"
equal 'a new file calls the build tool' 1 "$code"
launch "$home/daylight"
rm "$home/room/new.cpp"
launch env PATH="$scratch/no ninja:$PATH" "$home/daylight"
equal 'a removed file calls the build tool' 1 "$code"

# Who has to wait for another build is informed.
exec {held}>"$home/build/lock"
flock "$held"
(cd "$scratch/elsewhere" && exec {held}>&- && exec "$home/daylight") >"$scratch/out2" 2>"$scratch/err2" </dev/null &
until grep -qs 'waiting for another' "$scratch/err2"; do sleep 0.05; done
exec {held}>&-
wait $!
equal 'after the wait' hello "$(<"$scratch/out2")"

# A folder that was moved is built again.
mv "$home" "$scratch/moved"
launch "$scratch/moved/daylight"
equal 'a moved folder: exit code' 0 "$code"
equal 'a moved folder: standard output' hello "$out"
equal 'a moved folder is reported' yes "$([[ $err == *'moved or copied'* ]] && echo yes)"
mv "$scratch/moved" "$home"

sed -i 's/hello/goodbye/' "$home/main.cpp"
launch "$home/daylight"
equal 'a change is built' goodbye "$out"
equal 'a build shows its steps' yes "$([[ $err == *Building* ]] && echo yes)"

# What fuzzes is built for those who fuzz alone, and only where clang++ is.
# ccache gives a program of this name an option that only clang has.
printf '#!/bin/bash\nexec c++ "${@/#-fcolor-diagnostics/-O0}"\n' >"$scratch/no packages/clang++"
chmod +x "$scratch/no packages/clang++"
equal 'without fuzz: no fuzzer' no "$([[ -e $home/build/clang ]] && echo yes || echo no)"
launch env PATH="$scratch/no packages:$PATH" "$home/daylight" fuzz --target=core
equal 'fuzz: exit code' 2 "$code"
equal 'fuzz: its program is built' yes "$([[ -x $home/build/clang/fuzz_core_libfuzzer ]] && echo yes)"
rm -rf "$home/build/clang"
launch env PATH="$scratch/no packages:$PATH" "$home/daylight" campaign --for 1m
equal 'a campaign without --fuzz: nothing is built' no "$([[ -e $home/build/clang ]] && echo yes || echo no)"
launch env PATH="$scratch/no packages:$PATH" "$home/daylight" fuzz --target none
equal 'fuzz: an unknown target is left to the command' 3 "$code"
equal 'fuzz: an unknown target: nothing is built' no "$([[ -e $home/build/clang ]] && echo yes || echo no)"

# What tests need is installed for `test` alone: Node.js and npm only where there are none, what npm brings only once. Who
# cannot install it learns how, and the tests that do without run.
few=$scratch/few # every program but these two
mkdir "$few"
ln -s /usr/sbin/* /usr/bin/* "$few" 2>/dev/null || true
ln -sf "$(command -v cmake)" "$(command -v ninja)" "$few"
rm -f "$few/node" "$few/npm"
mkdir "$scratch/stubs" "$scratch/npm"
cat >"$scratch/stubs/dpkg-query" <<'SH'
#!/bin/sh
shift 2
for package; do [ "$package" = chromium ] || [ "$package" = nodejs ] || [ "$package" = npm ] || echo "installed $package"; done
SH
printf '#!/bin/sh\necho 1000\n' >"$scratch/stubs/id"
cat >"$scratch/npm/npm" <<SH
#!/bin/sh
echo "\${PWD##*/} \$*" >>"$scratch/npm said"
mkdir -p node_modules
touch node_modules/.package-lock.json
SH
cp "$scratch/npm/npm" "$scratch/npm/node"
chmod +x "$scratch/stubs/"* "$scratch/npm/"*
mkdir -p "$home/reports/web"
touch "$home/reports/web/package-lock.json"
launch env PATH="$scratch/stubs:$few" "$home/daylight" test --install-only
equal 'test --install-only: exit code' 0 "$code"
equal 'test: what it lacks is reported' yes "$([[ $err == *'--no-install-recommends chromium nodejs npm'* ]] && echo yes)"
equal 'test: that tests are skipped is reported' yes "$([[ $err == *'will be skipped'* ]] && echo yes)"
launch env PATH="$scratch/stubs:$scratch/npm:$few" "$home/daylight" test
equal 'test: not where there are Node.js and npm' yes "$([[ $err == *"--no-install-recommends chromium'"* ]] && echo yes)"
equal 'test: exit code' 0 "$code"
launch env PATH="$scratch/stubs:$scratch/npm:$few" "$home/daylight" test --install-only
equal 'test: npm was asked once' 'web ci' "$(<"$scratch/npm said")"
launch env PATH="$scratch/stubs:$scratch/npm:$few" "$home/daylight" test
equal 'test: the last lines are those of ctest' yes "$([[ $out == *'100% tests passed'*'Total Test time'* ]] && echo yes)"

echo 'this is no C++' >>"$home/main.cpp"
launch "$home/daylight"
equal 'a failed build: exit code' 1 "$code"
equal 'a failed build: standard output' '' "$out"
equal 'a failed build: the compiler is heard' yes "$([[ $err == *error:* ]] && echo yes)"
