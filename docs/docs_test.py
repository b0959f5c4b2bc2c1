#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds README.md and docs/ to their word.

    docs_test.py DAYLIGHT [PAGE..]

Every link leads somewhere, every page is reached from README.md, no page is too long and no line too wide, every command
and option that is named exists. Blocks of commands (```sh) are run with small budgets, and end with the exit code that
the block states (```sh exit=2; 0 where it states none); blocks marked `list` are only recognised. In a ```console block
the lines after `$ ` are run as they are, and what follows has to be printed, in this order; `..` stands for anything.
The guides are run by guides_test.sh, whole.
"""
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
WIDTH = 120
LINES = {'README.md': 150, 'docs': 110, 'docs/guides': 130}  # results/ and other folders: as long as their tables
OTHER_PROGRAMS = {'apt-get', 'cat', 'cmake', 'cp', 'cpack', 'ninja', 'npm', 'python3', 'tail'}  # in blocks marked `list`
BLOCK_SECONDS = 600
failures = []

# Stands for the program in blocks of commands: whatever is asked, it takes seconds.
SMALL = r'''#!/usr/bin/env python3
import os, sys
program, arguments = os.environ['DAYLIGHT_PROGRAM'], sys.argv[1:]
command = arguments[0] if arguments else ''
most = {'--for': '5s', '--pairs': 300, '--count': 1000, '--configurations': 50, '--evaluations': 300}
for i, word in enumerate(arguments[:-1]):
    if word in most:
        arguments[i + 1] = str(most[word]) if word == '--for' else str(min(int(arguments[i + 1]), most[word]))
for option, commands in {'--for': ('triage', 'worst'), '--pairs': ('gate', 'bench')}.items():
    if command in commands and not {option, '--against', '--laws', '--annotate', '--export', '--explain'} & set(arguments):
        arguments += [option, str(most[option])]
if '--stop-at' in arguments:
    at = arguments.index('--stop-at')
    arguments[at:at + 2] = ['--for', '5s']
if command == 'bench' and '--methods' not in arguments:
    arguments += ['--methods', 'intersect,libccd']
if command == 'bench' and '--min-time' not in arguments and not {'--curves', '--growth'} & set(arguments):
    arguments += ['--min-time', '0.01', '--passes', '3']
os.execv(program, [program, *arguments])
'''


def fail(page, line, text):
    failures.append(f'{page.relative_to(ROOT)}:{line}: {text}')


class Page:
    """A page's blocks of code, and its prose with their lines blank."""

    def __init__(self, path):
        self.path = path
        self.lines = path.read_text(encoding='utf-8').split('\n')
        self.blocks = []  # (line, info, text)
        self.prose = []
        start, info, inside = 0, '', None
        for number, line in enumerate(self.lines, 1):
            fence = re.match(r'^\s*```(.*)$', line)
            if fence and inside is None:
                start, info, inside = number, fence[1].strip(), []
            elif fence:
                self.blocks.append((start, info, '\n'.join(inside)))
                inside = None
            elif inside is not None:
                inside.append(line)
                self.prose.append('')
                continue
            self.prose.append('' if fence else line)
        if inside is not None:
            fail(path, start, 'a block that does not end')


def anchors(page):
    found = set()
    for line in page.prose:
        if heading := re.match(r'^#+ (.*)$', line):
            words = re.sub(r'[^\w\- ]', '', heading[1].replace('`', '').lower())
            found.add(words.replace(' ', '-'))
    return found


def check_links(pages):
    reached = {ROOT / 'README.md'}
    for page in pages.values():
        for number, line in enumerate(page.prose, 1):
            text = '\n'.join([line, page.prose[number] if number < len(page.prose) else ''])
            for match in re.finditer(r'\]\(([^()\s]+)\)', text):
                if match.start() > len(line):
                    continue
                target = match[1]
                if re.match(r'^[a-z]+:', target):
                    continue
                name, _, anchor = target.partition('#')
                path = (page.path.parent / name).resolve() if name else page.path
                if not path.exists():
                    fail(page.path, number, f'{target} is not there')
                    continue
                reached.add(path)
                if anchor and path in pages and anchor not in anchors(pages[path]):
                    fail(page.path, number, f'{target}: there is no such heading')
    for path in pages:
        if path not in reached:
            fail(path, 1, 'no page links to it')


def check_sizes(pages):
    for page in pages.values():
        name = str(page.path.relative_to(ROOT))
        most = LINES.get(name, LINES.get(str(pathlib.Path(name).parent)))
        lines = len(page.lines) - 1
        if most and lines > most:
            fail(page.path, lines, f'{lines} lines; at most {most}')
        for number, line in enumerate(page.lines, 1):
            # A row of a table and a line of JSON cannot be wrapped; in README.md nothing is longer.
            if len(line) > WIDTH and (name == 'README.md' or not line.startswith(('|', '{"'))):
                fail(page.path, number, f'{len(line)} columns; at most {WIDTH}')


class Commands:
    """Which commands and options the program has."""

    def __init__(self, program):
        self.program = program
        top = self.help_of()
        self.names = set(re.findall(r'^  ([a-z]+) {2,}', top, re.M))
        self.options = {}

    def help_of(self, *command):
        done = subprocess.run([self.program, *command, '--help'], capture_output=True, text=True, check=False)
        return done.stdout + done.stderr

    def unknown(self, words):
        """What of a command line, whose first word is a command, does not exist."""
        command, rest = words[0], words[1:]
        if command not in self.names:
            return [f'no command {command}']
        if command == 'mutants':
            return []
        if command not in self.options:
            self.options[command] = set(re.findall(r'(?<![\w-])--?[a-z][a-z-]*', self.help_of(command)))
        asked = [w.split('=')[0] for w in rest if re.match(r'^--[a-z]', w)]
        return [f'{command} has no option {w}' for w in asked if w not in self.options[command]]


