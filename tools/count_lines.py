#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts the lines that people maintain, by kind and by top folder:   count_lines.py [REVISION]

Counted are the tracked C++, web, test and script files. Generated pages, data, documents and pictures are not."""
import collections
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).parent.parent
KINDS = {  # the first that matches a path
    'not counted': r'page_template\.html$|package-lock\.json$|^vectors/v\d/|(^|/)docs/(?!.*test)',
    'tests': r'_test\.\w+$|_test/|/tests?/',
    'C++ sources': r'\.(cpp|hpp|h|in)$',
    'web': r'\.(ts|tsx|mjs|js|css|html)$',
    'scripts': r'\.(py|sh|cmake)$|(^|/)(CMakeLists\.txt|daylight)$|^\.ci/',
}


def git(*arguments):
    return subprocess.run(['git', '-C', ROOT, *arguments], check=True, capture_output=True).stdout


def main(revision='HEAD'):
    lines = collections.Counter()
    for path in git('ls-tree', '-r', '--name-only', revision).decode().splitlines():
        kind = next((kind for kind, pattern in KINDS.items() if re.search(pattern, path)), 'not counted')
        if kind == 'not counted':
            continue
        lines[path.split('/')[0] if '/' in path else '.', kind] += git('show', f'{revision}:{path}').count(b'\n')
    kinds = [kind for kind in KINDS if kind != 'not counted']
    print(f'{"":10}' + ''.join(f'{kind:>13}' for kind in [*kinds, 'all']))
    for folder in [*sorted({folder for folder, _ in lines}), 'all']:
        counts = [sum(n for (f, k), n in lines.items() if folder in (f, 'all') and k == kind) for kind in kinds]
        print(f'{folder:10}' + ''.join(f'{n:13,}' for n in [*counts, sum(counts)]))


if __name__ == '__main__':
    main(*sys.argv[1:])
