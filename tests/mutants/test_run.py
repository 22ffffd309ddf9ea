#!/usr/bin/env python3
"""Tests of run.py: each fault of a list is one sentence, and a mutant becomes a choice."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import run  # noqa: E402

TEXT = """constexpr double limit = 1e-8;
if (a < limit) return b + c;
count = 0;
x = y; x = y;
"""


def mutant(number=1, **fields):
    fields = {"in" if key == "file" else "as" if key == "how" else key: value for key, value in fields.items()}
    return run.Mutant(number, "m", "00.txt:1", {"in": "f.hpp"} | fields)


def read(text):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "04.txt"
        path.write_text(text, encoding="utf-8")
        return run.read_list(path)


class Lists(unittest.TestCase):
    def refused(self, sentence, call):
        with self.assertRaisesRegex(run.ListError, sentence):
            call()

    def test_an_expression_becomes_a_choice(self):
        text = run.mutated(TEXT, [mutant(7, was="a < limit", now="a <= limit")])
        self.assertIn("if ((::rigid_mutant(7) ? (a <= limit) : (a < limit))) return", text)

    def test_two_faults_of_one_expression_are_a_chain(self):
        text = run.mutated(TEXT, [mutant(7, was="b + c", now="b"), mutant(8, was="b + c", now="c")])
        self.assertIn("return (::rigid_mutant(7) ? (b) : ::rigid_mutant(8) ? (c) : (b + c));", text)

    def test_a_statement_is_left_out_by_an_if(self):
        text = run.mutated(TEXT, [mutant(3, was="count = 0;", now="", how="statement")])
        self.assertIn("if (::rigid_mutant(3)) {  } else { count = 0; }", text)

    def test_a_constant_that_is_chosen_is_no_constexpr(self):
        text = run.mutated(TEXT, [mutant(2, was="1e-8", now="0.0")])
        self.assertTrue(text.startswith("const double limit = (::rigid_mutant(2) ? (0.0) : (1e-8));"))

    def test_a_mutant_without_a_place_or_with_two_is_an_error(self):
        self.refused("'d' 0 times; it must be there once", lambda: run.mutated("abc", [mutant(was="d", now="e")]))
        self.refused("'x = y' 2 times", lambda: run.mutated(TEXT, [mutant(was="x = y", now="0")]))
        self.refused("'b' 2 times", lambda: run.mutated("a b b", [mutant(at="a b b", was="b", now="c")]))

    def test_mutants_that_overlap_are_an_error(self):
        self.refused("overlaps", lambda: run.mutated(TEXT, [mutant(was="b + c", now="b"), mutant(2, was="b", at="b + c", now="c")]))

    def test_a_list_that_makes_no_sense_is_an_error(self):
        self.refused("04.txt:1: 'was' stands before", lambda: read("was x"))
        self.refused("04.txt:1: 'a' has no line 'now'", lambda: read("mutant a\nin f\nwas x"))
        self.refused("04.txt:2: 'where' is none of", lambda: read("mutant a\nwhere f"))
        self.refused("two mutants 'a'", lambda: read("mutant a\nin f\nwas x\nnow y\nmutant a\nin f\nwas x\nnow y"))
        self.refused("two lines 'in'", lambda: read("mutant a\nin f\nin f"))
        self.refused("'f[(]x' has brackets", lambda: read("mutant a\nin f\nwas f(x\nnow y"))
        self.refused("'x = y;' is a statement", lambda: read("mutant a\nin f\nwas x = y;\nnow y"))
        self.refused("'x ||' ends in", lambda: read("mutant a\nin f\nwas x ||\nnow y"))
        self.refused("'x' is no statement", lambda: read("mutant a\nin f\nwas x\nnow\nas statement"))
        self.refused("as can only be", lambda: read("mutant a\nin f\nwas x\nnow y\nas line"))

    def test_a_list_is_read_with_its_numbers(self):
        mutants = read("# a comment\n\nmutant a b\nin f\nwas x  y;\nnow\nas statement\nmutant c\nin f\nwas z\nnow 1\nequal so")
        self.assertEqual([m.number for m in mutants], [1, 2])
        self.assertEqual((mutants[0].name, mutants[0].was, mutants[0].now), ("a b", "x  y;", ""))
        self.assertEqual((mutants[1].file, mutants[1].equal), ("f", "so"))


class Runs(unittest.TestCase):
    """What a test executable can do, by a shell script in its place."""

    def outcome(self, script, number=0, seconds=5):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "test"
            program.write_text("#!/bin/sh\necho '<TestCase name=\"it &lt; it\">'\n" + script, encoding="utf-8")
            program.chmod(0o755)
            return run.run_tests(program, number, seconds)

    def test_each_end_has_its_name(self):
        self.assertEqual(self.outcome("exit 0"), ("passed", "it < it"))
        self.assertEqual(self.outcome("exit 3"), ("failed", "it < it"))
        self.assertEqual(self.outcome("kill -SEGV $$"), ("crashed", "it < it"))
        self.assertEqual(self.outcome("exec sleep 60", seconds=0.2), ("out of time", "it < it"))
        self.assertEqual(self.outcome("exec yes")[0], "too much output")

    def test_the_mutant_is_in_the_environment(self):
        self.assertEqual(self.outcome('exit "$RIGID_MUTANT"', 0)[0], "passed")
        self.assertEqual(self.outcome('exit "$RIGID_MUTANT"', 7)[0], "failed")


class Book(unittest.TestCase):
    def test_every_mutant_has_its_place_in_the_sources_and_each_list_has_a_test(self):
        check = subprocess.run([sys.executable, pathlib.Path(run.__file__), "--check"], stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(check.returncode, 0, check.stdout)
        for path in run.LISTS.glob("*.txt"):
            self.assertTrue(run.chapter_of(path).startswith("test_"))

    def test_each_chapter_has_eight_mutants_or_more(self):
        for folder in sorted((run.ROOT / "chapters").glob("[0-9][0-9]_*")):
            path = run.LISTS / f"{folder.name[:2]}.txt"
            self.assertTrue(path.is_file(), f"{folder.name} has no list of mutants")
            self.assertGreaterEqual(len(run.read_list(path)), 8, path.name)


if __name__ == "__main__":
    unittest.main()
