#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The manual page and the completion of a shell, made from what `daylight --help` and `daylight COMMAND --help` print.

    manual.py DAYLIGHT page >daylight.1
    manual.py DAYLIGHT bash >daylight           for bash-completion; zsh takes the same through bashcompinit
"""
import re
import subprocess
import sys


def help_of(program, *command):
    done = subprocess.run([program, *command, '--help'], capture_output=True, text=True, check=True)
    return done.stdout.rstrip('\n')


class Help:
    """What one --help says: a summary, groups of entries (name, text), and what stands below them."""

    def __init__(self, text):
        self.groups, self.after = {}, []
        lines = text.split('\n')
        self.summary = lines[0]
        group = None
        for line in lines[1:]:
            if heading := re.match(r'^([A-Z][A-Za-z]*):$', line):
                group = heading[1]
                if group != 'Example':
                    self.groups[group] = []
                    continue
            entry = re.match(r'^  (\S.*?)(?: {2,}(\S.*))?$', line)
            if group and group != 'Example' and entry:
                self.groups[group].append([entry[1], entry[2] or ''])
            elif group and group != 'Example' and line.startswith('    '):
                self.groups[group][-1][1] = (self.groups[group][-1][1] + ' ' + line.strip()).strip()
            elif line and not line.startswith('Usage:'):
                group = None if group != 'Example' else group
                self.after.append(line)

    def commands(self):
        return [(name, text) for group, entries in self.groups.items() if group not in ('Options', 'Positionals')
                for name, text in entries]

    def options(self):
        return re.findall(r'(?<![\w-])--[a-z][a-z-]*', ' '.join(n.split(' Excludes')[0].split(' Needs')[0]
                                                                  for n, _ in self.groups.get('Options', [])))


def roff(text):
    text = text.replace('\\', '\\e').replace('-', '\\-')
    return '\n'.join('\\&' + line if line.startswith(('.', "'")) else line for line in text.split('\n'))


def manual_page(program):
    top = Help(help_of(program))
    version = subprocess.run([program, '--version'], capture_output=True, text=True, check=True).stdout.split()[1]
    out = [f'.TH DAYLIGHT 1 "" "daylight {version}" "User Commands"', '.SH NAME',
           'daylight \\- do two cylinders intersect, and who gets it wrong?', '.SH SYNOPSIS',
           '.B daylight', '.I COMMAND', '[\\fIOPTIONS\\fR]', '.SH DESCRIPTION', roff(top.summary), '.SH COMMANDS']
    for group, entries in top.groups.items():
        if group == 'Options':
            continue
        out.append(f'.SS {group}')
        for name, text in entries:
            out += ['.TP', f'.B {roff(name)}', roff(text)]
    for name, _ in top.commands():
        page = Help(help_of(program, name))
        out += [f'.SH "daylight {name}"', roff(page.summary + '.')]
        for group in ('Positionals', 'Options'):
            for entry, text in page.groups.get(group, []):
                if not entry.startswith('-h,'):
                    out += ['.TP', f'\\fB{roff(entry)}\\fR', roff(text)]
        own = [line for line in page.after if line not in top.after]
        if own:
            out += ['.PP', '.nf', *(roff(line) for line in own), '.fi']
    exit_codes = ' '.join(line for line in top.after if not line.startswith('daylight COMMAND'))
    out += ['.SH "EXIT STATUS"', roff(exit_codes.removeprefix('Exit code: '))]
    return '\n'.join(out) + '\n'


def completion(program):
    names = [name for name, _ in Help(help_of(program)).commands()]
    cases = '\n'.join(f"    {name}) options='{' '.join(sorted(set(Help(help_of(program, name)).options())))}' ;;"
                      for name in names)
    return f"""# Completion of daylight's commands and options; made by tools/manual.py.
_daylight() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} options=
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W '{' '.join(names)} --help --version' -- "$word"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{cases}
  esac
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}}
[[ ! $ZSH_VERSION ]] || {{ autoload -Uz bashcompinit && bashcompinit; }}
complete -o filenames -F _daylight daylight ./daylight
"""


if __name__ == '__main__':
    if len(sys.argv) != 3 or sys.argv[2] not in ('page', 'bash'):
        sys.exit(__doc__)
    print({'page': manual_page, 'bash': completion}[sys.argv[2]](sys.argv[1]), end='')
