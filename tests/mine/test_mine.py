#!/usr/bin/env python3
"""Tests of mine.py on a small book."""
import contextlib
import io
import pathlib
import tempfile
import unittest

import mine

HEADER = '''#pragma once
/// Half of x. A comment with a brace { and half(3) does not count.
template <class T>
T half(const T& x)
{
    const char* brace = "{";
    if (x > 0) { return x / 2; }
    return half(-x);
}
inline int third(int x,
                 int y)
{
    return x + y;
}
inline int other(int x) { return half(x); }
struct Type {
    int rate() const { return 1; }
};
'''


class Mine(unittest.TestCase):
    def setUp(self):
        self.held = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.held.name)
        self.write("chapters/01_one/half.hpp", HEADER)
        self.write("tests/mine/01.txt", "# comment\nin     chapters/01_one/half.hpp\nempty  half  return x;\nempty  rate  return 0;\n"
                                        "wrong  half is a third\n")
        self.write("tests/mutants/01.txt", "mutant half is a third\nin chapters/01_one/half.hpp\nwas x / 2\nnow x / 3\n")
        self.write("tests/mutants/run.py", (mine.ROOT / "tests/mutants/run.py").read_text())

    def tearDown(self):
        self.held.cleanup()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def call(self, *arguments):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = mine.main(list(arguments), self.root)
        return code, out.getvalue(), err.getvalue()

    def test_the_bodies_are_emptied_and_all_else_stays(self):
        code, out, _ = self.call("1")
        self.assertEqual(code, 0)
        text = (self.root / "mine/chapters/01_one/half.hpp").read_text()
        self.assertIn("T half(const T& x)\n{\n    // Yours: the text and the comment above say what it does.\n    return x;\n}\n", text)
        self.assertIn("inline int other(int x) { return half(x); }", text)
        self.assertIn("int rate() const {\n", text)
        self.assertNotIn("x / 2", text)
        self.assertIn("./book test 1 --mine", out)

    def test_an_emptied_body_stands_under_the_brace_of_the_one_before(self):
        self.write("tests/mine/01.txt", "in chapters/01_one/half.hpp\nempty third return 0;\n")
        self.call("1")
        self.assertIn("int y)\n{\n    // Yours", (self.root / "mine/chapters/01_one/half.hpp").read_text())

    def test_a_class_is_left_out_with_its_comment(self):
        self.write("tests/mine/01.txt", "in chapters/01_one/half.hpp\nempty half return x;\ndrop Type\n")
        self.write("chapters/01_one/half.hpp", HEADER.replace("struct Type", "/// A type.\nstruct Type"))
        self.assertEqual(self.call("1")[0], 0)
        text = (self.root / "mine/chapters/01_one/half.hpp").read_text()
        self.assertNotIn("Type", text)
        self.assertNotIn("A type", text)
        self.assertTrue(text.rstrip().endswith("return half(x); }"), text)

    def test_first_empties_the_first_definition_alone(self):
        self.write("chapters/01_one/half.hpp", HEADER + "inline int other(long x) { return other(static_cast<int>(x)); }\n")
        self.write("tests/mine/01.txt", "in chapters/01_one/half.hpp\nfirst other return 0;\n")
        self.assertEqual(self.call("1")[0], 0)
        text = (self.root / "mine/chapters/01_one/half.hpp").read_text()
        self.assertNotIn("return half(x); }", text)
        self.assertIn("inline int other(long x) { return other(static_cast<int>(x)); }", text)
        self.assertIn("0 of 1 functions begun", self.call()[1])

    def test_a_file_that_is_there_is_kept(self):
        self.write("mine/chapters/01_one/half.hpp", "my own")
        code, out, _ = self.call("1")
        self.assertEqual((code, (self.root / "mine/chapters/01_one/half.hpp").read_text()), (0, "my own"))
        self.assertIn("is kept", out)

    def test_how_far_each_is(self):
        self.assertIn("nothing is begun", self.call()[1])
        self.call("1")
        self.assertIn("0 of 2 functions begun; no test was run yet", self.call()[1])
        path = self.root / "mine/chapters/01_one/half.hpp"
        path.write_text(path.read_text().replace("return x;", "return x / 2;", 1))
        self.write("build/mine/01.result", "3 of 5 idea tests pass\n")
        self.assertIn("1 of 2 functions begun; 3 of 5 idea tests pass", self.call()[1])

    def test_the_books_own_header_comes_whole_or_with_its_fault(self):
        path = self.root / "mine/chapters/01_one/half.hpp"
        self.assertEqual(self.call("1", "--own")[0], 0)
        self.assertEqual(path.read_text(), HEADER)
        self.assertEqual(self.call("1", "--wrong")[::2], (2, "mine: mine/chapters/01_one/half.hpp is there already\n"))
        path.unlink()
        self.assertEqual(self.call("1", "--wrong")[0], 0)
        self.assertEqual(path.read_text(), HEADER.replace("return x / 2;", "return (x / 3);"))
        self.write("tests/mutants/01.txt", "mutant another\nin chapters/01_one/half.hpp\nwas x / 2\nnow x / 3\n")
        self.assertEqual(self.call("--check")[::2], (
            2, "mine: 01.txt: tests/mutants/01.txt has no mutant 'half is a third' in one of these headers\n"))

    def test_what_cannot_be_done_gets_one_sentence(self):
        self.assertEqual(self.call("7")[::2], (2, "mine: chapter 7 has no header to write yourself; these have: 1\n"))
        self.write("tests/mine/01.txt", "in chapters/01_one/half.hpp\nempty fourth return 0;\n")
        for arguments in (("1",), ("--check",)):
            self.assertEqual(self.call(*arguments)[::2], (2, "mine: chapters/01_one/half.hpp has no definition of fourth()\n"))
        self.write("tests/mine/01.txt", "empty half return 0;\n")
        self.assertEqual(self.call("--check")[0], 2)

    def test_the_lists_of_the_book_fit_its_headers(self):
        self.assertEqual(mine.main(["--check"]), 0)


if __name__ == "__main__":
    unittest.main()
