#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""README.md, CONTRIBUTING.md and docs/*.md: links have targets, pages are short and narrow, and the English is plain.
So is the English of comments, docstrings, the page's strings and the descriptions of JSON schemas.
Runs every command line of the program given as the first argument, with less time and fewer pairs. ELSEWHERE names the
command lines that other tests run. The files for CI name commands and options that exist. README.md's first pair stays
wrong when it is moved, and its numbers match the output of its command. "docs_test.py PROGRAM write" writes these
numbers."""
import functools
import json
import math
import os
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / 'tools'))
import plain_english  # noqa: E402
PROGRAM = pathlib.Path(sys.argv[1]).resolve()
TOP = [ROOT / name for name in ('README.md', 'CONTRIBUTING.md', 'CHANGELOG.md', 'SECURITY.md')]
PAGES = TOP + sorted((ROOT / 'docs').glob('*.md')) + sorted((ROOT / 'docs/guides').glob('*.md'))
PROSE = PAGES + [
    ROOT / name for name in ('corpus/cases/README.md', 'reports/schemas/README.md', 'solver/derivation.md',
                             'solver/distance.md', 'solver/rounded.md', 'solver/boxes.md')]

README_LINES, PAGE_LINES, COLUMNS = 130, 110, 120
LONGER = {'CHANGELOG.md': 'grows',
          'CONTRIBUTING.md': 'a table of where to add what',
          'vectors.md': 'the fields of two versions, and all flags',
          'library.md': 'a guide with a whole plug-in in it', 'library-use.md': 'three examples in full'}

# Command lines that other tests run, by what is in them.
ELSEWHERE = {
    'daylight test': 'the test command itself',
    'daylight fuzz': 'fuzz_test',
    'oracles/guests/': 'engines_test',
    'bench --curves': 'chart_test',
    'bench --shapes': 'bench_test',
    '--bench bench.json': 'chart_test',
    '--shard': 'campaign_replay_test',
    'merge runs/night': 'campaign_replay_test',
    '--pairs 1000000000': 'docs/results.md',
    '--pairs 25000 ': 'docs/engines.md',
    'runs/readme/run': 'compared, see check_numbers',
    'daylight COMMAND': 'no command but a pattern',
    'campaign --for': 'campaign_replay_test, which has a number of pairs instead',
}

ALIEN = ['--quick', '--target', '--branches', '--daylight-tolerance', '--daylight-tier', '--daylight-limit',
         '--failed-first']  # of other programs


def fail(what):
    sys.exit(f'FAILED: {what}')


def check_links(page, text):
    anchors = {re.sub(r'[^a-z0-9 -]', '', head.lower()).strip().replace(' ', '-')
               for head in re.findall(r'^#+ (.*)$', text, re.M)}
    for target in re.findall(r'\]\(([^)\s]+)\)', text):
        if re.match(r'[a-z]+:', target):
            continue
        path, _, anchor = target.partition('#')
        if path and not (page.parent / path).exists():
            fail(f'{page.name} links to {target}, which is not there')
        if not path and anchor not in anchors:
            fail(f'{page.name} links to #{anchor}, which is no head of it')


def check_size(page, text):
    count = text.count('\n')
    if page.name == 'README.md' and page.parent == ROOT and count > README_LINES:
        fail(f'README.md has {count} lines')
    if page.name != 'README.md' and page.name not in LONGER and count > PAGE_LINES:
        fail(f'{page.name} has {count} lines')
    fenced = False
    for number, line in enumerate(text.splitlines(), 1):
        fenced ^= line.startswith('```')
        is_prose = not fenced and not line.startswith(('    ', '|', '```'))
        if len(line) > COLUMNS and (is_prose or page == ROOT / 'README.md'):
            fail(f'{page.name}:{number} is {len(line)} columns wide')


@functools.cache
def sources():
    """The files of the source tree with comments that plain_english.py reads, each with its text."""
    texts = {}
    for folder, names, files in os.walk(ROOT):
        names[:] = sorted(set(names) - {'build', 'node_modules', '.git'})
        paths = [pathlib.Path(folder) / name for name in sorted(files)]
        texts |= {path: path.read_text() for path in paths if path.suffix in plain_english.SPLITS}
    return texts


def check_names():
    """The files that CONTRIBUTING.md and data-flow.md name exist, and so do the functions and types of data-flow.md."""
    files = {source.name for source in sources()}
    words = set(re.findall(r'\w+', ' '.join(sources().values())))
    for page in (ROOT / 'CONTRIBUTING.md', ROOT / 'docs/data-flow.md'):
        text = page.read_text()
        named = set(re.findall(r'(?<![*\w])(\w+\.(?:cpp|hpp|tsx?|py))\b', text)) - files
        if page.name == 'data-flow.md':
            named |= {name for name in re.findall(r'`(?:\w+::)?(\w+)`', text) if name not in words}
        for name in sorted(name for name in named if not re.match(r'(?:\w+_)?(?:x|COMMAND)[._]', name)):
            fail(f'{page.name} names {name}, which does not exist')


def descriptions():
    """Yields (schema, description) of the JSON schemas."""
    for schema in sorted((ROOT / 'reports/schemas').glob('*.json')) + [ROOT / 'vectors/v1/schema.json']:
        for text in re.findall(r'"description": ("(?:[^"\\]|\\.)*")', schema.read_text()):
            yield schema, json.loads(text)


def check_english():
    """The documents, sources and descriptions of schemas have no finding of plain_english.py, and neither has --help of
    any command."""
    for habit, pattern, _, example in plain_english.PHRASES:
        if not re.search(pattern, example):
            fail(f'the pattern of "{habit}" misses its example: {example}')
    found = [f'{page.relative_to(ROOT)}:{number}: {message}'
             for page in PROSE for number, _, message in plain_english.findings(page.read_text())]
    if len(sources()) < 500 or set(plain_english.SPLITS) - {file.suffix for file in sources()}:
        fail(f'only {len(sources())} sources, or none of a language, were found')
    found += [f'{source.relative_to(ROOT)}:{number}: {message}' for source, text in sources().items()
              for number, _, message in plain_english.findings(text, plain_english.SPLITS[source.suffix])]
    described = list(descriptions())
    if len(described) < 50:
        fail(f'only {len(described)} descriptions were found in schemas')
    found += [f'{schema.relative_to(ROOT)}: {message}' for schema, text in described
              for _, _, message in plain_english.findings(text)]
    if found:
        fail('\n'.join(['the English of these lines'] + found))
    text = run(['--help'], ROOT)
    commands = re.findall(r'^  ([a-z]+) {2,}', text, re.M)
    if len(commands) < 15:
        fail(f'--help lists only {len(commands)} commands')
    helps = {'': text} | {command: run([command, '--help'], ROOT) for command in commands}
    found = [f'{command} --help: {message}' for command, text in helps.items() for _, message in
             plain_english.phrases(' '.join(text.split()))]
    for command, text in helps.items():
        examples = text.partition('\nExamples:\n')[2].partition('\n\n')[0]
        if command and len(re.findall(r'^  (?!-).*\bdaylight [a-z]', examples, re.M)) < 2:
            found.append(f'{command} --help: two examples at least')
        for option, about in re.findall(r'^  (--\S+.*?)(?: {2,}|\n {10,})(\S.*?)(?: \(default: .*\))?$', text, re.M):
            if len(about) > 100 or 'TEXT' in option:
                found.append(f'{command} {option}: at most 100 characters, and a name for the value')
    if found:
        fail('\n'.join(['these phrases in --help'] + found))
    known = ' '.join([*helps.values(), *ALIEN])
    for page in PAGES:
        for option in re.findall(r'`(--[a-z][a-z-]+)', page.read_text()):
            if page.name != 'CHANGELOG.md' and not re.search(re.escape(option) + r'(?![a-z-])', known):
                fail(f'{page.name} mentions {option}, which no command has')


def check_ci():
    """The action, the workflows and the units name only commands and options that --help has."""
    for path in [ROOT / 'action.yml', *(ROOT / 'docs/ci').iterdir(), *(ROOT / '.github/workflows').iterdir()]:
        text = re.sub(r'^#.*|\\\n', '', path.read_text(), flags=re.M)
        lines = re.findall(r'\bdaylight ([a-z]+)\b(.*)', text)
        if path.name == 'action.yml':
            lines.append(('gate', text))
        for command, rest in lines:
            known = run([command, '--help'], ROOT)
            for option in re.findall(r'(?<=[ (])--[a-z-]+', rest):
                if not re.search(rf'^  {option}\b', known, re.M):
                    fail(f'{path.name}: {command} has no {option}')


def commands_of(text):
    """Command lines in code: blocks and what stands between backticks."""
    fenced, block = False, []
    for line in text.splitlines():
        if line.startswith('```'):
            fenced = not fenced
        elif fenced or line.startswith('    '):
            block.append(line)
    found = re.findall(r'^ *(?:\$ )?((?:\./)?daylight [^\n]*)', '\n'.join(block), re.M)
    prose = re.sub(r'^```.*?^```$', '', text, flags=re.M | re.S)
    found += [re.sub(r'\s+', ' ', command) for command in re.findall(r'`((?:\./)?daylight [a-z]+ [^`]*)`', prose)]
    return [re.split(r'\s{2,}#|\s+[|&<>]', command)[0].strip() for command in found]  # what the shell does is cut


def shortened(words, number):
    """The same with less to do; a run without a name gets one, for two of them may begin within a second."""
    least = {'--for': '1s', '--count': '300', '--pairs': '300', '--evaluations': '300', '--configurations': '10'}
    words = [least.get(before, word) if before in least else word for before, word in zip([''] + words, words)]
    patterns = {'KEY': 'fcl-libccd/overflow', 'CASE': 'one.jsonl', 'FOLDER': 'sent', 'METHOD': 'ode',
                'libccd-mpr/wrong_disjoint': 'fcl-libccd/overflow'}
    words = [patterns.get(word, word) for word in words]
    if words[0] == 'gate':
        words += ['--cases', '', '--for', '1s']
    if words[0] == 'triage' and '--for' not in words:
        words += ['--for', '1s']
    if words[0] == 'scene' and '--configurations' not in words:
        words += ['--configurations', '10']
    if words[0] == 'campaign' and not {'--out', '--resume', '--list'} & set(words):
        words += ['--out', f'runs/{number}']
    if words[0] == 'campaign' and not {'--methods', '--list'} & set(words):
        words += ['--methods', 'decide,ode,libccd']
    if words[0] == 'worst' and '--for' not in words and '--evaluations' not in words:
        words += ['--evaluations', '300']
    if words[0] == 'bench':
        words += ['--pairs', '50', '--min-time', '0', '--passes', '1']
    return words


def prepare(folder):
    """Makes the files that the command lines name."""
    solid = '{"center":[%s,0,0],"axis":[0,%s,1],"radius":1,"height":2}'
    pair = '{"a":' + solid % ('0', '0') + ',"b":' + solid % ('%s', '1') + '}\n'
    (folder / 'pairs.jsonl').write_text(pair % '2.5' + pair % '1')
    (folder / 'known.jsonl').write_text('')
    (folder / 'one.jsonl').write_text(
        (ROOT / 'corpus/cases/hand_made.jsonl').read_text().splitlines()[75] + '\n')
    for name in ('corpus', 'docs'):
        (folder / name).symlink_to(ROOT / name)
    (folder / 'robot.urdf').write_text((ROOT / 'corpus/scenes/twenty.urdf').read_text())
    (folder / 'mine.py').write_text(
        "import sys\nfor line in sys.stdin: print('{\"verdict\":\"disjoint\"}', flush=True)\n")
    (folder / 'answers.jsonl').write_text('{"verdict":"disjoint"}\n' * 2)
    run(['campaign', '--pairs', '300', '--seed', '3', '--methods', 'fcl-libccd,ode', '--families', 'tiny_and_huge',
         '--cases', '', '--out', 'runs/latest'], folder)


def run(words, folder):
    done = subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, encoding='utf-8', timeout=1200,
                          env={**os.environ, 'DAYLIGHT_COMMAND': './daylight'})
    invalid = 65 if words[0] == 'check' else 0  # an example shows what is said of a line that is no pair
    if done.returncode not in (0, 2, 3, invalid):
        fail(f'{shlex.join(words)}: exit code {done.returncode}\n{done.stdout[-1500:]}{done.stderr[-1500:]}')
    return done.stdout


def moved(solid, angle, by):
    """The solid turned about the x axis, and then moved."""
    c, s = math.cos(angle), math.sin(angle)
    of = lambda v: [v[0], c * v[1] - s * v[2], s * v[1] + c * v[2]]
    center = [x + d for x, d in zip(of(solid['center']), by)]
    if solid['shape'] == 'box':
        return {**solid, 'center': center, 'quaternion': [math.cos(angle / 2), math.sin(angle / 2), 0, 0]}
    return {**solid, 'center': center, 'axis': of(solid['axis'])}


def check_first_pair(folder):
    """MuJoCo is wrong about README's first pair exchanged, turned, moved and changed by a millionth."""
    pair = json.loads((ROOT / 'docs/pictures/wrong.jsonl').read_text())
    draw, count = random.Random(1), 40
    changed = lambda x: ([changed(y) for y in x] if isinstance(x, list) else x if isinstance(x, str)
                         else x * (1 + draw.uniform(-1e-6, 1e-6)))
    with open(folder / 'first.jsonl', 'w') as out:
        for i in range(count):
            angle, by = draw.uniform(0, 2 * math.pi), [draw.uniform(-9, 9) for _ in range(3)]
            a, b = (moved({k: changed(v) for k, v in pair[s].items()}, angle, by) for s in 'ab')
            out.write(json.dumps({'a': b, 'b': a} if i % 2 else {'a': a, 'b': b}) + '\n')
    said = run(['replay', 'first.jsonl', '--methods', 'mujoco'], folder)
    if (wrong := len(re.findall(r'^  mujoco  .*wrong_disjoint \(beyond', said, re.M))) != count:
        fail(f'README.md shows a pair on which MuJoCo is wrong {wrong} times of {count} where it is moved')


