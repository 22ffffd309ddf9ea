#!/usr/bin/env python3
"""The same run from each compiler that is here: one number of all its bits a row, one column a compiler.

    tests/same_bits/table.py [--steps N] [NAME …]     NAMEs of `compilers` below; without: all that are installed

Ends with 1 if two of them differ, or if any of those asked for by name is missing. Nothing of CMake is needed: each
compiles tests/same_bits/same_bits.cpp with the sources of the physics, by the flags that cmake/physics.cmake gives them.
"""
import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path

root = Path(__file__).resolve().parents[2]
build = root / 'build' / 'same_bits'
sources = ['tests/same_bits/same_bits.cpp', 'common/contact.cpp', 'common/elementary.cpp', 'common/measure.cpp',
           'common/eigen_instances.cpp', 'common/scenes.cpp']
sources += sorted(str(source.relative_to(root)) for source in root.glob('chapters/[0-9][0-9]_*/*.cpp')
                  if source.name not in ('small.cpp', 'team.cpp'))
flags = ['-std=c++20', '-DNDEBUG', '-DEIGEN_NO_CPUID', '-ffp-contract=off', '-I.']
threads = ['-pthread']
wasm = ['-fwasm-exceptions', '-msimd128', '-msse2', '-fgnuc-version=6.3', '-Icmake/web/sse', '-include', 'cmake/web/to_chars.hpp',
        '-include', 'cmake/web/no_assembler.hpp', '-DEIGEN_ARCH_DEFAULT_NUMBER_OF_REGISTERS=16', '-DEIGEN_MAX_STATIC_ALIGN_BYTES=16',
        '-DEIGEN_DEFAULT_L1_CACHE_SIZE=32768', '-DEIGEN_DEFAULT_L2_CACHE_SIZE=262144', '-DEIGEN_DEFAULT_L3_CACHE_SIZE=2097152',
        '-sALLOW_MEMORY_GROWTH=1', '-sSINGLE_FILE=1', '-sEXIT_RUNTIME=1']
mingw = ['-static', '-Wa,-mbig-obj']
# name: compiler, its own flags, what it makes, what runs that
compilers = {
    'g++ -O0': ('g++', ['-O0'] + threads, '', []),
    'g++ -O1': ('g++', ['-O1'] + threads, '', []),
    'g++ -O2': ('g++', ['-O2'] + threads, '', []),
    'g++ -O3': ('g++', ['-O3'] + threads, '', []),
    'clang++ -O0': ('clang++', ['-O0'] + threads, '', []),
    'clang++ -O2': ('clang++', ['-O2'] + threads, '', []),
    'em++ -O2': ('em++', ['-O2'] + wasm, '.js', ['node']),
    'mingw -O2': ('x86_64-w64-mingw32-g++-posix', ['-O2'] + mingw, '.exe', ['wine']),
}


def eigen():
    """Where Eigen is; em++ and MinGW don't look there by themselves."""
    for folder in ('/usr/include/eigen3', '/usr/local/include/eigen3', '/opt/homebrew/include/eigen3'):
        if Path(folder).exists():
            return folder
    sys.exit('Eigen is not in one of the usual folders')


def wine():
    return shutil.which('wine') or shutil.which('wine64') or shutil.which('/usr/lib/wine/wine64')


# Wine keeps its settings, and a folder that is a disk, in build/; a window or a sound is not asked for.
surroundings = {**os.environ, 'WINEPREFIX': str(build / 'wine'), 'WINEDEBUG': '-all', 'NODE_PATH': '/usr/share/nodejs'}


def lines_of(name, steps):
    """name → number, or None with a reason."""
    compiler, own, ending, runner = compilers[name]
    if not shutil.which(compiler):
        return None, f'{compiler} is not installed'
    if runner == ['wine']:
        if not wine():
            return None, 'wine is not installed'
        runner = [wine()]
    if runner == ['node'] and '--experimental-wasm-eh' in subprocess.run(['node', '--v8-options'], text=True,
                                                                         capture_output=True).stdout:
        runner = ['node', '--experimental-wasm-eh']  # newer ones need no asking, and refuse it
    build.mkdir(parents=True, exist_ok=True)
    program = build / (name.replace(' ', '').replace('+', 'p') + (ending or '.out'))
    made = subprocess.run([compiler, *flags, *own, f'-I{eigen()}', *sources, '-o', str(program)], cwd=root, text=True,
                          capture_output=True, env=surroundings)
    if made.returncode:
        return None, f'{compiler} ended with {made.returncode}: {made.stderr[-2000:]}'
    done = subprocess.run([*runner, str(program), str(steps)], text=True, capture_output=True, env=surroundings)
    if done.returncode or not done.stdout:
        return None, f'the program of {name} ended with {done.returncode}: {done.stderr[-2000:]}'
    return dict(line.rsplit(' ', 1) for line in done.stdout.split('\n') if line.strip()), ''


options = argparse.ArgumentParser()
options.add_argument('--steps', type=int, default=10000)
options.add_argument('names', nargs='*')
chosen = options.parse_args()
for name in chosen.names:
    if name not in compilers:
        sys.exit(f"there is no compiler '{name}'; there are: {', '.join(compilers)}")

found, failed = {}, False
for name in chosen.names or compilers:
    lines, reason = lines_of(name, chosen.steps)
    if lines is None:
        print(f'{name}: {reason}', file=sys.stderr)
        failed = failed or bool(chosen.names) or 'not installed' not in reason
    else:
        found[name] = lines
if not found:
    sys.exit('no compiler at all')
runs = list(next(iter(found.values())))
print(f'{"":14}' + ''.join(f'{run:18}' for run in runs))
for name, lines in found.items():
    print(f'{name:14}' + ''.join(f'{lines.get(run, "none"):18}' for run in runs))
different = [run for run in runs if len({lines.get(run) for lines in found.values()}) > 1]
print(f'different: {", ".join(different)}' if different else f'the same from all {len(found)}')
sys.exit(1 if failed or different else 0)
