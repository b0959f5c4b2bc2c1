#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the C++ files of over 400 lines and the functions of over 60, longest first: LINES FILE or LINES FILE:LINE HEAD.

    tools/long.py [FILE_LINES FUNCTION_LINES]

A function is what stands in braces after a parameter list outside of other functions, its head included.
"""
import re
import subprocess
import sys

TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|[{};]', re.DOTALL)
SCOPE = re.compile(r'\b(namespace|class|struct|union|enum|extern)\b')


def functions(text):
    """Yields (line, lines, head) of each function."""
    scopes, start, function = [], 0, None
    text = re.sub(r'^[ \t]*#[^\n]*', lambda found: ' ' * len(found[0]), text, flags=re.MULTILINE)
    for token in TOKEN.finditer(text):
        mark = token[0]
        if mark not in '{};':
            if mark.startswith(('//', '/*')) and not text[start:token.start()].strip():
                start = token.end()
            continue
        if mark == '{':
            head = text[start:token.start()].strip()
            scopes.append(SCOPE.search(head.split('(')[0]) is not None)
            if function is None and not scopes[-1] and ')' in head:
                function = (len(scopes), text.count('\n', 0, token.start()) - head.count('\n'), head)
        elif mark == '}' and scopes:
            if function and function[0] == len(scopes):
                yield function[1] + 1, text.count('\n', 0, token.end()) - function[1] + 1, ' '.join(function[2].split())
                function = None
            scopes.pop()
        if function is None:
            start = token.end()


def main():
    file_cap, function_cap = map(int, sys.argv[1:] or (400, 60))
    listed = subprocess.run(['git', 'ls-files', '*.cpp', '*.hpp', '*.h'], check=True, stdout=subprocess.PIPE, encoding='utf-8')
    long_files, long_functions = [], []
    for path in listed.stdout.split():
        try:
            with open(path, encoding='utf-8') as file:
                text = file.read()
        except FileNotFoundError:  # deleted, not yet committed
            continue
        if text.count('\n') > file_cap:
            long_files.append((text.count('\n'), path))
        long_functions += [(lines, f'{path}:{line}', head) for line, lines, head in functions(text) if lines > function_cap]
    for found in sorted(long_files, reverse=True) + sorted(long_functions, reverse=True):
        print(*found)


main()