def as_shown(text, block, counts):
    """README.md with this block of the summary, and the counts of each method in its table."""
    text = re.sub(r'(```text\n)pairs: \d+, .*?(```)', lambda m: m[1] + block + m[2], text, flags=re.S)
    text = re.sub(r'(?<=some of its )\d+', re.search(r'^methods: (\d+)$', block, re.M)[1], text)
    return re.sub(r'^(\| `([\w-]+)` \([^)]*\) \|).*$',
                  lambda m: ' '.join([m[1], *(f'{n} |' for n in counts[m[2]])]), text, flags=re.M)


def check_numbers(folder, write):
    """README.md shows what the command beside it prints, times excepted."""
    text = (ROOT / 'README.md').read_text()
    command = re.search(r'`\./daylight (campaign --pairs \d+ --seed 1 [^`]*)`', text)[1]
    said = run(command.split(), folder)
    block = said[re.search(r'^pairs: \d+, ', said, re.M).start():]
    block = ''.join(line + '\n' for line in block.split('\nCPU time')[0].splitlines())
    counts = {row[0]: row[1:7] for row in map(str.split, said.splitlines()) if len(row) == 8}
    shown = as_shown(text, block, counts)
    if write:
        (ROOT / 'README.md').write_text(shown)
    elif shown != text:
        fail(f'README.md does not show what its command prints; docs_test.py PROGRAM write mends it:\n{block}')


def main():
    check_names()
    check_english()
    check_ci()
    commands = set()
    for page in PAGES:
        text = page.read_text()
        check_links(page, text)
        check_size(page, text)
        if page.parent.name != 'guides':  # guides_test runs those
            commands |= set(commands_of(text))
    here = [c for c in commands if not any(part in c for part in ELSEWHERE)]
    # These need what another writes.
    here.sort(key=lambda command: ('--against' in command, command))
    if len(here) < 15:
        fail(f'only {len(here)} command lines were found')
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        check_numbers(folder, sys.argv[2:] == ['write'])
        if sys.argv[2:]:
            return
        check_first_pair(folder)
        prepare(folder)
        for number, command in enumerate(here):
            words = shlex.split(command, comments=True)[1:]
            if '|' in words or '..' in words or any('libmine.so' in w or '<' in w for w in words):
                words = [words[0], '--help']  # a plug-in has to be built first: guests_test
            run(shortened(words, number), folder)
            print(f'ran {command[:100]}')
    print('passed')


main()