def words_of(line):
    """The commands of a line of shell, each as its words; comments end it."""
    try:
        lexer = shlex.shlex(line, posix=True, punctuation_chars='|&;<>()')
        lexer.whitespace_split = True
        words = list(lexer)
    except ValueError:
        return []
    commands, now = [], []
    for word in words:
        if re.fullmatch(r'[|&;<>()]+', word):
            commands.append(now)
            now = []
        else:
            now.append(word)
    return [c for c in [*commands, now] if c]


def check_names(page, commands):
    """Every `daylight X` or `X --option` in prose, in indented code and in blocks exists."""
    def check(number, words):
        if pathlib.Path(words[0]).name == 'daylight' and len(words) > 1 and re.match(r'^[a-z]', words[1]):
            for text in commands.unknown(words[1:]):
                fail(page.path, number, text)
        elif words[0] in commands.names and any(w.startswith('--') for w in words):
            for text in commands.unknown(words):
                fail(page.path, number, text)

    text = '\n'.join(page.prose)
    for span in re.finditer(r'`([^`]+)`', text):
        for words in words_of(span[1].replace('\n', ' ')):
            check(text.count('\n', 0, span.start()) + 1, words)
    for number, line in enumerate(page.prose, 1):
        if line.startswith('    '):
            for words in words_of(line.strip()):
                check(number, words)
    for start, info, block in page.blocks:
        if info.split()[:1] == ['sh'] and 'list' in info.split()[1:]:
            for number, line in enumerate(block.replace('\\\n', '  ').split('\n'), start + 1):
                for words in words_of(line):
                    check(number, words)
                    name = pathlib.Path(words[0]).name
                    if name not in OTHER_PROGRAMS and not (ROOT / words[0]).exists():
                        fail(page.path, number, f'{words[0]} is not in the tree')


def prepare(folder):
    """A folder that looks like the tree's, but for runs, builds and the program, which is told to be brief."""
    for entry in ROOT.iterdir():
        if entry.name not in ('daylight', 'runs', 'build', '.git', 'suppressions.jsonl'):
            (folder / entry.name).symlink_to(entry)
    (folder / 'daylight').write_text(SMALL)
    (folder / 'daylight').chmod(0o755)


def run(folder, script, program, small):
    environment = {**os.environ, 'DAYLIGHT_PROGRAM': str(program), 'DAYLIGHT_SOURCE': str(ROOT), 'CI': 'true'}
    if not small:
        (folder / 'daylight').unlink()
        (folder / 'daylight').symlink_to(program)
    try:
        return subprocess.run(
            ['bash', '-Ec', 'trap "code=\\$?; ((code == 2)) || exit \\$code" ERR\n' + script],
            cwd=folder, env=environment, capture_output=True, text=True, timeout=BLOCK_SECONDS, check=False)
    finally:
        if not small:
            (folder / 'daylight').unlink()
            (folder / 'daylight').write_text(SMALL)
            (folder / 'daylight').chmod(0o755)


def pattern(line):
    return re.compile('.*'.join(re.escape(part) for part in re.split(r'\.\.+', line.rstrip())))


def run_blocks(page, program):
    wanted = [b for b in page.blocks if b[1].split()[:1] in (['sh'], ['console']) and 'list' not in b[1].split()]
    if not wanted:
        return 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prepare(folder)
        for start, info, block in wanted:
            if info.startswith('console'):
                run_console(page, program, folder, start, block)
                continue
            stated = re.search(r'exit=(\d+)', info)
            done = run(folder, block, program, small=True)
            if done.returncode != int(stated[1] if stated else 0):
                fail(page.path, start, f'exit code {done.returncode}\n{block}\n{(done.stdout + done.stderr)[-3000:]}')
    return len(wanted)


def run_console(page, program, folder, start, block):
    printed = None
    for number, line in enumerate(block.split('\n'), start + 1):
        if line.startswith('$ '):
            done = run(folder, line[2:], program, small=False)
            if done.returncode in (1, 64):
                fail(page.path, number, f'exit code {done.returncode}: {done.stderr[-500:]}')
            printed = iter((done.stdout + done.stderr).split('\n'))
        elif printed is not None and line.strip() not in ('', '..'):
            match = pattern(line)
            if not any(match.match(p) for p in printed):
                fail(page.path, number, f'is not printed: {line}')
                return


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    paths = [ROOT / 'README.md', ROOT / 'CONTRIBUTING.md', ROOT / 'CHANGELOG.md', ROOT / 'SECURITY.md',
             ROOT / 'reports/schemas/README.md', ROOT / 'corpus/cases/README.md', *sorted((ROOT / 'docs').rglob('*.md'))]
    pages = {path: Page(path) for path in paths}
    check_links(pages)
    check_sizes(pages)
    commands = Commands(program)
    for page in pages.values():
        check_names(page, commands)
    chosen = [pathlib.Path(p).resolve() for p in sys.argv[2:]] or [
        p for p in paths if 'guides' not in p.parts and p.parent in (ROOT, ROOT / 'docs', ROOT / 'docs/results')]
    blocks = sum(run_blocks(pages[path], program) for path in chosen)
    for failure in failures:
        print(failure)
    print(f'{len(pages)} pages, {blocks} blocks run, {len(failures)} failures')
    return 1 if failures else 0


if __name__ == '__main__':
    sys.exit(main())
