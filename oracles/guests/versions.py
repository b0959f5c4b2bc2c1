#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The work of `daylight versions`: asks the versions of a method about the same pairs, and reports when each fault came
and went. cli/versions.cpp has the options.

npm installs each version into a cache folder, with its guest beside it. A result is kept under its pairs, its guest and
its version, as soon as it is there. So a run that was killed continues, and a later run asks only new versions."""
import argparse
import hashlib
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
from collections import Counter

sys.dont_write_bytecode = True
from compare import (CYLINDERS, ENGINES, HERE, SHAPES, compared, draw, judge, kinds_of, lines_of,  # noqa: E402
                     ordinary, package_of, proved, table, to_text)

CACHE = pathlib.Path(os.environ.get('XDG_CACHE_HOME') or pathlib.Path.home() / '.cache') / 'daylight'
LOCAL = 'plug-ins and commands'
FINDINGS, NOT_ASKED, WRONG_USAGE, BAD_INPUT = 2, 3, 64, 65


class Failure(Exception):
    """What the user reads, and the exit code."""
    def __init__(self, text, code=1):
        super().__init__(text)
        self.code = code


def digest(*parts):
    return hashlib.sha256('\0'.join(parts).encode()).hexdigest()[:16]


def number(version):
    return tuple(int(part) for part in version.split('.')) if re.fullmatch(r'\d+(\.\d+)*', version) else ()


# The pairs.

def is_ordinary(pair):
    return ordinary(pair) and math.dist(pair['a']['center'], pair['b']['center']) <= 100


def all_pairs(daylight, count):
    """The public cases, then about `count` drawn ones: two of three are cylinders."""
    cases = [json.loads(line) for file in sorted((HERE.parents[1] / 'corpus/cases').glob('*.jsonl'))
             for line in file.read_text().splitlines()]
    cylinders = count * 2 // 3
    return cases + draw(daylight, CYLINDERS, cylinders) + draw(daylight, SHAPES, count - cylinders)


def truths_of(daylight, pairs):
    """An end beyond the doubles is written as a string."""
    return [dict(truth, distance=[float(x) for x in truth['distance']]) for truth in proved(daylight, pairs)]


# The versions of npm.

def npm_view(package):
    """What the registry says of a package, or None if npm cannot reach it."""
    asked = subprocess.run(['npm', 'view', package, 'time', 'dist-tags', '--json', '--fetch-retries=1',
                            '--fetch-retry-mintimeout=1000'], capture_output=True, text=True,
                           cwd=HERE, check=False)
    said = json.loads(asked.stdout or '{}')
    error = said.get('error', {}) if asked.returncode else {}
    if error.get('code') in ('E404', 'EINVALIDPACKAGENAME'):
        raise Failure(f'npm knows no package {package}: check the name', WRONG_USAGE)
    return None if asked.returncode else said


def dates_of(times):
    """The release dates. A mirror may state when it fetched a version; then it lacks the date of the package."""
    return {version: time[:10] for version, time in times.items()} if 'created' in times else {}


def in_range(versions, package, tags, first, last):
    """Releases from `first` to `last`, both included: 0.19 as the last includes 0.19.3."""
    low, high = (number(tags.get(bound, bound)) for bound in (first, last))
    for bound, is_number in ((first, low), (last, high)):
        if bound and not is_number:
            raise Failure(f"'{bound}' is not a version such as 0.11, nor a tag of {package}", WRONG_USAGE)
    every = sorted(filter(number, versions), key=number)
    found = [v for v in every if number(v) >= low and number(v)[:len(high)] <= high]
    if not found:
        there = f'{every[0]} to {every[-1]}' if every else 'no releases'
        raise Failure(f'{package} has no version from {first or "its first"} to {last}: it has {there}', WRONG_USAGE)
    return found


def installed(guest, package, version):
    """The folder with a copy of the guest and that version of its package; None if npm cannot install it."""
    folder = CACHE / 'guests' / f'{package.replace("/", "+")}@{version}'
    fresh = folder if (folder / 'node_modules' / package).is_dir() else folder.with_name(folder.name + '.new')
    fresh.mkdir(parents=True, exist_ok=True)
    for name in ('lines.mjs', f'{guest}.mjs', '.npmrc'):
        shutil.copy(HERE / name, fresh / name)
    if fresh != folder:
        (fresh / 'package.json').write_text(json.dumps({'private': True, 'type': 'module',
                                                        'dependencies': {package: version}}))
        done = subprocess.run(['npm', 'install', '--no-package-lock'], cwd=fresh, capture_output=True, check=False)
        if done.returncode:
            shutil.rmtree(fresh)
            return None
        fresh.rename(folder)
    return folder


class Npm:
    """The versions of an npm package: their names, dates and answers."""
    def __init__(self, package, first, last, rows):
        self.package = package
        packages = {package_of(engine).split()[0]: engine for engine in ENGINES}
        if package not in packages:
            raise Failure(f'oracles/guests has no guest for {package}. It has guests for {", ".join(packages)}.\n'
                          'For other packages, name a program for each version with --command', WRONG_USAGE)
        for program in ('node', 'npm'):
            if not shutil.which(program):
                raise Failure(f'{program} is not here: apt-get install {"nodejs" if program == "node" else "npm"}')
        self.guest = packages[package]
        said = npm_view(package)
        self.dates = dates_of(said['time']) if said else {}
        kept = [row['version'] for row in rows if row['package'] == package]
        if not said and not kept:
            raise Failure(f'npm cannot reach its registry to list the versions of {package}: try again with a network')
        if not said:
            print('daylight: npm cannot reach its registry: only the kept versions are reported', file=sys.stderr)
        known, tags = (said['time'], said['dist-tags']) if said else (kept, {'latest': max(kept, key=number)})
        self.versions = in_range(known, package, tags, first, last)

    def key(self, _):
        return digest(*((HERE / name).read_text() for name in (f'{self.guest}.mjs', 'lines.mjs')))

    def judged(self, daylight, version, pairs, truths):
        folder = installed(self.guest, self.package, version)
        if not folder:
            raise RuntimeError('npm cannot install it')
        return compared(daylight, ['node', f'{self.guest}.mjs'], pairs, truths, folder)[1]


class Local:
    """Plug-ins and commands in the given order; daylight itself asks them."""
    def __init__(self, plugins, commands):
        self.package, self.dates = LOCAL, {}
        self.options = {text: [option, text] for option, texts in (('--plugin', plugins), ('--command', commands))
                        for text in texts}
        self.versions = list(self.options)

    def key(self, version):
        words = [version, version.partition('=')[2], *re.split(r'[\s=\'"]+', version)]
        return digest(version, *(pathlib.Path(w).read_bytes().hex() for w in words if pathlib.Path(w).is_file()))

    def judged(self, daylight, version, pairs, truths):
        listing = lambda *more: subprocess.run([daylight, 'campaign', '--list', *more], capture_output=True, text=True,
                                               check=False)
        asked, without = listing(*self.options[version]), listing().stdout.splitlines()
        if asked.returncode:
            raise Failure(asked.stderr.strip().removeprefix('daylight: '), asked.returncode)
        new = [line for line in asked.stdout.splitlines() if line not in without]
        if len(new) != 1:
            raise Failure(f"'{version}' has {len(new)} methods: name one as NAME:METHOD=FILE", WRONG_USAGE)
        method, relative, absolute = re.match(r' *(\S+) .* above a margin of (\S+) size \+ (\S+) ', new[0]).groups()
        hello = {'claim': {'relative': float(relative), 'absolute': float(absolute)}}
        said = subprocess.run([daylight, 'check', '--method', method, *self.options[version], '-'], check=False,
                              input=to_text(pairs), capture_output=True, text=True)
        if said.returncode not in (0, NOT_ASKED):
            raise Failure(said.stderr.strip().removeprefix('daylight: '))
        return judge(hello, pairs, truths, truths, [answer_of(json.loads(line)) for line in said.stdout.splitlines()])


def answer_of(reply):
    """A reply of `check --method` as a guest's answer. Its distance is not judged here: the campaign does that."""
    if 'error' in reply:
        return {'declined' if ' declined: ' in reply['error'] else 'error': reply['error']}
    words = {'disjoint': 'disjoint', 'touching': 'intersecting', 'intersecting': 'intersecting'}
    return {'verdict': words[reply['verdict']]} if reply['verdict'] in words else {'declined': reply['verdict']}


