#!/usr/bin/env python3
"""Tests of the hand-outs: each compiles (test_small and the tests "… compiles alone" are for what the programs include), and the book's own bodies fit its holes.

    test_holes.py COMPILER OPTIONS…
"""
import concurrent.futures
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import holes  # noqa: E402

COMPILER = []
PARTS = min(4, os.cpu_count() or 1)


def programs():
    return {number: folder / "small.cpp" for number, folder in holes.chapters(holes.ROOT).items() if (folder / "small.cpp").is_file()}


class Holes(unittest.TestCase):
    maxDiff = None

    def test_each_small_program_has_a_line_and_its_own_bodies_fit(self):
        self.assertGreater(len(programs()), 10)
        for number, path in programs().items():
            with self.subTest(chapter=number):
                functions = holes.listed(holes.ROOT, number)
                text, given = path.read_text(encoding="utf-8"), holes.hand_out(path, functions)
                self.assertEqual(given.count(holes.BEGIN), len(functions))
                self.assertNotEqual(given, text)
                self.assertEqual(holes.filled(path, functions, given), text)
                for _, _, body, _ in holes.bodies(path, functions):
                    self.assertGreater(len(body), 0)
                    self.assertNotIn("\n".join(body), given)

    def test_each_hand_out_compiles(self):
        if not COMPILER:
            self.skipTest("no compiler was named")
        with tempfile.TemporaryDirectory() as folder:
            every = list(programs().items())
            includes = {line for _, path in every for line in path.read_text(encoding="utf-8").splitlines()
                        if line.startswith("#include <")}

            def compiled(part):  # many to a source: Eigen is read once
                source = [*sorted(includes), "#define main small_main"]
                for number, path in every[part::PARTS]:
                    file = pathlib.Path(folder) / f"hand_out_{number:02d}.cpp"
                    file.write_text(holes.hand_out(path, holes.listed(holes.ROOT, number)), encoding="utf-8")
                    source += [f"namespace small{number:02d} {{", f'#include "{file.name}"', "}"]
                together = pathlib.Path(folder) / f"part_{part}.cpp"
                together.write_text("\n".join([*source, ""]), encoding="utf-8")
                # a main needs no return, and here none is called so
                done = subprocess.run([*COMPILER, "-std=c++20", "-Wno-return-type", "-fsyntax-only", str(together)],
                                      capture_output=True, text=True, check=False)
                return done.returncode, done.stderr

            with concurrent.futures.ThreadPoolExecutor() as pool:
                self.assertEqual(list(pool.map(compiled, range(PARTS))), PARTS * [(0, "")])

    def test_what_is_not_there_is_refused(self):
        path = programs()[4]
        for wrong, words in ((lambda: holes.hand_out(path, ["gone"]), "has no functions 'gone\\(\\)'"),
                             (lambda: holes.program_of(holes.ROOT, 99), "chapter 99 has no small program"),
                             (lambda: holes.listed(holes.ROOT, 99), "no line for chapter 99"),
                             (lambda: holes.filled(path, ["pgs"], "int main() {}\n"), "the hole 1 has no beginning")):
            with self.assertRaisesRegex(holes.TextError, words):
                wrong()


if __name__ == "__main__":
    COMPILER = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])
