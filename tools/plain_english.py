#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the English of Markdown files: no phrase of the list below, no sentence of 30 words or more, no sentence with
more than one colon or semicolon. "plain_english.py FILE.." prints what it finds and exits with 1 if there is anything.
"--count" prints totals only. Code, tables, headings and quotations in "double quotes" are not prose."""
import pathlib
import re
import sys

MOST_WORDS = 29

# A pattern of a phrase, the form to use in its place, and the habit that it belongs to.
PHRASES = [
    (r'\b(?:told|tells?|telling|said|says?|saying)\b', 'reports, states, returns, records', 'tell, say'),
    (r'(?<!there )(?<!There )\b(?:is|are|was|were|be) no (?!longer|more\b|less\b|farther|nearer)', 'is not a', 'is no'),
    (r'\b(?:nobody|anybody|everybody|somebody|whoever|whatever|whichever)\b', 'name who or what', 'pronoun as a noun'),
    (r'(?:^|[.:;] )(?:Who|What|Those|Whose) (?![^.?]*\?)', 'begin with a noun', 'pronoun as a noun'),
    (r'\b(?:of|by|to|than|from) those\b(?! who)', 'repeat the noun', 'pronoun as a noun'),
    (r'(?<!know )(?<!shows )(?<!show )(?<!see )(?<!Shows )(?<!find )(?<!finds )\bwhere\b(?! to\b)', 'if, when', 'where for if'),
    (r'\bof (?:which|whom)\b', 'split the sentence', 'of which'),
    (r'(?:^|[.:;] )(?:Of|Beside|Said|Held|Told) ', 'begin with the subject', 'inverted sentence'),
]


def paragraphs(text):
    """Yields (line number, text) of each paragraph and list item, without code, tables, headings and comments."""
    fenced, start, held, indent = False, 0, [], 0
    for number, line in enumerate(text.splitlines() + [''], 1):
        fence = line.lstrip().startswith('```')
        fenced ^= fence
        bare = line.strip()
        item = re.match(r'(?:[*-]|\d+\.) ', bare)
        code = line.startswith('    ') and not held
        if not bare or item or fence or fenced or code or bare.startswith(('|', '#', '<!--', '![')):
            if held:
                yield start, ' '.join(held)
            held = []
        if bare and not (fence or fenced or code or bare.startswith(('|', '#', '<!--', '!['))):
            start = start if held else number
            held.append(bare[item.end():] if item and not held else bare)


def prose(text):
    """The words that are read: a link is its text, code and a quotation are one word, a leading **term**: is a label."""
    text = re.sub(r'^(?:\*{1,2}[^*]+\*{1,2}(?:, )?)+: ', '', text)
    text = re.sub(r'\[[\w./]+\.\w+\]\([^)]*\)', 'File', text)
    text = re.sub(r'\[([^\]]*)\]\([^)]*\)', r'\1', text)
    text = re.sub(r'`[^`]*`', 'Code', text)
    text = re.sub(r'"[^"]*"', 'Quotation', text)
    return re.sub(r'[*_]{1,2}(?=\w)|(?<=\w)[*_]{1,2}|(?<=[.:!?])\*\*', '', text)


def sentences(text):
    return [s for s in re.split(r'(?<=[.?!])\)?\s+(?=[A-Z(0-9]|daylight )', text) if s]


def findings(text):
    """Yields (line, habit, message) of a Markdown text."""
    for number, paragraph in paragraphs(text):
        paragraph = prose(paragraph)
        for pattern, better, habit in PHRASES:
            for match in re.finditer(pattern, paragraph):
                around = paragraph[max(0, match.start() - 20):match.end() + 25].strip()
                yield number, habit, f'"{match[0].strip()}" in "..{around}..": write {better}'
        for sentence in sentences(paragraph):
            words = len(re.findall(r"(?<![\w|])(?:[A-Za-z][a-z'-]+|[aA]|\d[\d.,e-]*)(?![\w|(])", sentence))  # no symbols
            if words > MOST_WORDS:
                yield number, 'long sentence', f'{words} words, {MOST_WORDS} are allowed: "{sentence[:60]}.."'
            if len(re.findall(r'[:;](?=\s|$)', sentence)) > 1:
                yield number, 'colon chain', f'more than one colon or semicolon: "{sentence[:60]}.."'


def main():
    counts = {}
    for name in [word for word in sys.argv[1:] if word != '--count']:
        for number, habit, message in findings(pathlib.Path(name).read_text()):
            counts[habit] = counts.get(habit, 0) + 1
            if '--count' not in sys.argv:
                print(f'{name}:{number}: {message}')
    for habit, count in sorted(counts.items()):
        print(f'{count:5} {habit}')
    return 1 if counts else 0


if __name__ == '__main__':
    sys.exit(main())