# The data: a row for each version.

def read(file):
    try:
        return [json.loads(line) for line in file.read_text().splitlines()] if file.exists() else []
    except ValueError as error:
        raise Failure(f'{file} is not a file of results ({error}): name another with --data', BAD_INPUT) from error


def write(file, rows):
    file.parent.mkdir(parents=True, exist_ok=True)
    fresh = file.with_name(file.name + '.new')
    fresh.write_text(''.join(json.dumps(row) + '\n' for row in rows))
    fresh.rename(file)


def summary(judged):
    judged = list(judged)
    wrong = Counter(f'{kinds_of(pair)}: {found[0]}{"" if is_ordinary(pair) else ", extreme"}'
                    for pair, *_, found in judged if found)
    said = ''.join(answer.get('verdict', 'none')[0] for *_, answer, _ in judged)
    return {'answered': len(judged), 'wrong': dict(sorted(wrong.items())), 'verdicts': digest(said)}


def run(daylight, source, rows, file, count):
    """The rows of the source's versions, in order. Each is written as soon as it is there."""
    pairs = all_pairs(daylight, count)
    asked_about = digest(to_text(pairs))
    truths, mine = None, []
    for version in source.versions:
        wanted = {'package': source.package, 'version': version, 'pairs': asked_about, 'guest': source.key(version)}
        row = next((r for r in rows if wanted.items() <= r.items() and 'not_asked' not in r), None)
        if not row:
            truths = truths or truths_of(daylight, pairs)
            print(f'daylight: {source.package} {version} ...', file=sys.stderr)
            try:
                row = {**wanted, 'drawn': count, **summary(source.judged(daylight, version, pairs, truths))}
            except RuntimeError:  # it does not start
                row = {**wanted, 'drawn': count, 'not_asked': True}
        if date := source.dates.get(version):
            row['date'] = date
        mine.append(row)
        others = [r for r in read(file) if (r['package'], r['version']) != (source.package, version)]
        write(file, others + [row])
    return mine


