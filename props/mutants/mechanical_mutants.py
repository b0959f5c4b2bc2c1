#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Builds mechanical mutants of the solver's and the referee's arithmetic and asks the gate about each.

    mechanical_mutants.py run --seed 1 --count 150 [--out FILE] [--only ID]    a built tree is needed: ./daylight --version
    mechanical_mutants.py report [--out FILE]       exit status 2 where one that counts got past, unless argued equivalent
    mechanical_mutants.py list [TEXT]               all of them, or those whose id has the text in it

Which changes there are says mutations.py beside this. The order in which they are drawn is that of a hash of seed and id:
what is added to a source moves no other. For each one only the objects that hold it are compiled, with the build's own
commands, and linked before its libraries. Then, until something notices:
    gate        daylight gate --first-failure, which changes no exit status: any but 0 closes it
    answers     daylight check --distance: a certificate fails in exact arithmetic of exact.py, or an answer
                contradicts that of the program as it is, or is undecided where that one is not
    tests       the unit tests of the solver and of the oracles
What does not compile, or compiles to the same machine code, is no mutant, and another is drawn. What ends in no time
(`unresolved`) counts as survived. Each one tried is a line of JSON in FILE; a run goes on behind those that it finds there
of the same text. Arguments why nothing can notice a survivor are in mechanical_equivalent.jsonl, by id, a sentence each.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import re
import resource
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path += [str(HERE), str(ROOT / 'vectors')]
import exact  # noqa: E402
from mutations import mutated, mutations  # noqa: E402

RESULTS, ARGUMENTS = HERE / 'mechanical.jsonl', HERE / 'mechanical_equivalent.jsonl'
ARITHMETIC = ('solver/*.cpp', 'solver/detail/*.?pp', 'oracles/referee/*.?pp')
FAMILY_PAIRS, FAMILY_SEED = 100, 20261122  # of each family, whose answers are checked beside those of all cases
# Seconds for one question, of CPU in one process and on the wall: forty times what the unmutated program takes.
CPU_CAP, WALL_CAP = 1600, 3600
TEST_SUITES = {'solver_tests': '*', 'oracles_tests': 'Textbook*:EnclosedDistance*:MpFloat*:Referee*:Filter*:Enclosure*:'
               'Tangency*:RootSum*:SimplestWithin*:Judge*:Contains*:AttainedDistanceOf*:Proofs*:OwnMethods*'}


def population(root):
    files = sorted({path for pattern in ARITHMETIC for path in root.glob(pattern) if not path.stem.endswith('_test')})
    for path in files:
        name = path.relative_to(root).as_posix()
        yield from mutations(name, path.read_text(encoding='utf-8'))


def drawn(root, seed):
    return sorted(population(root), key=lambda m: hashlib.sha256(f'{seed} {m.id}'.encode()).digest())


