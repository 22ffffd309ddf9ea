#!/usr/bin/env python3
"""check_limits.py BIN [PROGRAM …]: every scene takes the limits that --help prints for it.

Runs each scene of the book's programs in the folder BIN (or of those named) for one step at the least and the
greatest time step, and with each tunable at either end of its range. Says program, scene, option and the program's
own sentence for each that ends with another exit code than 0; a scene may refuse (2) a limit that does not go with
the other tunables, the command line may not.
"""
import argparse
import pathlib
import re
import subprocess

from booktext import ROOT, TextError, book_folder, chapters, run_tool

PATIENCE = 120  # s; the largest scene at its finest takes a few


def limits(help_text):
    """(scene, option, value) of each limit in the output of --help."""
    scene = None
    for line in help_text.splitlines():
        named = re.match(r'  ([\w-]+): ', line)
        scene = named.group(1) if named else scene
        step = re.match(r'    --h .*, between (\S+) and (\S+) s$', line)
        tunable = re.match(r'    --set ([\w-]+)=.*between (\S+) and (\S+?)(;| |$)', line)
        if step:
            yield from ((scene, '--h', value) for value in step.groups())
        if tunable:
            yield from ((scene, '--set', f'{tunable.group(1)}={value}') for value in tunable.group(2, 3))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n\n')[0])
    parser.add_argument('programs', type=pathlib.Path, help='the folder of the programs')
    parser.add_argument('names', nargs='*', metavar='PROGRAM', help='which of them; all chapters')
    options = parser.parse_args()
    names = options.names or [folder.name for folder in chapters(book_folder(ROOT)).values()]
    faults = run = 0
    for name in names:
        file = options.programs.resolve() / name
        if not file.is_file():
            raise TextError(f'{file} is no file')
        help_text = subprocess.run([file, '--help'], capture_output=True, text=True, timeout=PATIENCE).stdout
        for scene, option, value in limits(help_text):
            words = [file, '--headless', '--scene', scene, '--steps', '1', '--csv', '-', option, value]
            try:
                done = subprocess.run(words, capture_output=True, text=True, timeout=PATIENCE, stdin=subprocess.DEVNULL)
                code, said = done.returncode, done.stderr.strip()
            except subprocess.TimeoutExpired:
                code, said = 'none', f'it did not end within {PATIENCE} s'
            run += 1
            if code != 0 and not (code == 2 and not said.startswith(('the time step --h', 'the tunable '))):
                faults += 1
                print(f'{name} --scene {scene} {option} {value}: exit code {code}: {said}')
    print(f'{run} limits tried, {faults} of them refused')
    return 1 if faults or not run else 0


if __name__ == '__main__':
    run_tool(main)