# The report.

def turns(rows, kind):
    """Last good before the first bad, first bad, first good after it: of versions in order; '-' for what there is
    not."""
    bad = [kind in row['wrong'] for row in rows]
    first = bad.index(True)
    after = next((i for i in range(first, len(bad)) if not bad[i]), None)
    name = lambda i: '-' if i is None else rows[i]['version'] + (f' ({rows[i]["date"]})' if 'date' in rows[i] else '')
    return name(first - 1 if first else None), name(first), name(after)


def groups(rows):
    """Versions in a row whose verdicts are the same."""
    parts = []
    for row in rows:
        if not parts or any(parts[-1][0][k] != row[k] for k in ('verdicts', 'wrong')):
            parts.append([])
        parts[-1].append(row)
    return parts


def counted(rows, kind):
    """27, or 3 to 27 if the versions that have the fault differ."""
    counts = {row['wrong'][kind] for row in rows if kind in row['wrong']}
    return ' to '.join(map(str, sorted({min(counts), max(counts)})))


def plural(count, what):
    return f'{count} {what}{"" if count == 1 else "s"}'


def section(package, every):
    mine = [row for row in every if 'not_asked' not in row]
    mute = ', '.join(row['version'] for row in every if 'not_asked' in row)
    text = f'## {package}\n\n'
    if mute:
        text += f'Not asked, because npm cannot install the package or its guest does not start: {mute}.\n\n'
    if not mine:
        return text
    kinds = sorted({kind for row in mine for kind in row['wrong']})
    changed = sum(any(kind not in row['wrong'] for row in mine) for kind in kinds)
    same = groups(mine)
    text += f'{plural(len(mine), "version")} answered {plural(mine[0]["answered"], "pair")} each. '
    text += f'They have {plural(len(kinds), "fault")}. {changed or "None"} of these came or went. ' if kinds else (
        'None has a fault. ')
    text += (f'The verdicts changed in {plural(len(same) - 1, "version")}.\n\n' if len(same) > 1 else
             'Nothing changed: all have the same verdicts.\n\n')
    if kinds:
        text += table(['fault', 'last good', 'first bad', 'first good again', 'pairs'],
                      [[kind, *turns(mine, kind), counted(mine, kind)] for kind in kinds]) + '\n'
    return text + table(['versions with the same verdicts', 'first', 'last', 'wrong pairs'],
                        [[len(part), part[0]['version'], part[-1]['version'], sum(part[0]['wrong'].values())]
                         for part in same])