class Build:
    """What ninja built, and how: commands of the objects, and what each program is linked from."""

    def __init__(self, root, folder):
        self.root, self.folder, self.included = root, folder, {}
        self.commands = {}
        for entry in json.loads((folder / 'compile_commands.json').read_text()):
            words = shlex.split(entry['command'])
            self.commands[words[words.index('-o') + 1]] = (Path(entry['file']), words)
        self.links = {name: self.link_words(name) for name in ('daylight', *TEST_SUITES)}

    def link_words(self, program):
        shown = subprocess.run(['ninja', '-C', self.folder, '-t', 'commands', '-s', program], check=True,
                               stdout=subprocess.PIPE, encoding='utf-8').stdout.splitlines()[-1]
        words = shlex.split(shown.partition(' && ')[2].partition(' && ')[0])
        if '-o' not in words or words[words.index('-o') + 1] != program:
            sys.exit(f'{self.folder}: no command that links {program}: {shown[:200]}')
        return words

    def includes(self, path):
        """The project's files that a source includes, however deep, itself among them."""
        if path not in self.included:
            self.included[path] = {path}
            for name in re.findall(r'^\s*#\s*include\s*"([^"]+)"', path.read_text(encoding='utf-8'), re.MULTILINE):
                inner = self.root / name
                if inner.exists():
                    self.included[path] |= self.includes(inner)
        return self.included[path]

    def objects_of(self, program):
        names = {word for word in self.links[program] if word.endswith('.o')}
        for word in self.links[program]:
            if re.fullmatch(r'libdaylight_\w+\.a', word):
                home = f'CMakeFiles/{word[3:-2]}.dir/'
                names |= {name for name in self.commands if name.startswith(home)}
        return names

    def affected(self, program, path):
        return sorted(name for name in self.objects_of(program) if path in self.includes(self.commands[name][0]))

    def compile(self, scratch, name, path):
        """Compiles one object from the tree with the mutated file laid over it. Returns the compiler's complaint."""
        source, words = self.commands[name]
        out = scratch / 'objects' / name
        out.parent.mkdir(parents=True, exist_ok=True)
        words = [*words[:1], f'-I{scratch}/over', f'-ffile-prefix-map={scratch}/over/=', '-w', *words[1:]]
        words[words.index('-o') + 1] = str(out)
        if source == path:
            words[-1] = str(scratch / 'over' / path.relative_to(self.root))
        done = subprocess.run(words, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding='utf-8')
        return done.stderr if done.returncode else ''

    def link(self, scratch, program, names):
        words = list(self.links[program])
        out = scratch / program
        words[words.index('-o') + 1] = str(out)
        words = [str(scratch / 'objects' / w) if w in names else w for w in words]
        first = words.index(str(out)) + 1
        words[first:first] = [str(scratch / 'objects' / n) for n in names if n not in self.links[program]]
        subprocess.run(words, cwd=self.folder, check=True)
        return out

    def same_code(self, scratch, names):
        """Whether the sections that the linker keeps are those of the unmutated objects."""
        def kept(path):
            plain = scratch / 'plain.o'
            subprocess.run(['objcopy', '--strip-debug', '--strip-unneeded', '-R', '.comment', path, plain], check=True)
            return plain.read_bytes()
        return all(kept(scratch / 'objects' / name) == kept(self.folder / name) for name in names)


