#!/usr/bin/env python3
"""check_commands.py BIN: runs what the texts tell the reader to type.

Every command line of a text that starts a program (in a `sh` block, or between backticks from `--scene` on) is run
with the programs of the folder BIN in a scratch folder, for one step: as it stands and without a display, as it
stands and with a window where xvfb-run is installed, and with --headless. A command that only lists or solves
(--help, --list-scenes, --problem, --wav) is run once. So is each demo that a text places. Says file, line and the program's own sentence for each that ends
with another exit code than 0.
"""
import argparse
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile

from booktext import ROOT, TextError, book_folder, run_tool
from demos import demos_of

ELLIPSIS = re.compile(r'…|\b(NAME|FILE|DIR|VALUE)\b')
INLINE = re.compile(r'`(--scene [^`]+)`')
ONCE = {'--problem', '--help', '--list-scenes', '--wav'}
PATIENCE = 120  # s; one step of the slowest scene takes a few


def program(root, number):
    for folder in root.glob(f'chapters/{int(number):02d}_*'):
        return folder.name
    raise TextError(f'there is no chapter {number}')


def commands(root, path, text):
    """(line number, program, arguments) of each command that the text at `path` shows."""
    own = path.parent.name if re.match(r'\d\d_', path.parent.name) else None
    fence, begun = None, ''
    for number, line in enumerate(text.splitlines(), 1):
        if fence == 'sh' and line.endswith('\\'):  # the command goes on in the next line
            begun += line[:-1]
            continue
        line, begun = begun + line, ''
        mark = re.match(r'\s*```(\w*)', line)
        if mark:
            fence = mark.group(1) if fence is None else None
            continue
        where = f'{path.relative_to(root)}:{number}'
        try:
            if fence == 'sh':
                words = shlex.split(line, comments=True)
                if words[:2] == ['./book', 'run'] and len(words) > 2 and words[2].isdigit():
                    yield number, program(root, words[2]), words[3:]
                elif words[:2] == ['./book', 'run']:  # without a number: the ten discs of chapter 4
                    yield number, program(root, 4), ['--scene', 'ten_discs', *words[2:]]
                elif words and words[0].startswith('build/release/bin/'):
                    yield number, pathlib.Path(words[0]).name, words[1:]
            elif fence is None and own:
                for found in INLINE.finditer(line):
                    yield number, own, shlex.split(found.group(1))
        except (ValueError, TextError) as fault:
            raise TextError(f'{where}: {fault}') from fault


def demo_commands(root, path):
    """The same of each demo that the text places (docs/tools/demos.py), and of its idea turned off."""
    for demo in demos_of(root, path):
        off = demo['break'] or {'methods': [], 'settings': {}}
        for methods, settings in ((demo['methods'], demo['settings']),
                                  (off['methods'] or demo['methods'], {**demo['settings'], **off['settings']})):
            words = ['--scene', demo['scene'], '--headless']
            if methods:
                words += ['--method', ','.join(methods)]
            for name, value in settings.items():
                words += ['--h', f'{value:.17g}'] if name == 'h' else ['--set', f'{name}={value:.17g}']
            yield int(demo['where'].split(':')[-1]), demo['program'], words
            if not demo['break']:
                break


def without(arguments, options, flags=()):
    """The arguments less those options, which take a value each, and less those flags."""
    kept, skip = [], False
    for word in arguments:
        if skip:
            skip = False
        elif word in options:
            skip = True
        elif word not in flags and word.partition('=')[0] not in options:
            kept.append(word)
    return kept


def ways(arguments, has_display):
    """How a command is tried: (what it is called, arguments, whether with a display)."""
    if ONCE & {word.partition('=')[0] for word in arguments}:
        return [('', arguments, False)]
    one_step = [*without(arguments, {'--steps'}), '--steps', '1']
    silent = [*without(arguments, {'--steps', '--csv', '--svg', '--png', '--record', '--every'}, {'--headless'}),
              '--headless', '--steps', '1']
    found = [('as it stands, without a display', one_step, False), ('with --headless', silent, False)]
    if has_display and '--headless' not in arguments:
        found.append(('in a window', one_step, True))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n\n')[0])
    parser.add_argument('programs', type=pathlib.Path, help='the folder of the programs')
    parser.add_argument('--root', type=pathlib.Path, default=ROOT, help="the book's folder")
    options = parser.parse_args()
    programs, root = options.programs.resolve(), book_folder(options.root)
    if not programs.is_dir():
        raise TextError(f'{programs} is no folder')
    texts = [root / 'README.md', *sorted(root.glob('docs/*.md')), *sorted(root.glob('chapters/*/*.md'))]
    no_display = {k: v for k, v in os.environ.items() if k not in ('DISPLAY', 'WAYLAND_DISPLAY')}
    xvfb = shutil.which('xvfb-run')
    faults = run = 0
    for path in texts:
        shown = [*commands(root, path, path.read_text(encoding='utf-8')), *demo_commands(root, path)]
        for number, name, arguments in shown:
            if ELLIPSIS.search(' '.join(arguments)) or 'benchmark' in name:
                continue
            # A file of the book is named as from the book's folder; a scene "book" is no file.
            arguments = [str(root / word) if '/' in word and (root / word).is_file() else word for word in arguments]
            for way, words, display in ways(arguments, xvfb is not None):
                words = [str(programs / name), *words]
                if display:
                    words = [xvfb, '-a', *words]
                with tempfile.TemporaryDirectory() as scratch:
                    try:
                        done = subprocess.run(words, cwd=scratch, env=no_display, capture_output=True, text=True,
                                              timeout=PATIENCE, stdin=subprocess.DEVNULL)
                        code, said = done.returncode, done.stderr.strip()
                    except subprocess.TimeoutExpired:
                        code, said = 'none', f'it did not end within {PATIENCE} s'
                    except OSError as fault:
                        code, said = 'none', fault.strerror
                run += 1
                if code != 0:
                    faults += 1
                    print(f'{path.relative_to(root)}:{number}: {name} {shlex.join(arguments)}'
                          f'{f" ({way})" if way else ""}: exit code {code}: {said}')
    print(f'{run} runs of the commands of the texts, {faults} of them failed')
    if xvfb is None:
        print('xvfb-run is not installed: no window was opened')
    return 1 if faults or not run else 0


if __name__ == '__main__':
    run_tool(main)