HEAD = """# Versions of engines

For readers who ask since when an engine has a fault. `daylight versions` asked each version about the same pairs: the
public cases, and drawn pairs of ordinary size (0.1 to 10 m). It wrote this page from [its data]({data}).
The claims are those of the guests. A fault is a shape pair with a wrong verdict beyond the claim, a crash, a hang or an
error. Faults in cases of other sizes have the word *extreme*. Dates are those of the release. They are missing if the
registry does not state them, for example because it is a mirror.

"""


def page(rows, data):
    sections = []
    text = HEAD.format(data=data)
    for package in dict.fromkeys(row['package'] for row in rows):
        mine = [row for row in rows if row['package'] == package]
        last = mine[-1]  # rows of other pairs, or of another guest, cannot be compared with it
        mine = sorted((row for row in mine if row['pairs'] == last['pairs'] and
                       (package == LOCAL or row['guest'] == last['guest'])), key=lambda row: number(row['version']))
        if package != LOCAL:
            text += (f'    daylight versions --npm {package} --from {mine[0]["version"]} --to {mine[-1]["version"]} '
                     f'--pairs {last["drawn"]}\n')
        sections.append('\n' + section(package, mine))
    return text + ''.join(sections)


def main():
    parser = argparse.ArgumentParser()
    for name in ('npm', 'from', 'data', 'page'):
        parser.add_argument('--' + name, default='')
    parser.add_argument('--daylight')
    parser.add_argument('--to', default='latest')
    parser.add_argument('--pairs', type=int)
    for name in ('plugin', 'command'):
        parser.add_argument('--' + name, action='append', default=[])
    options = parser.parse_args()
    file = pathlib.Path(options.data or CACHE / 'versions.jsonl')
    rows = read(file)
    source = (Npm(options.npm, getattr(options, 'from'), options.to, rows) if options.npm else
              Local(options.plugin, options.command))
    mine = run(options.daylight, source, rows, file, options.pairs)
    print(section(source.package, mine), end='')
    if options.page:
        data = os.path.relpath(file, pathlib.Path(options.page).parent)
        pathlib.Path(options.page).write_text(page(read(file), data))
    return (FINDINGS if any(row.get('wrong') for row in mine) else
            NOT_ASKED if any('not_asked' in row for row in mine) else 0)


if __name__ == '__main__':
    try:
        sys.exit(main())
    except Failure as failure:
        print(f'daylight: {failure}', file=sys.stderr)
        sys.exit(failure.code)
    except OSError as error:
        sys.exit(f'daylight: {error}')
    except KeyboardInterrupt:
        sys.exit('daylight: stopped; the same command continues')