def ask(words, root):
    """Returns the exit status, None at a cap, and the output."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (CPU_CAP, CPU_CAP))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    environment = {**os.environ, 'RC_PARAMS': 'seed=20261121 max_success=500', 'DAYLIGHT_LAW_PAIRS': '200',
                   'DAYLIGHT_DISTANCE_PAIRS': '300'}
    with tempfile.TemporaryFile('w+', encoding='utf-8', errors='replace') as out:
        try:
            status = subprocess.run(words, cwd=root, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
                                    timeout=WALL_CAP, preexec_fn=limit, env=environment).returncode
        except subprocess.TimeoutExpired:
            status = None
        out.seek(0)
        return status, out.read()


def reason(output):
    """The line that says best what was noticed."""
    lines = [' '.join(line.split()) for line in output.splitlines() if line.strip()]
    for mark in (r'^1\. |FAILED |error:', r'abstain|not asked|No verdict|truth', r'.'):
        for line in lines:
            if re.search(mark, line):
                return line[:300]
    return ''


def questions(build, scratch, path, names, gate_only):
    """What notices: (name, words of a program to run), in the order in which they are asked."""
    daylight = build.link(scratch, 'daylight', names)
    yield 'gate', [daylight, 'gate', '--first-failure']
    if gate_only:
        return
    yield 'answers', [sys.executable, __file__, 'answers', build.folder / 'daylight', daylight]
    for suite, wanted in TEST_SUITES.items():
        more = build.affected(suite, path)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            if any(pool.map(lambda name: build.compile(scratch, name, path), [n for n in more if n not in names])):
                yield suite, ['false']
        yield suite, [build.link(scratch, suite, more), f'--gtest_filter={wanted}', '--gtest_brief=1']


def check_answers(arguments):
    plain, program = arguments.plain, arguments.program
    pairs = [path.read_text(encoding='utf-8') for path in sorted(ROOT.glob('corpus/cases/*.jsonl'))]

    def output_of(*words):
        return subprocess.run(words, stdout=subprocess.PIPE, encoding='utf-8').stdout
    for line in output_of(plain, 'families').splitlines():
        if re.match(r'\w', line):
            pairs.append(output_of(plain, 'families', line.split()[0], '--count', str(FAMILY_PAIRS), '--seed', str(FAMILY_SEED)))
    with tempfile.NamedTemporaryFile('w', suffix='.jsonl', encoding='utf-8') as file:
        file.write(''.join(pairs))
        file.flush()
        pairs = exact.read(file.name)
        right, answers = ([json.loads(line) for line in output_of(p, 'check', '--distance', file.name).splitlines()]
                          for p in (plain, program))
    if exact.check(pairs, answers):
        return 2
    for number, (a, b) in enumerate(zip(right, answers), 1):
        apart = 'distance' in a and 'distance' in b and any(
            exact.exact(x['distance'][0]) > exact.exact(y['distance'][1]) for x, y in ((a, b), (b, a)))
        if a['verdict'] != b['verdict'] or apart or ('distance' in a) != ('distance' in b):
            print(f'answer {number} FAILED: {b} for {a} to {pairs[number - 1]}')
            return 2
    return 0


def attempt(build, mutation, scratch, gate_only):
    """Returns the fate, what noticed, and why it did."""
    path = build.root / mutation.path
    over = scratch / 'over' / mutation.path
    over.parent.mkdir(parents=True)
    over.write_text(mutated(mutation, path.read_text(encoding='utf-8')), encoding='utf-8')
    names = build.affected('daylight', path)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        complaints = list(filter(None, pool.map(lambda name: build.compile(scratch, name, path), names)))
    if complaints:
        return 'no code', '', reason(complaints[0].replace(f'{scratch}/over/', ''))
    if build.same_code(scratch, names):
        return 'same code', '', ''
    unresolved = ''
    for name, words in questions(build, scratch, path, names, gate_only):
        status, output = ask(words, build.root)
        if status is None:
            unresolved = f'{name} came to no end'
        elif status != 0:
            return 'noticed', name, f'exit status {status}: {reason(output)}'
    return ('unresolved' if unresolved else 'survived'), '', unresolved


def control(build, path, gate_only):
    """Nothing may notice the program as it is; and its objects must come out as they are in the build."""
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        (scratch / 'over' / path).parent.mkdir(parents=True)
        shutil.copy(build.root / path, scratch / 'over' / path)
        names = build.affected('daylight', build.root / path)
        for name in names:
            if complaint := build.compile(scratch, name, build.root / path):
                sys.exit(f'{name} does not compile as it is:\n{complaint}')
        if not build.same_code(scratch, names):
            sys.exit(f'{build.folder}: {path} compiles to something else than is there; build first, and change nothing')
        for name, words in questions(build, scratch, build.root / path, names, gate_only):
            start = time.monotonic()
            status, output = ask(words, build.root)
            print(f'without a fault, {name}: {time.monotonic() - start:.1f} s', flush=True)
            if status != 0:
                sys.exit(f'{name} notices a fault where there is none:\n{output[-2000:]}')


def read_lines(path):
    return [json.loads(line) for line in path.read_text(encoding='utf-8').splitlines()] if path.exists() else []


def run(arguments):
    build = Build(ROOT, arguments.build.resolve())
    done = {row['id'] for row in read_lines(arguments.out)}
    counted = sum(row['fate'] not in ('no code', 'same code') for row in read_lines(arguments.out))
    chosen = drawn(ROOT, arguments.seed)
    print(f'seed {arguments.seed}, {len(chosen)} changes, {counted} mutants of {arguments.count} asked before', flush=True)
    if arguments.only:
        chosen, done, counted = [m for m in chosen if m.id in arguments.only], set(), 0
    if not arguments.no_control:
        control(build, 'solver/distance.cpp', arguments.gate_only)
    for mutation in chosen:
        if counted == arguments.count:
            break
        if mutation.id in done:
            continue
        start = time.monotonic()
        with tempfile.TemporaryDirectory() as scratch:
            fate, by, why = attempt(build, mutation, Path(scratch), arguments.gate_only)
        text = (ROOT / mutation.path).read_text(encoding='utf-8')
        was, now = (' '.join(t.split('\n')[mutation.line - 1].split()) for t in (text, mutated(mutation, text)))
        row = {'id': mutation.id, 'line': mutation.line, 'was': was, 'now': now, 'fate': fate, 'by': by, 'why': why,
               'seconds': round(time.monotonic() - start, 1), 'seed': arguments.seed}
        counted += fate not in ('no code', 'same code')
        with open(arguments.out, 'a', encoding='utf-8') as out:
            out.write(json.dumps(row) + '\n')
        print(f'{counted:4} {fate} {by:16} {row["seconds"]:6} s  {mutation.id}\n       {was}\n       {now}\n       {why}', flush=True)
    return report(arguments)


def report(arguments):
    rows = read_lines(arguments.out)
    argued = {row['id']: row['because'] for row in read_lines(ARGUMENTS)}
    asked = [row for row in rows if row['fate'] not in ('no code', 'same code')]
    ways = {}
    for row in rows:
        ways[row['by'] or row['fate']] = ways.get(row['by'] or row['fate'], 0) + 1
    for way, count in sorted(ways.items(), key=lambda item: -item[1]):
        print(f'{count:5} {way}')
    closed = sum('gate' in row['by'] for row in asked)
    past = [row for row in asked if 'gate' not in row['by']]
    equivalent = [row for row in past if row['fate'] == 'survived' and row['id'] in argued]
    counted = len(asked) - len(equivalent)
    print(f'{len(asked)} mutants, {len(equivalent)} of them argued equivalent; '
          f'{closed} of the other {counted} close the gate ({100 * closed / max(1, counted):.1f} %)')
    for row in past:
        print(f'{row["id"]} ({row["by"] or row["fate"]})\n    {row["was"]}\n    {row["now"]}')
        if row['id'] in argued:
            print(f'    equivalent: {argued[row["id"]]}')
    wrong = [row['id'] for row in asked if row['fate'] == 'noticed' and row['id'] in argued]
    if wrong:
        print('argued equivalent, and noticed:', *wrong)
    return 2 if wrong or len(past) > len(equivalent) else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parts = parser.add_subparsers(required=True)
    for name, command in (('run', run), ('report', report)):
        part = parts.add_parser(name)
        part.set_defaults(command=command)
        part.add_argument('--out', type=Path, default=RESULTS)
        if name == 'run':
            part.add_argument('--seed', type=int, required=True)
            part.add_argument('--count', type=int, required=True, help='mutants in all, those in FILE among them')
            part.add_argument('--only', action='append', help='this one alone, whether it was asked before or not')
            part.add_argument('--build', type=Path, default=ROOT / 'build/release')
            part.add_argument('--gate-only', action='store_true', help='leave out answers and tests')
            part.add_argument('--no-control', action='store_true', help='take it that the program as it is passes')
    part = parts.add_parser('answers')
    part.add_argument('plain', type=Path)
    part.add_argument('program', type=Path)
    part.set_defaults(command=check_answers)
    part = parts.add_parser('list')
    part.add_argument('text', nargs='?', default='')
    part.set_defaults(command=lambda a: print(*(m.id for m in population(ROOT) if a.text in m.id), sep='\n'))
    arguments = parser.parse_args()
    sys.exit(arguments.command(arguments))


main()
