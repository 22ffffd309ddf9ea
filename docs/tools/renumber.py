#!/usr/bin/env python3
"""Gives chapters other numbers, everywhere at once: folders, files, links, sections, equations, figures, labels.

    renumber.py 15=16 16=17           chapters move; 16 moves before 15 takes its place
    renumber.py --labels moved.txt    sections, equations, figures move from one chapter to another

A line of moved.txt names a kind, the old number and the new one:  section 14.4 15.1 · equation 14.8 15.2 · figure 14.3 15.1 ·
algorithm, table, exercise likewise. A section's link follows it into the file that has it now, so the text is moved first.
Names of files and folders may follow: only those are changed. Afterwards docs/build.sh check says what dangles, stands twice or is out of order. Numbers that words spell are not found."""
import re
import subprocess
import sys
from pathlib import Path

root = Path(__file__).resolve().parents[2]
no_text = {'.svg', '.png', '.gif', '.mlcp', '.csv', '.bib', '.webp', '.h'}
number = r'\d{1,2}'


def tracked():
    names = subprocess.run(['git', 'ls-files', '-z'], cwd=root, capture_output=True, text=True, check=True).stdout
    return [root / name for name in names.split('\0') if name]


class Renumbering:
    def __init__(self, chapters, labels=None):
        self.chapters = chapters
        self.labels = labels or {}    # (kind, 'N.M') -> 'N.M'
        some = '|'.join(str(n) for n in sorted({*chapters, *(int(old.split('.')[0]) for _, old in self.labels)}, reverse=True))
        # what folders and files are called behind their numbers; the longest first
        self.named = {m[0] for path in tracked() for part in path.relative_to(root).parts
                      for m in [re.match(r'\d\d_[a-z_]+', part)] if m and int(part[:2]) in chapters}
        names = '|'.join(sorted(self.named, key=lambda name: (-len(name), name))) or '(?!)'
        kinds = r'[Ss]ections?|[Ff]igures?|[Tt]ables?|[Aa]lgorithms?|[Ee]xercises?|[Ee]quations?'
        label = rf'(?:{some})\.(?:\d+[a-z]?|[A-Z])'
        one = rf'{number}\.(?:\d+[a-z]?|[A-Z])'
        joint = r'(?:,? and |,? or | to |, |–| · )'
        self.pattern = re.compile('|'.join([
            rf'(?P<folder>(?<![\dA-Za-z])(?:{names})(?![a-z0-9]))',
            rf'(?P<listing>(?<=tests/)(?:mine|mutants)/(?:{some})\.txt)',
            rf'(?P<equation>\((?:{some})\.\d+[a-z]?\))',
            rf'(?P<tag>\\tag\{{(?:{some})\.\d+[a-z]?\}})',
            rf'(?P<listed>\b(?:{kinds})[ \u00a0]{one}(?:{joint}{one})*)',
            rf'(?P<heading>^#+ (?:{label})(?= ))',
            rf'(?P<letter>(?<![\w.])(?:{some})\.[A-Z](?![\w]))',
            rf'(?P<linked>\[(?:{label})\](?=\())',
            rf'(?P<listed_chapter>\[(?:{some})(?=\. [A-Z][^\]]*\]\())',
            rf'(?P<anchor>#(?:{some})(?:\d{{1,2}}|[a-z])-(?=[a-z0-9]))',
            rf'(?P<chapter>\b[Cc]hapters?[ \u00a0]{number}\b(?!\.\d)(?:{joint}{number}\b(?!\.\d))*)',
            rf'(?P<short>\bch(?:{some})(?=[_" :)]))',
            rf'(?P<command>(?:\./)?book (?:run|test|small|mine|bench|mutants) (?:{some})\b)',
            rf'(?P<small>\bsmall(?:[ \u00a0]program[ \u00a0])?(?:{some})\b)',
            rf'(?P<part>\brigid_(?:chapter|tested|plain|optimised)(?:_up_to)?_(?:{some})\b)',
        ]), re.M)

    def chapter(self, old):
        return self.chapters.get(int(old), int(old))

    def label(self, kind, old):
        if (kind, old) in self.labels:
            return self.labels[kind, old]
        # 17.4b goes with 17.4
        base = re.match(r'(\d+\.\d+)([a-z])$', old)
        if base and (kind, base[1]) in self.labels:
            return self.labels[kind, base[1]] + base[2]
        of, rest = old.split('.', 1)
        return f'{self.chapter(of)}.{rest}'

    def replace(self, found):
        kind, text = found.lastgroup, found[0]
        if kind == 'folder':
            return f'{self.chapter(text[:2]):02}{text[2:]}'
        if kind == 'listing':
            return re.sub(r'\d+', lambda m: f'{self.chapter(m[0]):02}', text)
        if kind == 'equation':
            return f'({self.label("equation", text[1:-1])})'
        if kind == 'tag':
            return f'\\tag{{{self.label("equation", text[5:-1])}}}'
        if kind == 'listed':
            what = re.match(r'[a-z]+?(?=s?\b)', text.lower())[0]
            return re.sub(rf'{number}\.(?:\d+[a-z]?|[A-Z])', lambda m: self.label(what, m[0]), text)
        if kind == 'heading':
            hashes, old = text.split(' ')
            return f'{hashes} {self.label("section", old)}'
        if kind in ('letter',):
            return self.label('section', text)
        if kind == 'linked':
            return f'[{self.label("section", text[1:-1])}]'
        if kind == 'listed_chapter':
            return f'[{self.chapter(text[1:])}'
        if kind == 'anchor':
            old = re.match(r'#(\d\d)(\w+)-', text)
            # '#174-': section 19.4, but '#11…' of chapter 1 never comes here with a number of two digits that moves
            now = self.label('section', f'{old[1]}.{old[2].upper() if old[2].isalpha() else old[2]}')
            return '#' + now.replace('.', '').lower() + '-'
        if kind == 'chapter':
            return re.sub(rf'\b{number}\b', lambda m: str(self.chapter(m[0])), text)
        if kind == 'short':
            return f'ch{self.chapter(text[2:]):02}'
        if kind in ('command', 'small', 'part'):
            return re.sub(rf'(\d+)$', lambda m: f'{self.chapter(m[0]):0{len(m[0])}}', text)
        raise AssertionError(kind)

    def text(self, old):
        return self.pattern.sub(self.replace, old)

    def path(self, old):
        """Of a file below the root: folders, tests/15_name.cpp, figures/ch16_name.svg, tests/mine/16.txt."""
        parts = []
        for part in old.parts:
            m = re.match(rf'({number})(_.*|\.txt)$', part)
            if m and len(m[1]) == 2 and int(m[1]) in self.chapters:
                part = f'{self.chapter(m[1]):02}{m[2]}'
            part = re.sub(r'^ch(\d\d)_', lambda n: f'ch{self.chapter(n[1]):02}_', part)
            parts.append(part)
        return Path(*parts)


