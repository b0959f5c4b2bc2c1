#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints which branches of the solver and the referee no pair of the gate takes; exit status 1 if any.

    tools/untaken_branches.py [--as-built] [--argued] [ARGUMENT OF daylight gate..]

Compiles solver/ and oracles/referee/ once more, by clang with counters, links them in front of what ./daylight has built,
runs the gate and reads llvm-cov: some three minutes. The counters are those of the source, not of the machine code: a
condition counts once wherever it is inlined and for whatever types it is instantiated. What stands behind a branch that
is not taken is not listed again. Not counted: exceptions, what the compiler runs (constexpr), and values of an enum that a
switch has no case for.

A branch that no pair can take has a line beside it, or in the comment above its statement, that argues why; above a
function, `within` argues for every branch of it:

    // not covered: <reason>
    // not covered within: <reason>

A line of that kind where all branches are taken is an error too. --argued lists what they excuse; --as-built builds nothing
of ./daylight first. Everything is written to build/untaken/.
"""
import collections
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ROOMS = re.compile(r'(solver|solver/detail|oracles/referee)/[^/]+\.[ch]pp$')
OBJECTS = re.compile(r'CMakeFiles/daylight_(solver|oracles_referee)\.dir/(.*)')
ARGUMENT = re.compile(r'//.*\bnot covered( within)?: (?=\S)(.*)')
# The counters lie in a mapped file, so that those of the gate's child processes are there when these are gone.
COUNTERS = ('-fprofile-instr-generate', '-mllvm', '-runtime-counter-relocation')
TOOLS = ('clang++', 'llvm-profdata', 'llvm-cov')

Branch = collections.namedtuple('Branch', 'line column what text')


def run(command, **options):
    return subprocess.run(command, check=True, **options)


def compiled(folder, out):
    """Compiles what has counters; returns the objects."""
    with open(os.path.join(folder, 'compile_commands.json'), encoding='utf-8') as file:
        entries = json.load(file)
    objects, waiting = [], []
    for entry in entries:
        words = shlex.split(entry['command'])
        place = OBJECTS.match(words[words.index('-o') + 1])
        if not place:
            continue
        objects.append(os.path.join(out, place[2]))
        os.makedirs(os.path.dirname(objects[-1]), exist_ok=True)
        # Not GCC's precompiled header and warnings, and no other optimisation: -O2 leaves every counter where it is.
        words = words[1:words.index('-o')]
        if '-include' in words:
            del words[words.index('-include'):words.index('-include') + 2]
        flags = [w for w in words if not w.startswith(('-W', '-O', '-ffile-prefix-map', '-fno-semantic'))]
        waiting.append(['clang++', *flags, '-O2', '-w', *COUNTERS, '-fcoverage-mapping', '-c', entry['file'],
                        '-o', objects[-1]])
    jobs = []
    for command in waiting:
        if len(jobs) == os.cpu_count() and jobs.pop(0).wait():
            sys.exit('untaken_branches: a source does not compile')
        jobs.append(subprocess.Popen(command, cwd=folder))
    if any([job.wait() for job in jobs]):
        sys.exit('untaken_branches: a source does not compile')
    return objects


def linked(folder, out, objects):
    """Links them in front of the libraries, of which then no member with the same functions is taken."""
    commands = run(['ninja', '-C', folder, '-t', 'commands', 'daylight'], stdout=subprocess.PIPE, encoding='utf-8').stdout
    words = [w for w in shlex.split(commands.splitlines()[-1]) if w not in (':', '&&')]
    program = os.path.join(out, 'daylight')
    words[0] = 'clang++'
    words[words.index('-o') + 1] = program
    words[words.index('-o'):words.index('-o')] = objects
    run([*words, '-fprofile-instr-generate'], cwd=folder)
    return program


def counted(out, program, arguments):
    """Runs the gate; returns what llvm-cov says of each function, and of the gate its last line and exit code."""
    raw = os.path.join(out, 'raw')
    shutil.rmtree(raw, ignore_errors=True)
    os.makedirs(raw)
    gate = subprocess.run([program, 'gate', *arguments], cwd=ROOT, stdout=subprocess.PIPE, encoding='utf-8',
                          env={**os.environ, 'LLVM_PROFILE_FILE': os.path.join(raw, '%p%c.profraw')})
    with open(os.path.join(out, 'gate.txt'), 'w', encoding='utf-8') as file:
        file.write(gate.stdout)
    profile = os.path.join(out, 'profdata')
    run(['llvm-profdata', 'merge', '-o', profile, *(os.path.join(raw, name) for name in os.listdir(raw))])
    exported = run(['llvm-cov', 'export', '-format=text', '-instr-profile', profile, program], stdout=subprocess.PIPE)
    return json.loads(exported.stdout)['data'][0]['functions'], gate.returncode


def folded(functions, root):
    """Adds up instances: {path: (functions, conditions)}, both by (line, column, to line, to column), with how often they
    were called, and were [true, false]."""
    files = collections.defaultdict(lambda: ({}, {}))
    for function in functions:
        paths = [os.path.relpath(name, root) for name in function['filenames']]
        if ROOMS.match(paths[0]):
            place, calls = tuple(function['regions'][0][:4]), files[paths[0]][0]
            calls[place] = calls.get(place, 0) + function['count']
        for line, column, to_line, to_column, yes, no, file, *_ in function['branches']:
            if ROOMS.match(paths[file]):
                ways = files[paths[file]][1].setdefault((line, column, to_line, to_column), [0, 0])
                ways[0] += yes
                ways[1] += no
    return files


def text_between(lines, line, column, to_line, to_column):
    part = lines[line - 1:to_line]
    part[-1] = part[-1][:to_column - 1]
    part[0] = part[0][column - 1:]
    return ' '.join(' '.join(part).split())


def branches_of(lines, calls, conditions):
    """Returns how many branches a file has, and those of them that are not taken."""
    count, untaken = 0, []
    for (line, column, *_), times in calls.items():
        if times == 0 and lines[line - 1].lstrip().startswith('constexpr'):
            continue
        count += 1
        if times == 0:
            untaken.append(Branch(line, column, 'never called', lines[line - 1].strip()))
    for place, (yes, no) in conditions.items():
        text = text_between(lines, *place)
        if re.search(r'\bswitch \($', lines[place[0] - 1][:place[1] - 1]):
            continue  # the values that have no case
        is_case = re.match(r'(case|default)\b', text)
        count += 1 if is_case else 2
        if yes == no == 0:
            continue  # behind another branch, or constant
        if yes == 0:
            untaken.append(Branch(*place[:2], 'never' if is_case else 'never true', text))
        if no == 0 and not is_case:
            untaken.append(Branch(*place[:2], 'never false', text))
    return count, sorted(untaken)


def argument_beside(lines, number):
    """Returns the line that argues in the statement of which line `number` is part, or above it, or 0."""
    while True:
        if ARGUMENT.search(lines[number - 1]):
            return number
        above = lines[number - 2].strip() if number > 1 else ''
        if not above.startswith('//'):
            code = above.partition('//')[0].rstrip()
            if not code or code[-1] in ';{}:' or lines[number - 1].lstrip().startswith('//'):
                return 0
        number -= 1


def arguments_for(lines, calls, untaken):
    """Returns of each branch the line that argues for it, or 0."""
    whole = []
    for line, _, to_line, _ in calls:
        at = argument_beside(lines, line)
        if at and ARGUMENT.search(lines[at - 1])[1]:
            whole.append((line, to_line, at))
    for branch in untaken:
        yield argument_beside(lines, branch.line) or next(
            (at for line, to_line, at in whole if line <= branch.line <= to_line), 0)


def main():
    arguments = sys.argv[1:]
    chosen = {name for name in ('--as-built', '--argued') if name in arguments}
    arguments = [a for a in arguments if a not in chosen]
    missing = [tool for tool in TOOLS if not shutil.which(tool)]
    if missing:
        print(f'untaken_branches: skipped, no {", ".join(missing)}: apt-get install clang llvm libclang-rt-14-dev', file=sys.stderr)
        sys.exit(77)
    start = time.monotonic()
    folder, out = os.path.join(ROOT, 'build', 'release'), os.path.join(ROOT, 'build', 'untaken')
    if '--as-built' not in chosen:
        run([os.path.join(ROOT, 'daylight'), '--version'], stdout=subprocess.DEVNULL)
    functions, status = counted(out, linked(folder, out, compiled(folder, out)), arguments)

    total = taken = argued = stale = left = 0
    files = folded(functions, ROOT)
    listed = run(['git', 'ls-files', 'solver', 'oracles/referee'], cwd=ROOT, stdout=subprocess.PIPE, encoding='utf-8')
    for path in sorted({p for p in listed.stdout.split() if ROOMS.match(p)} | set(files)):
        with open(os.path.join(ROOT, path), encoding='utf-8') as file:
            lines = file.read().split('\n')
        count, untaken = branches_of(lines, *files[path])
        total += count
        taken += count - len(untaken)
        used = list(arguments_for(lines, files[path][0], untaken))
        argued += sum(at > 0 for at in used)
        left += used.count(0)
        for branch, at in zip(untaken, used):
            if at == 0 or '--argued' in chosen:
                reason = '   // ' + ARGUMENT.search(lines[at - 1])[2] if at else ''
                print(f'{path}:{branch.line}:{branch.column}: {branch.what}: {branch.text}{reason}')
        for number, line in enumerate(lines, 1):
            if ARGUMENT.search(line) and number not in used:
                print(f'{path}:{number}: argues for nothing: all branches here are taken, or none is looked at')
                stale += 1
    print(f'{total} branches: {taken} taken or behind one that is not, {argued} argued, {left} not taken; {stale} arguments '
          f'for nothing; gate exit code {status}, {time.monotonic() - start:.0f} s')
    sys.exit(left + stale > 0)


if __name__ == '__main__':
    main()
