# SPDX-License-Identifier: MIT
"""python -m daylight_vectors MODULE:FUNCTION asks a function about a tier; --lint proves a file of vectors instead.

Exit status: 0 nothing is wrong, 2 something is, 64 wrong usage.
"""
import argparse
import pathlib
import sys

from . import flags, load
from .lint import lint, missing_rows
from .runner import LIMIT, STORE, Run, exclusions, report


def main(arguments=None):
    parser = argparse.ArgumentParser('python -m daylight_vectors', description=__doc__.splitlines()[0])
    parser.add_argument('function', nargs='?', metavar='MODULE:FUNCTION')
    parser.add_argument('--tier', default='smoke', help='smoke, standard, or a file of `daylight vectors`')
    parser.add_argument('--tolerance', type=float, default=0.0, help='a length that the library states')
    parser.add_argument('--limit', type=float, default=LIMIT, help='seconds that an answer may take')
    parser.add_argument('--exclude', metavar='FILE', help='an id and a reason a line')
    parser.add_argument('--store', default=STORE, help='file of the ids that failed, which are asked first next time')
    parser.add_argument('--lint', metavar='FILE', nargs='+', help='prove the vectors of these files')
    parser.add_argument('--page', metavar='FILE', help='with --lint: the page that has a row for each flag')
    try:
        asked = parser.parse_args(arguments)
    except SystemExit as end:
        return 64 if end.code else 0
    if asked.lint:
        return prove(asked.lint, asked.page)
    if not asked.function:
        parser.print_usage(sys.stderr)
        return 64
    return ask(asked)


def prove(files, page):
    wrong = 0
    for file in files:
        for line in lint(load(file), flags()):
            print(f'{file}: {line}')
            wrong += 1
    for flag in sorted(missing_rows(flags(), pathlib.Path(page).read_text(encoding='utf-8')) if page else ()):
        print(f'{page}: {flag} is a flag or a row, not both')
        wrong += 1
    print(f'{wrong} wrong')
    return 2 if wrong else 0


def ask(asked):
    try:
        run = Run(asked.function, load(asked.tier)['vectors'], asked.tolerance, exclusions(asked.exclude),
                  asked.store, asked.limit)
    except (ValueError, OSError) as error:
        print(error, file=sys.stderr)
        return 64
    for flag_and_decade, vectors in run.cells().items():
        failing = [v for v in vectors if run.is_wrong(v)]
        if failing:
            print(f'{" ".join(flag_and_decade)}: {report(flag_and_decade[0], failing, run.results)}')
    run.finish()
    wrong = sum(map(run.is_wrong, run.vectors))
    said = list(run.results.values())
    print(f'{len(said)} asked: {said.count("right")} right, {said.count("acceptable")} within the tolerance, '
          f'{said.count("declined")} declined, {wrong} wrong; {len(run.excluded)} excluded')
    return 2 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
