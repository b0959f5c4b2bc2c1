#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every operator, constant, comparison and term of a C++ source changed once, by rule.

mutations(path, text) returns them in order; a mutation is one span of the text and what stands there instead. The sites
are found in tokens, not in a syntax tree: the sources are formatted by clang-format, so a comparison or a binary operator
has blanks on both sides and a template's bracket has not. Where a site could be changed in several ways (a comparison by
its edge or turned, a product by its operator or by a factor) a hash of the site chooses, so that nobody does.

Nothing is changed in comments, strings, preprocessor lines, template arguments, static assertions and declared lengths
of arrays. A change that makes no sense as C++ does not compile, and then counts for nothing.
"""
import hashlib
import re
from typing import NamedTuple


class Mutation(NamedTuple):
    id: str     # path:hash of the line's text:kind.ordinal, the same whatever is added elsewhere in the file
    path: str
    line: int
    kind: str
    start: int  # the span in the text
    end: int
    now: str    # what stands there instead


NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*|(R"(\w*)\(.*?\)\2"|"(?:\\.|[^"\\\n])*")',
                     re.DOTALL | re.MULTILINE)
TOKEN = re.compile(r'''(?P<text>"[^"]*"|'(?:\\.|[^'\\\n])+')
    |(?P<number>0[xX][0-9a-fA-F']+(?:\.[0-9a-fA-F]*)?(?:[pP][+-]?\d+)?\w*|(?:\d[\d']*\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\w*)
    |(?P<name>[A-Za-z_]\w*(?:::[A-Za-z_~]\w*)*)
    |(?P<mark><=>|<<=|>>=|->|\+\+|--|<<|[-+*/%&|^<>=!]=|&&|\|\||::|[^\s\w])''', re.VERBOSE)

SWAPS = {'+': '-', '-': '+', '*': '/', '/': '*', '&&': '||', '||': '&&', '==': '!=', '!=': '==', '&': '|', '|': '&',
         '+=': '-=', '-=': '+=', '*=': '/=', '/=': '*=', '|=': '&=', '&=': '|=', '%': '*', '<<': '>>'}
EDGES = {'<': '<=', '<=': '<', '>': '>=', '>=': '>'}
TURNS = {'<': '>', '<=': '>=', '>': '<', '>=': '<='}
PARTNERS = [('min', 'max'), ('fmin', 'fmax'), ('min2', 'max2'), ('smaller', 'larger'), ('floor', 'ceil'), ('true', 'false'),
            ('next_up', 'next_down'), ('MPFR_RNDU', 'MPFR_RNDD'), ('round_up', 'round_down')]
PARTNER = {**dict(PARTNERS), **{b: a for a, b in PARTNERS}}
ARITHMETIC = re.compile(r'((?:mp[a-z]+_)(?:[a-z]+_)?)(add|sub|mul|div)(_\w+)?$')
CALLED = {'add': 'sub', 'sub': 'add', 'mul': 'div', 'div': 'mul'}
DROPPED = {'sqrt', '__builtin_sqrt', 'root', 'abs', 'fabs', 'magnitude', 'positive'}

WORDS_BEFORE_VALUES = {'return', 'case', 'else', 'throw', 'co_return'}
OPEN, CLOSE = {'(', '[', '{'}, {')', ']', '}'}
# What ends a term, besides + and -; and a factor, besides these.
ENDS = {',', ';', '?', ':', '=', '<', '>', '<=', '>=', '==', '!=', '&&', '||', '+=', '-=', '*=', '/=', '&', '|', '<<',
        '&=', '|=', '<<='}
FACTOR_ENDS = {'*', '/', '%'}


class Token(NamedTuple):
    kind: str  # text, number, name, mark, or `template` for all that stands in a template's brackets
    text: str
    start: int
    end: int


def code_only(text):
    """The text with comments and preprocessor lines blanked and strings emptied, each place where it was."""
    def blank(found):
        inner = re.sub(r'[^\n]', ' ', found[0])
        return '"' + inner[1:-1] + '"' if found[1] else inner
    return NO_CODE.sub(blank, text)


def tokens_of(text):
    code = code_only(text)
    tokens, depth, begin = [], 0, 0
    for found in TOKEN.finditer(code):
        kind, mark = found.lastgroup, found[0]
        blanks = code[found.start() - 1:found.start()].isspace() and code[found.end():found.end() + 1].isspace()
        after_operator = tokens and tokens[-1].text.rpartition('::')[2] == 'operator'
        if kind == 'mark' and mark == '<' and not blanks and not after_operator:
            if depth == 0:
                begin = found.start()
            depth += 1
        elif depth and mark == '>' and not blanks:
            depth -= 1
            if depth == 0:
                tokens.append(Token('template', code[begin:found.end()], begin, found.end()))
        elif not depth:
            tokens.append(Token(kind, mark, found.start(), found.end()))
    return tokens


def skipped(tokens):
    """Numbers of the tokens that stand in a static assertion or are the declared length of an array."""
    out = set()
    for i, token in enumerate(tokens):
        if token.text == 'static_assert':
            depth, j = 0, i + 1
            while j < len(tokens):
                depth += (tokens[j].text == '(') - (tokens[j].text == ')')
                out.add(j)
                if depth == 0:
                    break
                j += 1
        if (token.text == '[' and i >= 2 and tokens[i - 1].kind == 'name' and tokens[i - 2].text not in WORDS_BEFORE_VALUES
                and (tokens[i - 2].kind in ('name', 'template') or tokens[i - 2].text in ('*', '&'))
                and (tokens[i - 2].kind != 'mark' or tokens[i - 2].end == tokens[i - 1].start - 1)):
            out.add(i + 1)
    return out


class Source:
    def __init__(self, path, text):
        self.path, self.text, self.tokens = path, text, tokens_of(text)
        self.found, self.sites = [], {}

    def is_binary(self, i):
        token, tokens = self.tokens[i], self.tokens
        if i == 0 or not (self.text[token.start - 1].isspace() and self.text[token.end:token.end + 1].isspace()):
            return False
        before = tokens[i - 1]
        return (before.kind in ('number', 'text', 'template') or before.text in (')', ']', '}')
                or before.kind == 'name' and before.text not in WORDS_BEFORE_VALUES)

    def ends_operand(self, i, ends):
        mark = self.tokens[i].text
        if self.tokens[i].kind != 'mark':
            return mark in WORDS_BEFORE_VALUES
        return mark in ENDS or mark in ends and self.is_binary(i)

    def operand(self, i, step, ends):
        """The last token, in that direction, of the operand beside the operator i."""
        depth, j = 0, i
        inward, outward = (OPEN, CLOSE) if step > 0 else (CLOSE, OPEN)
        while 0 <= j + step < len(self.tokens):
            mark = self.tokens[j + step].text
            if depth == 0 and (mark in outward or self.ends_operand(j + step, ends)):
                break
            depth += (mark in inward) - (mark in outward)
            j += step
        return j

    def add(self, kind, start, end, now):
        line = self.text.count('\n', 0, start)
        words = ' '.join(self.text.split('\n')[line].split())
        now += '\n' * (self.text.count('\n', start, end) - now.count('\n'))
        name = f'{self.path}:{hashlib.sha256(words.encode()).hexdigest()[:8]}:{kind}'
        number = self.sites[name] = self.sites.get(name, 0) + 1
        self.found.append(Mutation(f'{name}.{number}', self.path, line + 1, kind, start, end, now))

    def choose(self, token, count):
        """The way in which this site is changed, of so many."""
        line = self.text[self.text.rfind('\n', 0, token.start) + 1:].split('\n', 1)[0]
        column = token.start - self.text.rfind('\n', 0, token.start)
        return int(hashlib.sha256(f'{self.path} {line.strip()} {column}'.encode()).hexdigest(), 16) % count

    def number(self, token):
        text = token.text
        power = re.fullmatch(r'(0[xX][0-9a-fA-F.\']+[pP])([+-]?\d+)(\w*)', text)
        if power and abs(int(power[2])) > 1:
            half = int(int(power[2]) / 2)
            self.add('constant', token.start, token.end, f'{power[1]}{half}{power[3]}')
        elif re.fullmatch(r'0[uUlLfFzZ]*|0\.0*', text):
            self.add('constant', token.start, token.end, text.replace('0', '1', 1))
        else:
            self.add('constant', token.start, token.end, f'({text} {"*/"[self.choose(token, 2)]} 2)')

    def drop_term(self, i):
        """The term behind an operator + or -, and the first one of the sum."""
        token, tokens = self.tokens[i], self.tokens
        last = self.operand(i, 1, {'+', '-'})
        if last > i:
            self.add('term', tokens[i - 1].end, tokens[last].end, '')
        first = self.operand(i, -1, {'+', '-'})
        begins = first > 0 and not (tokens[first - 1].text in ('+', '-') and self.is_binary(first - 1))
        if begins and first < i:
            end = tokens[i + 1].start if token.text == '+' else token.end
            self.add('first term', tokens[first].start, end, '-' if token.text == '-' else '')

    def binary(self, i):
        token, tokens = self.tokens[i], self.tokens
        mark = token.text
        if mark in EDGES:
            kind, now = [('edge', EDGES[mark]), ('turn', TURNS[mark])][self.choose(token, 2)]
            self.add(kind, token.start, token.end, now)
        elif mark == '*' and (way := self.choose(token, 3)):
            side = self.operand(i, 1 if way == 1 else -1, {'+', '-'} | FACTOR_ENDS)
            if way == 1:
                self.add('factor', tokens[i - 1].end, tokens[side].end, '')
            else:
                self.add('factor', tokens[side].start, tokens[i + 1].start, '')
        elif mark in SWAPS:
            self.add('operator', token.start, token.end, SWAPS[mark])
        if mark in ('+', '-'):
            self.drop_term(i)

    def unary(self, i):
        token = self.tokens[i]
        touches = not self.text[token.end:token.end + 1].isspace()
        if token.text in ('-', '!') and touches and not (i and self.tokens[i - 1].text == 'operator'):
            self.add('sign' if token.text == '-' else 'negation', token.start, token.end, '')

    def name(self, i):
        token, tokens = self.tokens[i], self.tokens
        last = token.text.rpartition('::')[2]
        scope = token.text[:len(token.text) - len(last)]
        called = i + 1 < len(tokens) and tokens[i + 1].text == '('
        declared = (i > 0 and tokens[i - 1].kind in ('name', 'template') and tokens[i - 1].text not in WORDS_BEFORE_VALUES
                    or i > 0 and tokens[i - 1].text in ('*', '&', '.') and tokens[i - 1].end == token.start)
        if last in PARTNER and (called or last in ('true', 'false') or last.startswith('MPFR')) and not declared:
            self.add('partner', token.start, token.end, scope + PARTNER[last])
        elif last in DROPPED and called and not declared:
            self.add('call', token.start, token.end, '')
        elif (parts := ARITHMETIC.match(last)) and called:
            self.add('operator', token.start, token.end, parts[1] + CALLED[parts[2]] + (parts[3] or ''))

    def scan(self):
        leave = skipped(self.tokens)
        for i, token in enumerate(self.tokens):
            if i in leave or i and self.tokens[i - 1].text.rpartition('::')[2] == 'operator':
                continue
            if token.kind == 'number':
                self.number(token)
            elif token.kind == 'name':
                self.name(i)
            elif token.kind == 'mark':
                (self.binary if self.is_binary(i) or token.text in SWAPS and token.text.endswith('=') else self.unary)(i)
        return self.found


def mutations(path, text):
    return Source(path, text).scan()


def mutated(mutation, text):
    return text[:mutation.start] + mutation.now + text[mutation.end:]
