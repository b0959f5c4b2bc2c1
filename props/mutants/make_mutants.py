#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the mutated copies of the sources named in props/mutants/mutants.jsonl, and the table of the mutants.

    make_mutants.py SOURCE_FOLDER OUTPUT_FOLDER
    make_mutants.py --reached SOURCE_FOLDER SOURCE..    prints those sources that a fault reaches: planted in
                                                        them, or in a header that they include

One entry a line; of its fields number, file, find, replace, what and like are needed:
    number      > 0, kept for good: the next free one of the hundred that its neighbours are in
    file        from the top of the project
    find        exact text, exactly once in the file, or in `near`, a longer text that is exactly once in the file
    replace     what stands there in the mutant, on one line
    what, like  the fault in words; its kind
    asks        methods held to the laws, default "intersect,decide,distance,exact"
    tests       filter of the unit tests, default none
    equivalent  why no test can see the fault
    set         the experiment it is made for; narrow: seen only at an angle below 1e-7 or a margin below 1e-12
                (tools/blindness.py)
A text that ends in ';' or '}' is a statement and becomes { if (selected) { replace } else { find } }; any other is an
expression and becomes (selected ? (replace) : (find)), so it must be an operand as it stands: one that is not
changes the unmutated program too, which the test mutants_off_change_nothing sees. One text may lie within
another's, or be another's. Line numbers of the copies are those of the originals.
"""
import json
import os
import re
import sys

NEEDED = {'number', 'file', 'find', 'replace', 'what', 'like'}
OPTIONAL = {'near', 'asks', 'tests', 'equivalent', 'set'}
EVERYTHING = 'intersect,decide,distance,exact'


def fail(line, entry, what, remedy):
    sys.exit(f'props/mutants/mutants.jsonl:{line}: mutant {entry.get("number", "?")}: {what}\n    {remedy}')


def read_entries(path):
    entries, numbers = [], set()
    with open(path, encoding='ascii') as file:
        for line, text in enumerate(file, 1):
            if not text.strip():
                continue
            try:
                entry = json.loads(text)
            except ValueError as error:
                sys.exit(f'props/mutants/mutants.jsonl:{line}: not JSON: {error}')
            entry['line'] = line
            wrong = NEEDED - entry.keys() or entry.keys() - NEEDED - OPTIONAL - {'line'}
            if wrong:
                fail(line, entry, f'fields missing or unknown: {sorted(wrong)}', 'see props/mutants/make_mutants.py')
            if entry['number'] in numbers or entry['number'] <= 0:
                fail(line, entry, 'its number is taken or not > 0', 'take a new one; a number is never used again')
            if '\n' in entry['replace'] or entry['replace'] == entry['find']:
                fail(line, entry, 'its replacement has a line end, or changes nothing', 'write another')
            numbers.add(entry['number'])
            entries.append(entry)
    return sorted(entries, key=lambda e: e['number'])


def place(entry, text):
    """Where the entry's text begins and ends in the file."""
    start, end = 0, len(text)
    for field in ('near', 'find'):
        if field not in entry:
            continue
        count = text.count(entry[field], start, end)
        if count != 1:
            fail(entry['line'], entry, f'`{field}` is {count} times in {entry["file"]}, must be once: {entry[field]}',
                 'the source has changed: correct the text, or say where it is with `near`; drop no mutant for it')
        start = text.index(entry[field], start, end)
        end = start + len(entry[field])
    return start, end


def choose(entry, original):
    selected = f'::cyl::mutant_is({entry["number"]})'
    if entry['find'].endswith((';', '}')):
        return f'{{ if ({selected}) {{ {entry["replace"]} }} else {{ {original} }} }}'
    return f'({selected} ? ({entry["replace"]}) : ({original}))'


def render(text, start, end, places):
    """text[start:end] with the switches of `places`, a list of (start, end, entry), outer ones first."""
    parts, at = [], start
    while places:
        first, last, _ = places[0]
        here = [p for p in places if p[:2] == (first, last)]
        inside = [p for p in places if p not in here and p[0] < last]
        places = places[len(here) + len(inside):]
        for p in inside:
            if p[1] > last:
                fail(p[2]['line'], p[2], f'its text overlaps that of mutant {here[0][2]["number"]}',
                     'make one contain the other')
        body = render(text, first, last, inside)
        for p in here:
            body = choose(p[2], body)
        parts += [text[at:first], body]
        at = last
    return ''.join(parts) + text[at:end]


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    try:
        with open(path, encoding='utf-8') as file:
            if file.read() == text:
                return  # its time stays, so nothing is compiled again
    except FileNotFoundError:
        pass
    with open(path, 'w', encoding='utf-8') as file:
        file.write(text)


def table(entries):
    literal = json.dumps  # of ASCII: a string literal of C++ as well
    rows = []
    for e in entries:
        words = [e['file'], e['what'], e['like'], e.get('asks', EVERYTHING), e.get('tests', ''),
                 e.get('equivalent', '')]
        rows.append(f'    {{{e["number"]}, {", ".join(map(literal, words))}}},\n')
    return ('#include <cstdlib>\n#include "props/mutants/mutant_is.hpp"\n#include "props/mutants/mutants.hpp"\n\nnamespace cyl {\n\n'
            'static const Mutant mutants[] = {\n' + ''.join(rows) + '};\n\n'
            'static int number_in_environment() {\n'
            '  const char* text = std::getenv("DAYLIGHT_MUTANT");\n  return text ? std::atoi(text) : 0;\n}\n\n'
            'int selected_mutant = number_in_environment();\n'
            'std::span<const Mutant> all_mutants() { return mutants; }\n'
            'void select_mutant(int number) noexcept { selected_mutant = number; }\n\n}  // namespace cyl\n')


def reached(source, names):
    """Those of the names that hold a fault, or that include, however deep, a header which does."""
    faulty = {e['file'] for e in read_entries(os.path.join(source, 'props/mutants/mutants.jsonl'))}
    known = {}

    def reaches(name):
        if name not in known:
            known[name] = False  # an include of itself adds nothing
            try:
                with open(os.path.join(source, name), encoding='utf-8') as file:
                    included = re.findall(r'^\s*#\s*include\s*"([^"]+)"', file.read(), re.MULTILINE)
            except FileNotFoundError:
                included = []  # made by the build
            known[name] = name in faulty or any([reaches(other) for other in included])
        return known[name]

    return [name for name in names if reaches(name)]


def main():
    if sys.argv[1] == '--reached':
        print('\n'.join(reached(sys.argv[2], sys.argv[3:])))
        return
    source, output = sys.argv[1:]
    entries = read_entries(os.path.join(source, 'props/mutants/mutants.jsonl'))
    for name in sorted({e['file'] for e in entries}):
        with open(os.path.join(source, name), encoding='utf-8') as file:
            text = file.read()
        places = [(*place(e, text), e) for e in entries if e['file'] == name]
        places.sort(key=lambda p: (p[0], -p[1]))
        write(os.path.join(output, name),
              f'#include "props/mutants/mutant_is.hpp"\n#line 1 "{name}"\n' + render(text, 0, len(text), places))
    write(os.path.join(output, 'props/mutants/mutant_table.cpp'), table(entries))


main()