def renumber_column(path, it):
    """The column `chapter` of a table."""
    lines = path.read_text().split('\n')
    heads = lines[0].split(',')
    if 'chapter' not in heads:
        return
    at = heads.index('chapter')
    for i, line in enumerate(lines[1:], 1):
        cells = line.split(',', at + 1)    # what stands before it holds no comma
        if len(cells) > at and cells[at].isdigit():
            cells[at] = str(it.chapter(cells[at]))
            lines[i] = ','.join(cells)
    path.write_text('\n'.join(lines))


def main(arguments):
    labels = {}
    if '--labels' in arguments:
        at = arguments.index('--labels')
        for line in Path(arguments[at + 1]).read_text().splitlines():
            if line.strip() and not line.startswith('#'):
                kind, old, new = line.split()
                labels[kind, old] = new
        del arguments[at:at + 2]
    chapters = {}
    only = []
    for argument in arguments:
        if '=' in argument:
            old, new = argument.split('=')
            chapters[int(old)] = int(new)
        else:
            only.append(argument)
    if len(set(chapters.values())) != len(chapters):
        sys.exit('two chapters would have the same number')
    if not chapters and not labels:
        sys.exit(__doc__)
    it = Renumbering(chapters, labels)
    moves = []
    for path in tracked():
        if only and not any(str(path.relative_to(root)).startswith(o) for o in only):
            continue
        if path.suffix == '.csv':
            renumber_column(path, it)
        if path.suffix not in no_text and path.exists() and not path.is_symlink():
            try:
                old = path.read_text()
            except UnicodeDecodeError:
                continue
            new = it.text(old)
            if new != old:
                path.write_text(new)    # keeps its mode
        now = it.path(path.relative_to(root))
        if root / now != path:
            moves.append((path, root / now))
    for old, _ in moves:    # first aside: 15 -> 16 must not meet the old 16
        aside = old.with_name(old.name + '.moving')
        old.rename(aside)
    for old, new in moves:
        new.parent.mkdir(parents=True, exist_ok=True)
        old.with_name(old.name + '.moving').rename(new)
    for old, _ in moves:
        folder = old.parent
        while folder != root and folder.exists() and not any(folder.iterdir()):
            folder.rmdir()
            folder = folder.parent
    print(f'{len(moves)} files moved')


if __name__ == '__main__':
    main(sys.argv[1:])
