#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes copies of our sources with the faults of planted_faults.jsonl in them, and the table of these faults.

    plant_faults.py SOURCE_FOLDER OUTPUT_FOLDER

Each line of planted_faults.jsonl is one fault:

    file     a source or header of solver/, or any other source
    find     text that is exactly once in the file, or exactly once in `near`, a longer text that is exactly once in it
    replace  the text instead if the fault is chosen
    what     the fault in words
    law      a law that the faulty methods break in the gate

A text that ends in ';' or '}' is a statement. Any other is an expression, and an operand as it stands.
"""
import json
import os
import sys

TABLE = 'props/gate/planted_faults.jsonl'


def place(fault, text):
    """The begin and the end of the fault's text in the file."""
    start, end = 0, len(text)
    for key in ('near', 'find'):
        if key not in fault:
            continue
        count = text.count(fault[key], start, end)
        if count != 1:
            sys.exit(f'{TABLE}:{fault["number"]}: `{key}` is {count} times in {fault["file"]}, must be once: {fault[key]}')
        start = text.index(fault[key], start, end)
        end = start + len(fault[key])
    return start, end


def planted(text, faults):
    before = len(text)
    for start, end, fault in sorted(((*place(f, text), f) for f in faults), key=lambda p: p[0], reverse=True):
        if end > before:
            sys.exit(f'{TABLE}:{fault["number"]}: its text overlaps that of another fault')
        before = start
        original, wrong, chosen = text[start:end], fault['replace'], f'::cyl::is_planted({fault["number"]})'
        if original.endswith((';', '}')):
            switch = f'{{ if ({chosen}) {{ {wrong} }} else {{ {original} }} }}'
        else:
            switch = f'({chosen} ? ({wrong}) : ({original}))'
        text = text[:start] + switch + text[end:]
    return text


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w', encoding='utf-8') as file:
        file.write(text)


def main():
    source, output = sys.argv[1:]
    with open(os.path.join(source, TABLE), encoding='ascii') as file:
        faults = [json.loads(line) for line in file]
    for number, fault in enumerate(faults, 1):
        fault['number'] = number
    for name in {f['file'] for f in faults}:
        with open(os.path.join(source, name), encoding='utf-8') as file:
            text = planted(file.read(), [f for f in faults if f['file'] == name])
        write(os.path.join(output, name), f'#include "props/gate/planted_faults.hpp"\n#line 1 "{name}"\n{text}')
    rows = ''.join(f'    {{{f["law"]}, {json.dumps(f["file"])}, {json.dumps(f["what"])}}},\n' for f in faults)
    write(os.path.join(output, 'planted_faults.cpp'),
          '#include "props/gate/planted_faults.hpp"\n\nnamespace cyl {\n\n'
          'static const PlantedFault faults[] = {\n' + rows + '};\n\n'
          'int planted_fault = 0;\nstd::span<const PlantedFault> planted_faults() { return faults; }\n\n}\n')


main()
