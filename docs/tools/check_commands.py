#!/usr/bin/env python3
"""check_commands.py BIN: runs what the texts tell the reader to type.

Every command line of a text that starts a program (in a `sh` block, or between backticks from `--scene` on) is run
with the programs of the folder BIN, for three steps and without a window. Says file, line and the program's own
sentence for each that ends with another exit code than 0 (or, where the text says that a run can't go on, 3).
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
ELLIPSIS = re.compile(r'…|\b(NAME|FILE|DIR|VALUE)\b')
INLINE = re.compile(r'`(--scene [^`]+)`')


def program(number):
    folder = next(ROOT.glob(f'chapters/{int(number):02d}_*'))
    return folder.name


def commands(path, text):
    """(line number, program, arguments) of each command that the text at `path` shows."""
    own = path.parent.name if re.match(r'\d\d_', path.parent.name) else None
    fence = None
    for number, line in enumerate(text.splitlines(), 1):
        mark = re.match(r'\s*```(\w*)', line)
        if mark:
            fence = mark.group(1) if fence is None else None
            continue
        if fence == 'sh':
            words = shlex.split(line, comments=True)
            if len(words) > 2 and words[:2] == ['./book', 'run'] and words[2].isdigit():
                yield number, program(words[2]), words[3:]
            elif words and words[0].startswith('build/release/bin/'):
                yield number, pathlib.Path(words[0]).name, words[1:]
        elif fence is None and own:
            for found in INLINE.finditer(line):
                yield number, own, shlex.split(found.group(1))


def without(arguments, options):
    """The arguments less those options, which take a value each, and less flags that end a run at once."""
    kept, skip = [], False
    for word in arguments:
        if skip:
            skip = False
        elif word in options:
            skip = True
        elif word != '--headless':
            kept.append(word)
    return kept


def main():
    programs = pathlib.Path(sys.argv[1]).resolve()
    texts = [ROOT / 'README.md', *ROOT.glob('docs/*.md'), *sorted(ROOT.glob('chapters/*/README.md'))]
    faults = run = 0
    with tempfile.TemporaryDirectory() as scratch:
        for path in texts:
            for number, name, arguments in commands(path, path.read_text(encoding='utf-8')):
                if ELLIPSIS.search(' '.join(arguments)) or 'benchmark' in name:
                    continue
                words = [str(programs / name), *arguments]
                if not {'--problem', '--help', '--list-scenes'} & set(arguments):
                    words = [str(programs / name), *without(arguments, {'--steps', '--csv', '--svg', '--png',
                                                                         '--record', '--every'}),
                             '--headless', '--steps', '3']
                else:
                    words = [str(ROOT / word) if (ROOT / word).is_file() else word for word in words]
                done = subprocess.run(words, cwd=scratch, capture_output=True, text=True, timeout=120)
                run += 1
                if done.returncode not in (0, 3):
                    faults += 1
                    print(f'{path.relative_to(ROOT)}:{number}: {name} {shlex.join(arguments)}: '
                          f'exit code {done.returncode}: {done.stderr.strip()}')
    print(f'{run} commands of the texts run, {faults} of them refused')
    return 1 if faults or not run else 0


if __name__ == '__main__':
    sys.exit(main())
