#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the English of Markdown files, of comments in C, C++, TypeScript and JavaScript, and of Python's docstrings.
In TypeScript and JavaScript it also reads strings and the texts in tags. It finds each phrase of the list below,
sentences of 30 words or more, and sentences with more than one colon or semicolon. "plain_english.py FILE.." prints
its findings and exits with 1 if there are any. Code, tables, headings and "quotations" are not checked.
docs/docs_test.py runs it."""
import ast
import pathlib
import re
import sys

MOST_WORDS = 29

# Habit, pattern, better form, and an example that the pattern must match.
PHRASES = [
    ('tell, say', r'(?i)\b(?:told|tells?|telling|said|says?|saying)\b', 'reports, states, returns, records',
     'The page says so.'),
    ('is no', r'(?i)(?<!there )\b(?:is|are|was|were|be) no (?!longer|more\b|less\b|farther|nearer)', 'is not a',
     'It is no number.'),
    ('pronoun as a noun', r'(?i)\b(?:nobody|anybody|everybody|somebody|whoever|whatever|whichever)\b', 'a noun',
     'Whoever asks loses.'),
    ('pronoun as a noun', r'(?:^|[.:;] )(?:Who|What|Those|Whose) (?![^.?]*\?)', 'a noun', 'It ends. Who asks loses.'),
    ('pronoun as a noun', r'\b(?:of|by|to|than|from) those\b(?! who)', 'the noun again', 'the time of those.'),
    ('where for if', r'(?i)(?<!know )(?<!shows )(?<!show )(?<!see )(?<!find )(?<!finds )\bwhere\b(?! to\b)', 'if, when',
     'Where none is, it throws.'),
    ('of which', r'(?i)\bof (?:which|whom)\b', 'two sentences', 'pairs of which none fails'),
    ('missing noun', r'(?i)\blikewise\b|\bthose of the same\b', 'the noun again', 'Likewise, those of the same.'),
    ('but for', r'(?i), but for\b', 'except for, apart from, or two sentences', 'It is right, but for rounding.'),
    ('of it', r'\bof it(?=\.(?:\s|$)|$)', 'the noun, or its', 'The end of it.'),
    ('inverted sentence', r'(?:^|[.:;] )(?:Of|Beside|Said|Held|Told) ', 'the subject first', 'Said is the first.'),
]


def paragraphs(text):
    """Yields (line number, text) of each paragraph and list item, without code, tables, headings and comments."""
    fenced, start, held = False, 0, []
    for number, line in enumerate(text.splitlines() + [''], 1):
        bare = line.strip()
        fence = bare.startswith('```')
        fenced ^= fence
        item = re.match(r'(?:[*-]|\d+\.) ', bare)
        skipped = not bare or fence or fenced or bare.startswith(('|', '#', '<!--', '![')) or \
            (line.startswith('    ') and not held)
        if held and (skipped or item):
            yield start, ' '.join(held)
            held = []
        if not skipped:
            start = start if held else number
            held.append(bare[item.end():] if item else bare)


def comments(text):
    """Yields (line number, text) of each comment of a C or C++ file. Adjacent lines that begin in one column are one
    comment. An empty line or the mark of a list begins another one. Lines that are indented are code."""
    start, column, held, item, block = 0, 0, [], None, False
    for number, line in enumerate(text.splitlines() + [''], 1):
        mark = re.match(r' *(?:\*(?!/)|(?!\*))', line) if block else re.search(r'//[/!]?<?|(?<!\S)/\*', line)
        if mark and not block and (line[:mark.start()].endswith(':') or line[:mark.start()].count('"') % 2):
            mark = None
        words = line[mark.end():] if mark and 'SPDX' not in line else ''
        block = bool(mark) and (block or mark[0] == '/*') and '*/' not in words
        words = words.split('*/')[0]
        bare = words.strip()
        begun = bool(mark) and (bool(line[:mark.start()].strip()) or mark.end() != column)
        item_mark = re.match(r'(?:[*-]|\d+\.) ', bare)
        code = words.startswith('   ') and not begun and not item_mark and not (item and held)
        if held and (not bare or begun or item_mark or code):
            yield start, ' '.join(held)
            held = []
        if mark:
            column = mark.end()
        if bare and not code:
            start, item = (start, item) if held else (number, item_mark)
            held.append(bare[item_mark.end():] if item_mark else bare)


def strings(text):
    """Yields (line number, text) of each comment of TypeScript or JavaScript, of each string that has a space, and of
    each text between tags. Strings that "+" joins are one text."""
    yield from comments(text)
    code = re.sub(r'(?m)^ *(?://|/?\*).*|(?<![\S"`])//.*', '', text)
    whole = re.sub(r'["`]\s*\+\s*\n\s*["`]', '\v', code)  # \v stands for a line's end
    for found in re.finditer(r'"((?:[^"\\\n]|\\.)*)"|`((?:[^`\\]|\\.)*)`|(?<!=)>([\w\s,.;:?!\'-]+)<', whole):
        words = next(filter(None, found.groups()), '').replace('\\n', '. ')
        words = ' '.join(re.sub(r'\$\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}', 'Code', words).split())
        if len(words.split()) > 2 and '<' not in words:
            yield len(re.findall(r'[\n\v]', whole[:found.start()])) + 1, words


def docstrings(text):
    """Yields (line number, text) of each paragraph of each docstring of Python."""
    documented = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, documented) and (words := ast.get_docstring(node)):
            yield from ((node.body[0].lineno + number - 1, part) for number, part in paragraphs(words))


def prose(text):
    """The words that are read. A link is its text, code or a quotation is a word, a leading **term**: is a label."""
    text = re.sub(r'^(?:\*{1,2}[^*]+\*{1,2}(?:, )?)+: ', '', text)
    text = re.sub(r'\[[\w./]+\.\w+\]\([^)]*\)', 'File', text)
    text = re.sub(r'\[([^\]]*)\]\([^)]*\)', r'\1', text)
    text = re.sub(r'`[^`]*`', 'Code', text)
    text = re.sub(r'"[^"]*"', 'Quotation', text)
    return re.sub(r'[*_]{1,2}(?=\w)|(?<=\w)[*_]{1,2}|(?<=[.:!?])\*\*', '', text)


def phrases(text):
    """Yields (habit, message) of each phrase of the list."""
    for habit, pattern, better, _ in PHRASES:
        for match in re.finditer(pattern, text):
            around = text[max(0, match.start() - 20):match.end() + 25].strip()
            yield habit, f'"{match[0].strip()}" in "..{around}..": write {better}'


SPLITS = {'.hpp': comments, '.h': comments, '.cpp': comments, '.py': docstrings,
          '.ts': strings, '.tsx': strings, '.mjs': strings}


def findings(text, split=paragraphs):
    """Yields (line number, habit, message) of a text, which `split` divides into paragraphs."""
    for number, paragraph in split(text):
        paragraph = prose(paragraph)
        for habit, message in phrases(paragraph):
            yield number, habit, message
        for sentence in re.split(r'(?<=[.?!])\)?\s+(?=[A-Z(0-9]|daylight )', paragraph):
            # Words and numbers; symbols of a formula are not words.
            words = len(re.findall(r"(?<![\w|])(?:[A-Za-z][a-z'-]+|[aA]|\d[\d.,e-]*)(?![\w|(])", sentence))
            if words > MOST_WORDS:
                yield number, 'long sentence', f'{words} words, {MOST_WORDS} are allowed: "{sentence[:60]}.."'
            if len(re.findall(r'[:;](?=\s|$)', sentence)) > 1:
                yield number, 'colon chain', f'more than one colon or semicolon: "{sentence[:60]}.."'


def main():
    found = [f'{name}:{number}: {message}' for name in sys.argv[1:] for number, _, message in findings(
        pathlib.Path(name).read_text(), SPLITS.get(pathlib.Path(name).suffix, paragraphs))]
    print('\n'.join(found))
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
