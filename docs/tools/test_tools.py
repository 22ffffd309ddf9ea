#!/usr/bin/env python3
"""Tests of the tools: each check notices the fault that it is for, and nothing else.

    docs/build.sh test
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import check_commands  # noqa: E402
import check_html  # noqa: E402
import check_text  # noqa: E402
import check_version  # noqa: E402
import demos  # noqa: E402
import finish_html  # noqa: E402
import make_index  # noqa: E402
import print_pages  # noqa: E402
import put_table  # noqa: E402
import redirects  # noqa: E402
import renumber  # noqa: E402
import search_texts  # noqa: E402
import sentences  # noqa: E402
from finish_html import finish  # noqa: E402
import site_address  # noqa: E402
import sync_snippets  # noqa: E402
from booktext import TextError, blocks, comments, slug, test_names, tokens  # noqa: E402
from doxygen_filter import Book, Page, source_text, test_text, unpacked  # noqa: E402

ONE = """# Chapter 1. Euler integration

[Contents](../../README.md) · [Next: constraints](../02_constraints/README.md)

**The one idea: swap two lines.**

![A picture of a spring.](figures/ch01_spring.svg)

**Figure 1.1.** A spring, by (1.2).

## 1.1 From Newton's law to a step

A price of $5 and one of $6, $x_n$, `f(1.9)`, f(1.9) and h (0.05 s) are no equations; (1.1) is one.

```math
a_n = f(x_n) \\tag{1.1}
```

<!-- snippet: step.hpp step -->
<!-- /snippet -->

```math
\\begin{aligned} x &= 1, \\\\ y &= 2 \\end{aligned} \\tag{1.2}
```

## 1.2 Sources

See [[known2000]](../../docs/references.bib), [section 1.1](#11-from-newtons-law-to-a-step) and Figure 1.1.
`it steps by (1.1)` in `tests/01_euler.cpp` holds it.

| a | $\\lvert x \\rvert$ |
|---|---|
| 1 | `b` |

<details>
<summary>Solution</summary>

Text.

</details>

[Contents](../../README.md) · [Next: constraints](../02_constraints/README.md)
"""

TWO = """# Chapter 2. Constraints

[Contents](../../README.md) · [Back: Euler](../01_euler/README.md)

## 2.1 Start

By (1.2), see [the step](../01_euler/README.md#11-from-newtons-law-to-a-step).

```math
C = 0 \\tag{2.1}
```

[Contents](../../README.md) · [Back: Euler](../01_euler/README.md)
"""

STEP = """/// \\file step.hpp
/// The step (1.2).
#pragma once
namespace rigid {
//! [step]
/// One step of (1.1). \\cite known2000
    inline int step(int x)
    {
        return x + 1;  // (1.1): forward; (0.5), (1.0) and f(1.7) are numbers
    }
//! [step]
}  // namespace rigid
"""

TESTS = """#include "catch.hpp"
TEST_CASE("it steps by (1.1)", "[ch01]") { CHECK(step(1) == 2); }
"""


class Folder(unittest.TestCase):
    """A small book without faults, in a folder of its own."""

    def setUp(self):
        self.held = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.held.name).resolve()
        self.write("README.md", "# Book\n\n[One](chapters/01_euler/README.md)\n")
        self.write("docs/references.bib", "@book{known2000,\n title = {T}\n}\n")
        self.write("chapters/01_euler/README.md", ONE)
        self.write("chapters/01_euler/step.hpp", STEP)
        self.write("chapters/01_euler/figures/ch01_spring.svg", "<svg><text>theory (1.2)</text></svg>\n")
        self.write("chapters/02_constraints/README.md", TWO)
        self.write("tests/01_euler.cpp", TESTS)
        sync_snippets.run(self.root, check=False)

    def tearDown(self):
        self.held.cleanup()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def read(self, name):
        return (self.root / name).read_text(encoding="utf-8")

    def change(self, name, old, new):
        text = self.read(name)
        self.assertIn(old, text)
        self.write(name, text.replace(old, new, 1))

    def add(self, words, name="chapters/01_euler/README.md"):
        """Appends words to a text; to a chapter, before the line of links at its end."""
        body, links = self.read(name), ""
        if (at := body.rfind("\n[Contents](")) > 0:
            body, links = body[:at], body[at:]
        self.write(name, body + "\n" + words + "\n" + links)

    def faults(self):
        return check_text.Checker(self.root).run()

    def fails(self, *words):
        """Exactly one fault, and its sentence has these words."""
        found = self.faults()
        self.assertEqual(len(found), 1, found)
        self.assertRegex(found[0], r"^[\w./-]+:\d+: .*\.$")
        for word in words:
            self.assertIn(word, found[0])


class Text(Folder):
    def test_a_book_without_faults_passes(self):
        self.assertEqual(self.faults(), [])

    def test_a_broken_link(self):
        self.add("See [that](nothing.md).")
        self.fails("chapters/01_euler/README.md:", "nothing.md leads to nothing")

    def test_a_link_out_of_the_book(self):
        self.add("See [that](../../../etc).")
        self.fails("out of the book")

    def test_a_broken_anchor(self):
        self.add("See [that](../02_constraints/README.md#29-nowhere).")
        self.fails("no heading '#29-nowhere'")

    def test_a_missing_picture(self):
        self.change("chapters/01_euler/README.md", "ch01_spring.svg", "ch01_gone.svg")
        found = "\n".join(self.faults())
        self.assertIn("ch01_gone.svg leads to nothing", found)
        self.assertIn("ch01_spring.svg:1: this picture is not shown", found)

    def test_a_picture_from_elsewhere(self):
        self.change("README.md", "[One]", "![x](https://example.org/x.png) [One]")
        self.fails("fetched from elsewhere")

    ROOMS = """<picture>
  <source media="(prefers-reduced-motion: reduce)" srcset="docs/still.svg">
  <source media="(prefers-color-scheme: dark)" srcset="docs/dark.gif">
  <img alt="A spring that moves" src="docs/light.gif" width="640">
</picture>"""

    def test_a_picture_for_light_and_dark_rooms(self):
        for file in ("still.svg", "dark.gif", "light.gif"):
            self.write(f"docs/{file}", "")
        self.add(self.ROOMS, "README.md")
        self.assertEqual(self.faults(), [])
        for file in ("still.svg", "dark.gif", "light.gif"):
            self.change("README.md", file, f"gone_{file}")
            self.fails(f"the picture docs/gone_{file} leads to nothing")
            self.change("README.md", f"gone_{file}", file)
        self.change("README.md", "(prefers-reduced-motion: reduce)", "(print)")
        self.fails('<source media="(prefers-reduced-motion: reduce)"')

    def test_a_picture_for_rooms_has_two_images_on_the_site_and_the_switch_chooses(self):
        self.add(self.ROOMS, "README.md")
        page = unpacked(Page(Book(self.root), self.root / "README.md").text())
        for name in ("light", "dark"):
            self.assertIn(f'<picture class="room-{name}"><source media="(prefers-reduced-motion: reduce)" '
                          'srcset="pictures/docs/still.svg"/>'
                          f'<img src="pictures/docs/{name}.gif" alt="A spring that moves" width="640" loading="lazy"/></picture>', page)
        self.assertIn('<div class="figure"><picture', page)

    def test_an_orphan_figure(self):
        self.write("chapters/02_constraints/figures/ch02_alone.svg", "<svg/>")
        self.fails("ch02_alone.svg", "not shown by its chapter")

    def test_a_figure_with_the_number_of_another_chapter_in_its_name(self):
        self.write("chapters/01_euler/figures/ch02_x.svg", "<svg/>")
        self.add("![A line.](figures/ch02_x.svg)\n\n**Figure 1.2.** A line.")
        self.fails("does not begin with ch01_")

    def test_a_picture_without_alt_text(self):
        self.change("chapters/01_euler/README.md", "A picture of a spring.", "")
        self.fails("no alternative text")

    def test_a_picture_without_caption(self):
        self.change("chapters/01_euler/README.md", "**Figure 1.1.** A spring", "A spring")
        self.assertTrue(any("has a caption" in f for f in self.faults()))

    def test_an_unknown_figure(self):
        self.add("As in Figure 1.7.")
        self.fails("no Figure 1.7")

    def test_an_unknown_citation(self):
        self.add("See [[nobody1999]](../../docs/references.bib).")
        self.fails("no 'nobody1999'")

    def test_an_unknown_citation_in_a_doc_comment(self):
        self.change("chapters/01_euler/step.hpp", "#pragma once", "/// \\cite nobody1999\n#pragma once")
        self.fails("step.hpp:3", "no 'nobody1999'")

    def test_a_citation_without_its_file(self):
        self.add("See [[known2000]] for it.")
        self.fails("lacks its")

    def test_a_duplicate_equation(self):
        self.add("```math\na\n\\tag{1.2}\n```")
        self.fails("equation (1.2) exists already, at chapters/01_euler/README.md:")

    def test_an_equation_with_the_number_of_another_chapter(self):
        self.add("```math\na \\tag{2.7}\n```")
        self.fails("number of another chapter")

    def test_two_tags_in_one_block(self):
        self.add("```math\na \\tag{1.8} b \\tag{1.9}\n```")
        self.fails("one \\tag")

    def test_an_unknown_equation_in_the_text(self):
        self.add("By\nsome words and (1.8), it follows.")
        self.fails("no equation (1.8)", "README.md:%d" % (self.read("chapters/01_euler/README.md").count("\n") - 2))

    def test_an_unknown_equation_of_another_chapter(self):
        self.add("By (2.4).")
        self.fails("no equation (2.4) in chapter 2")

    def test_an_unknown_equation_in_a_comment(self):
        self.change("chapters/01_euler/step.hpp", "(1.1): forward", "(1.4): forward")
        self.write("chapters/01_euler/README.md", ONE)
        sync_snippets.run(self.root, check=False)
        self.fails("step.hpp:9", "no equation (1.4)")

    def test_an_unknown_equation_in_the_name_of_a_test(self):
        self.write("tests/02_x.cpp", 'TEST_CASE("drift follows (2.3)") {}\nconst char* s = "(2.4)";\n')
        self.fails("tests/02_x.cpp:1", "(2.3)")

    def test_an_unknown_equation_in_a_figure(self):
        self.write("chapters/01_euler/figures/ch01_spring.svg", "<svg>\n<text>theory (1.6)</text></svg>")
        self.fails("ch01_spring.svg:2", "(1.6)")

    def test_numbers_that_are_no_equations(self):
        self.add("f(1.9), `(1.9)`, $(1.9)$, (1.9)*2 no: (1.95 m), (0.05), (1.0), (7.3), (1.125), v(1.7), "
                 "[text](https://example.org/1.9) and 1.9.")
        self.assertEqual([f for f in self.faults() if "equation" in f and "(1.9)" not in f], [])
        self.change("chapters/01_euler/README.md", "(1.9)*2 no: ", "")
        self.assertEqual(self.faults(), [])

    def test_a_range_of_equations(self):
        self.add("From (1.1)-(1.2), (1.1) to (1.2), **(1.1)** and *(1.2)*; ((1.1)).")
        self.assertEqual(self.faults(), [])
        self.add("**(1.7)**")
        self.fails("(1.7)")

    def test_a_test_that_does_not_exist(self):
        self.change("tests/01_euler.cpp", "it steps by", "it walks by")
        self.fails("has no test 'it steps by (1.1)'")

    def test_sections_out_of_order(self):
        self.change("chapters/01_euler/README.md", "## 1.2 Sources", "## 1.3 Sources")
        self.fails("'## 1.2 …'")

    def deeper(self, text=None):
        """A page beside the main road, with an equation that the main road cites."""
        self.write("chapters/01_euler/in_depth.md", text or
                   "# Chapter 1 in depth\n\n## 1.A What is left\n\nBy (1.1),\n\n"
                   "```math\nr_n = 1 . \\tag{1.9}\n```\n\n<!-- snippet: step.hpp step -->\n<!-- /snippet -->\n")
        self.add("More in [1.A](in_depth.md#1a-what-is-left), at (1.9).")

    def test_what_goes_deeper_is_a_text_like_the_others(self):
        self.deeper()
        self.assertEqual(sum("is stale or empty" in s for s in sync_snippets.run(self.root, check=True)[0]), 1)
        sync_snippets.run(self.root, check=False)
        self.assertIn("return x + 1", self.read("chapters/01_euler/in_depth.md"))
        self.assertEqual(self.faults(), [])
        self.add("```math\nr_n = 2 . \\tag{1.1}\n```", "chapters/01_euler/in_depth.md")
        self.fails("equation (1.1) exists already, at chapters/01_euler/README.md:")

    def test_what_goes_deeper_has_its_own_title_and_letters(self):
        self.deeper("# More\n\n## 1.A What is left\n\n```math\nr_n = 1 . \\tag{1.9}\n```\n")
        self.fails("the title is 'Chapter 1 in depth'")
        self.change("chapters/01_euler/in_depth.md", "# More", "# Chapter 1 in depth")
        self.add("## 1.C Later", "chapters/01_euler/in_depth.md")
        self.fails("'## 1.B …'")

    def test_what_goes_deeper_is_linked_by_its_chapter(self):
        self.write("chapters/01_euler/in_depth.md", "# Chapter 1 in depth\n")
        self.fails("its chapter's README.md has no link to it")

    def test_maths_in_a_heading(self):
        self.add("## 1.3 The rate $r$")
        self.fails("no maths, code, link or #")

    def test_maths_that_is_not_closed(self):
        self.add("A letter $x of it.")
        self.fails("a $ that belongs to no maths")

    def test_maths_that_github_misreads(self):
        self.add("A set $\\{0, 1\\}$.")
        self.fails("GitHub misreads")
        self.change("chapters/01_euler/README.md", "$\\{0, 1\\}$", "$`\\{0, 1\\}`$")
        self.assertEqual(self.faults(), [])

    def test_underscores_that_become_emphasis(self):
        self.add("Of $(a)_i$ and $c_{ij}$.")
        self.fails("underscores")

    def test_unbalanced_braces(self):
        self.add("```math\n\\frac{1}{2\n```")
        self.fails("unbalanced braces")

    def test_an_environment_that_mathjax_refuses_here(self):
        self.add("```math\n\\begin{align} a \\end{align}\n```")
        self.fails("'aligned'")

    def test_a_bar_in_the_maths_of_a_table(self):
        self.add("| a |\n|---|\n| $|x|$ |")
        self.assertTrue(any("\\lvert" in f for f in self.faults()))

    def test_a_table_with_a_short_row(self):
        self.add("| a | b |\n|---|---|\n| 1 |")
        self.fails("1 cells, its header 2")

    def test_details_that_are_not_closed(self):
        self.add("<details>\n<summary>More</summary>\n\nText.")
        self.fails("never closed")

    def test_a_fence_that_is_not_closed(self):
        self.add("```cpp\nint x;")
        self.assertTrue(any("never closed" in f for f in self.faults()))

    def test_code_that_the_page_would_cut_off(self):
        self.add("```cpp\n" + "x" * 84 + "\n```\n\n```text\n" + "x" * 200 + "\n```")
        self.assertEqual(self.faults(), [])
        self.add("```sh\n" + "x" * 85 + "\n```")
        self.fails("85 columns")

    def test_quoted_code_that_the_page_would_cut_off(self):
        self.change("chapters/01_euler/step.hpp", "//! [step]\n", "//! [step]\n// " + "x" * 90 + "\n")
        sync_snippets.run(self.root, check=False)
        self.fails("93 columns")

    def test_a_main_road_that_is_too_long(self):
        self.add("word " * (6000 - check_text.words_of(blocks(self.read("chapters/01_euler/README.md")))))
        self.add("```text\n" + "word " * 500 + "\n```\n\n```math\n" + "x + " * 500 + "y\n```")
        self.assertEqual(self.faults(), [])
        self.add("A word too much, in a solution or anywhere:\n\n<details>\n<summary>Solution</summary>\n\nword\n\n</details>")
        self.fails("a main road of 6010 words; at most 6000")

    def test_a_chapter_without_the_line_of_links_below_its_title(self):
        self.change("chapters/02_constraints/README.md", "[Contents](", "See [Contents](")
        self.fails("below the title goes the line")

    def test_a_chapter_that_does_not_end_with_its_line_of_links(self):
        self.write("chapters/02_constraints/README.md", self.read("chapters/02_constraints/README.md") + "\nThe end.\n")
        self.fails("ends with the line of links with which it begins")

    def test_a_table_that_is_wider_than_the_page(self):
        self.add("| a | b |\n|---|---|\n| " + "words " * 200 + " | " + "x" * 120 + " |")
        self.assertEqual(self.faults(), [])
        self.add("| a | b |\n|---|---|\n| " + "x" * 20 + " | `" + "x" * 120 + "` |")
        self.fails("this table needs about 1052 pixels")

    def test_a_letter_whose_name_is_not_in_the_code(self):
        self.write("docs/notation.md", "# Notation\n\n| letter | code | meaning |\n|---|---|---|\n| $x$ | `x`, `step()` | `gone` |\n")
        self.assertEqual(self.faults(), [])
        self.change("docs/notation.md", "`x`", "`known2000`")  # of a comment alone
        self.fails("notation.md:5: no source has the name 'known2000'")

    def test_other_html(self):
        self.add("A <div>box</div>.")
        self.assertTrue(all("no HTML" in f for f in self.faults()) and self.faults())

    def test_what_is_in_code_is_left_alone(self):
        self.add("````text\n```math\n\\tag{9.9}\n```\n[x](gone.md) $ (1.99)\n<!-- snippet: a b -->\n````\n\n"
                 "`[x](gone.md)` and `` `(1.99)` `` and \\$ too.")
        self.assertEqual(self.faults(), [])


class Map(unittest.TestCase):
    def test_the_map_of_methods_is_as_it_is_drawn(self):
        folder = pathlib.Path(__file__).resolve().parents[1] / "map"
        drawn = subprocess.run([sys.executable, "-B", folder / "draw.py", "--check", folder / "figures" / "map_methods.svg"],
                               capture_output=True, text=True, check=False)
        self.assertEqual((drawn.returncode, drawn.stderr), (0, ""))


class Architecture(unittest.TestCase):
    folder = pathlib.Path(__file__).resolve().parents[1] / "architecture"

    def drawn(self, file):
        return subprocess.run([sys.executable, "-B", self.folder / "draw.py", "--check", file], capture_output=True, text=True, check=False)

    def test_the_drawing_is_that_of_the_includes(self):
        drawn = self.drawn(self.folder / "figures" / "architecture.svg")
        self.assertEqual((drawn.returncode, drawn.stderr), (0, ""))

    def test_an_arc_that_no_include_has_is_noticed(self):
        text = (self.folder / "figures" / "architecture.svg").read_text(encoding="utf-8")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "architecture.svg"
            file.write_text(text.replace("</svg>", '<path d="M0 0C1 1 2 2 3 3"/>\n</svg>'), encoding="utf-8")
            self.assertEqual(self.drawn(file).returncode, 1)

    def test_sources_belong_to_their_parts(self):
        sys.path.insert(0, str(self.folder))
        import draw
        sys.path.remove(str(self.folder))
        for path, part in (("chapters/04_pgs/pgs.hpp", 4), ("chapters/04_pgs/program/main.cpp", "program"), ("common/bodies.hpp", "common"),
                           ("chapters/04_pgs/benchmark/benchmark.cpp", "benchmark"), ("common/program/window.hpp", "program"),
                           ("common/svg_canvas.hpp", "program"), ("tests/stress/judge.hpp", "tests"), ("docs/race/race.cpp", "docs")):
            self.assertEqual(draw.part(path), part)


class Version(Folder):
    def all_of(self, version):
        self.write("CMakeLists.txt", f"project(rigid VERSION {version} LANGUAGES CXX)\n")
        self.write("CITATION.cff", f"cff-version: 1.2.0\nversion: {version}\n")
        self.write("vcpkg.json", f'{{"version-string": "{version}"}}\n')
        self.write("cmake/vcpkg/rigid/vcpkg.json", f'{{"version": "{version}"}}\n')
        self.write("CHANGELOG.md", f"# Changelog\n\n## {version} (2026-11-26)\n\n## 0.1.0\n")
        for name in ("docs/use_it.md", "docs/use_it/CMakeLists.txt"):
            self.write(name, f"find_package(rigid {version.rpartition('.')[0]} CONFIG REQUIRED)\n")

    def test_each_place_that_has_another_version_is_named(self):
        self.all_of("1.20.3")
        self.assertEqual(list(check_version.faults(self.root)), [])
        for name in check_version.PLACES:
            self.all_of("1.20.3")
            self.change(name, "1.20", "1.19")
            self.assertEqual(len(list(check_version.faults(self.root))), 1, name)

    def test_a_version_that_is_not_there(self):
        self.all_of("1.20.3")
        self.write("CITATION.cff", "title: none\n")
        self.assertEqual(list(check_version.faults(self.root)), ["CITATION.cff has the version (none); CMakeLists.txt has 1.20.3."])
        self.write("CMakeLists.txt", "project(rigid)\n")
        with self.assertRaises(TextError):
            list(check_version.faults(self.root))


class Index(Folder):
    def terms(self):
        return [line[2:] for line in make_index.page(self.root).splitlines() if line.startswith("- ")]

    def test_terms_in_bold_type_sections_and_other_words(self):
        self.add("**Not this one.** A line of numbers, a **long row**, and **Jacobian**. **At the start** of a **sentence with more than four words**, "
                 "**a stop.** and **the last of**.")
        self.write("docs/index/terms.txt", "# comment\nname Jacobian\nnot the last of\nterm step | 01_euler | From Newton's law to a step\nsee stride | step\n")
        self.assertEqual([t.split("]")[0] for t in self.terms()],
                         ["Jacobian: [1.2", "long row: [1.2", "step: [1.1", "stride: see *step*, [1.1"])
        self.assertIn("(../chapters/01_euler/README.md#11-from-newtons-law-to-a-step)", self.terms()[2])

    def test_a_section_that_is_not_there_and_a_line_that_is_none(self):
        for line in ("term step | 01_euler | Gone", "term step", "see stride | nothing", "word"):
            self.write("docs/index/terms.txt", line + "\n")
            with self.assertRaises(TextError):
                make_index.page(self.root)

    def test_a_page_that_is_stale(self):
        tool = pathlib.Path(make_index.__file__)
        run = lambda *words: subprocess.run([sys.executable, "-B", tool, "--root", self.root, *words], capture_output=True, text=True, check=False)
        self.assertEqual(run().returncode, 0)
        self.assertEqual(run("--check").returncode, 0)
        self.add("A **new term**.")
        self.assertIn("docs/index_of_terms.md is not what the chapters give", run("--check").stderr)


class Snippets(Folder):
    def stale(self):
        said, well = sync_snippets.run(self.root, check=True)
        self.assertFalse(well)
        return "\n".join(said)

    def test_the_code_is_filled_in_without_its_margin(self):
        text = self.read("chapters/01_euler/README.md")
        self.assertIn("```cpp\n/// One step of (1.1). \\cite known2000\n    inline int step(int x)\n", text)
        self.assertEqual(sync_snippets.run(self.root, check=True), ([], True))

    def test_code_that_changed_is_stale(self):
        self.change("chapters/01_euler/step.hpp", "x + 1", "x + 2")
        self.assertIn("chapters/01_euler/README.md:19: the snippet 'step' of step.hpp is stale", self.stale())
        sync_snippets.run(self.root, check=False)
        self.assertEqual(sync_snippets.run(self.root, check=True), ([], True))

    def test_a_missing_marker(self):
        self.change("chapters/01_euler/README.md", "step.hpp step", "step.hpp leap")
        self.assertIn("step.hpp has no markers '//! [leap]'", self.stale())

    def test_a_missing_file(self):
        self.change("chapters/01_euler/README.md", "step.hpp step", "leap.hpp step")
        self.assertIn("no file leap.hpp", self.stale())

    def test_a_marker_that_occurs_once_or_three_times(self):
        self.change("chapters/01_euler/step.hpp", "//! [step]\n}", "}")
        self.assertIn("occurs once", self.stale())
        self.change("chapters/01_euler/step.hpp", "#pragma", "//! [step]\n//! [step]\n#pragma")
        self.assertIn("occurs 3 times", self.stale())

    def test_a_block_without_end(self):
        self.change("chapters/01_euler/README.md", "<!-- /snippet -->", "")
        self.assertIn("has no end", self.stale())

    def test_a_snippet_of_another_chapter(self):
        self.add("<!-- snippet: ../01_euler/step.hpp step -->\n<!-- /snippet -->", "chapters/02_constraints/README.md")
        sync_snippets.run(self.root, check=False)
        self.assertIn("return x + 1", self.read("chapters/02_constraints/README.md"))

    def test_a_function_of_a_small_program_and_what_it_changed(self):
        before = "// Chapter 1 in one file: a step.\n\n// (1.1)\nint step(int x)\n{\n    return x;\n}\n\nint main()\n{\n    return step(1);\n}\n"
        after = before.replace("Chapter 1 in one file", "Chapter 2 in one file, grown from chapter 1").replace(
            "return x;", "return 2 * x;")
        (self.root / "chapters/01_euler/small.cpp").write_text(before, encoding="utf-8")
        (self.root / "chapters/02_constraints/small.cpp").write_text(after, encoding="utf-8")
        for name in ("step()", "changed:step()"):
            self.add(f"<!-- snippet: small.cpp {name} -->\n<!-- /snippet -->", "chapters/02_constraints/README.md")
        sync_snippets.run(self.root, check=False)
        text = self.read("chapters/02_constraints/README.md")
        self.assertIn("```cpp\n// (1.1)\nint step(int x)\n{\n    return 2 * x;\n}\n```", text)
        self.assertIn("```diff\n // (1.1)\n int step(int x)\n {\n-    return x;\n+    return 2 * x;\n }\n```", text)
        self.assertEqual(sync_snippets.run(self.root, check=True), ([], True))
        self.change("chapters/01_euler/small.cpp", "return x;", "return -x;")
        self.assertIn("'changed:step()' of small.cpp is stale", self.stale())

    def test_which_functions_a_small_program_changed(self):
        before = ("// Chapter 1 in one file: a step.\nstruct Body {\n    int x;\n};\n\nint gone(int x) { return x; }\n\n"
                  "// (1.1)\nint step(int x)\n{\n    return x;\n}\n\nint main()\n{\n    return step(1);\n}\n")
        after = (before.replace("Chapter 1 in one file", "Chapter 2 in one file, grown from chapter 1")
                 .replace("int gone(int x) { return x; }", "int twice(int x)\n{\n    return 2 * x;\n}")
                 .replace("    return x;\n", "    x = twice(x);\n    return x;\n"))
        (self.root / "chapters/01_euler/small.cpp").write_text(before, encoding="utf-8")
        (self.root / "chapters/02_constraints/small.cpp").write_text(after, encoding="utf-8")
        self.add("<!-- snippet: small.cpp changes -->\n<!-- /snippet -->", "chapters/02_constraints/README.md")
        sync_snippets.run(self.root, check=False)
        self.assertIn("```diff\n-gone()\n+twice() 4\n step() +1\n```", self.read("chapters/02_constraints/README.md"))
        self.assertEqual(sync_snippets.run(self.root, check=True), ([], True))
        self.change("chapters/01_euler/small.cpp", "gone", "lost")
        self.assertIn("'changes' of small.cpp is stale", self.stale())
        self.change("chapters/01_euler/small.cpp", "int main(", "int start(")
        self.assertIn("small.cpp has no main() at the left edge", self.stale())

    def test_a_function_that_is_not_there(self):
        (self.root / "chapters/01_euler/small.cpp").write_text("// Chapter 1 in one file: a step.\nint one()\n{\n}\n", encoding="utf-8")
        self.add("<!-- snippet: small.cpp two() -->\n<!-- /snippet -->", "chapters/01_euler/README.md")
        self.assertIn("small.cpp has no functions 'two()' to quote", self.stale())
        self.change("chapters/01_euler/README.md", "small.cpp two()", "small.cpp changed:one()")
        self.assertIn("does not begin with the chapter that it grew from", self.stale())


class Tables(Folder):
    """Measured tables stand where their mark or their caption is."""

    PAGE = "chapters/02_constraints/README.md"
    MARK = "<!-- table: benchmark/times.csv ms -->"
    NEW = ["| world | ms |", "|---|---|", "| pile | 4.1 |"]

    def setUp(self):
        super().setUp()
        self.page = self.root / self.PAGE
        self.add(f"{self.MARK}\n\n| old |\n|---|\n| 1 |\n\n<!-- /table -->\n\n| old |\n|---|\n| 2 |\n\n**Table 2.1.** Two.", self.PAGE)

    def test_a_table_is_put_between_its_marks_or_above_its_caption(self):
        tables = {self.MARK: self.NEW, "**Table 2.1.**": self.NEW}
        self.assertEqual(put_table.stale(self.page, tables), list(tables))
        put_table.put_all(self.page, tables)
        self.assertEqual(put_table.stale(self.page, tables), [])
        self.assertEqual(self.read(self.PAGE).count("\n".join(["", "", *self.NEW, "", ""])), 2)
        self.assertNotIn("old", self.read(self.PAGE))

    def test_a_number_that_is_typed_is_stale(self):
        put_table.put_all(self.page, {self.MARK: self.NEW})
        self.change(self.PAGE, "4.1", "4.0")
        self.assertEqual(put_table.stale(self.page, {self.MARK: self.NEW}), [self.MARK])

    def test_a_mark_that_is_missing_twice_there_or_without_end(self):
        for old, new, words in ((self.MARK, "", "stands 0 times"), (self.MARK, f"{self.MARK}\n{self.MARK}", "stands 2 times"),
                                ("<!-- /table -->", "", "has no end"), ("<!-- /table -->", "<!-- table: a b -->", "has no end")):
            text = self.read(self.PAGE)
            self.change(self.PAGE, old, new)
            with self.assertRaisesRegex(SystemExit, words):
                put_table.put_all(self.page, {self.MARK: self.NEW})
            self.write(self.PAGE, text)

    def test_a_file_of_a_benchmark_begins_with_the_machine(self):
        self.write("run.csv", '2026\nRun on (2 X)\nname,iterations,"ms_all"\n"pile/book",1,4.1\n')
        self.assertEqual(put_table.benchmark_rows(self.root / "run.csv"), [{"name": "pile/book", "iterations": "1", "ms_all": "4.1"}])
        with self.assertRaisesRegex(SystemExit, "is no CSV of Google Benchmark"):
            put_table.benchmark_rows(self.root / "chapters/01_euler/step.hpp")


class Filter(Folder):
    def page(self, name="chapters/01_euler/README.md"):
        return unpacked(Page(Book(self.root), self.root / name).text())

    def test_titles_and_sections_get_their_labels(self):
        text = self.page()
        self.assertIn("# Chapter 1. Euler integration {#ch01_euler}", text)
        self.assertIn("## 1.1 From Newton's law to a step {#ch01_euler_11_from_newtons_law_to_a_step}", text)

    def test_what_goes_deeper_is_a_page_and_its_numbers_are_links(self):
        self.write("chapters/01_euler/in_depth.md",
                   "# Chapter 1 in depth\n\n## 1.A Rest\n\n```math\nr = 1 . \\tag{1.9}\n```\n")
        self.add("See (1.9) and [1.A](in_depth.md#1a-rest).")
        self.assertIn("# Chapter 1 in depth {#ch01_euler_in_depth}", self.page("chapters/01_euler/in_depth.md"))
        self.assertIn('<a class="el" href="ch01_euler_in_depth.html#eq_1_9">(1.9)</a>', self.page())
        self.assertIn('<a class="el" href="ch01_euler_in_depth.html#ch01_euler_in_depth_1a_rest">1.A</a>', self.page())

    def test_maths(self):
        text = self.page()
        self.assertIn("\\anchor eq_1_1\n\\f[\na_n = f(x_n) \\tag{1.1}\n\\f]", text)
        self.assertIn("\\(x_n\\)", text)
        self.assertIn("$5 and one of $6", text)
        self.assertIn("\\(\\lvert x \\rvert\\)", text)

    def test_links_pictures_and_citations(self):
        text = self.page()
        self.assertIn('<a class="el" href="ch02_constraints.html">Next: constraints</a>', text)
        self.assertIn('href="ch01_euler.html#ch01_euler_11_from_newtons_law_to_a_step"', text)
        self.assertIn('<a class="el" href="citelist.html#CITEREF_known2000">[known2000]</a>', text)
        self.assertIn('<img src="pictures/chapters/01_euler/figures/ch01_spring.svg" alt="A picture of a spring."/>',
                      text)
        self.assertIn('<a class="el" href="ch01_euler.html#eq_1_2">(1.2)</a>', text)
        self.assertIn('<a class="el" href="ch01_euler.html#fig_1_1">Figure 1.1</a>', text)

    def test_code_is_left_alone(self):
        self.add("`$HOME` and ``a`b`` and `<T>`\n\n```sh\necho $x (1.1) [a](b.md)\n```")
        text = self.page()
        self.assertIn("<code>$HOME</code> and <code>a`b</code> and <code>&lt;T&gt;</code>", text)
        self.assertIn("echo $x (1.1) [a](b.md)", text)
        self.assertIn("return x + 1;  // (1.1): forward", text)

    def test_doc_comments_get_links_and_keep_their_lines(self):
        text = source_text(Book(self.root), STEP)
        self.assertEqual(text.count("\n"), STEP.count("\n"))
        self.assertIn('/// One step of \\ref eq_1_1 "(1.1)". \\cite known2000', text)
        self.assertIn("// (1.1): forward", text)
        self.assertNotIn("//! [step]", text)

    def test_tests_become_functions_with_their_names(self):
        text = test_text(Book(self.root), self.root / "tests/01_euler.cpp", TESTS)
        self.assertIn('/** it steps by \\ref eq_1_1 "(1.1)" */ void test_001();', text.split("\n")[1])


class Finish(Folder):
    def test_what_doxygen_could_not_know(self):
        html = self.root / "html"
        html.mkdir()
        (html / "step_8hpp_source.html").write_text("")
        (html / "index.html").write_text(
            '<a class="el" href="book:chapters/01_euler/step.hpp#7">line<!--/book--></a> '
            '<a class="el" href="book:LICENSE">MIT<!--/book--></a> '
            '<span class="comment">// (1.1): and f(1.1)</span> '
            '<img src="pictures/chapters/01_euler/figures/ch01_spring.svg" alt="x"/> \\(x\\), '
            '<picture><source srcset="pictures/docs/still.svg"/></picture>'
            '<a href="citelist.html#CITEREF_known2000">[12]</a>')
        (self.root / "tag").write_text(
            "<tagfile><compound kind='file'><name>step.hpp</name>"
            f"<path>{self.root}/chapters/01_euler/</path><filename>step_8hpp.html</filename></compound></tagfile>")
        self.write("docs/still.svg", "<svg></svg>")
        finish(html, self.root / "tag", self.root)
        text = (html / "index.html").read_text()
        self.assertIn('<a class="el" href="step_8hpp_source.html#l00007">line</a> MIT', text)
        self.assertIn('// <a class="equation" href="ch01_euler.html#eq_1_1">(1.1)</a>: and f(1.1)', text)
        self.assertIn('<span class="nobreak">\\(x\\),</span>', text)
        self.assertIn("[known2000]</a>", text)
        self.assertTrue((html / "pictures/chapters/01_euler/figures/ch01_spring.svg").is_file())
        self.assertTrue((html / "pictures/docs/still.svg").is_file())


class Site(unittest.TestCase):
    def check(self, body, head=""):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "index.html").write_text(f"<html><head>{head}</head><body>{body}</body></html>")
            return "\n".join(check_html.check(folder.resolve()))

    def test_a_page_without_faults_passes(self):
        self.assertEqual(self.check('<a id="x"></a><a href="#x">x</a> <a href="https://example.org">out</a> \\(x\\) '
                                    "costs $5 and $6 <code>$x$ \\cite</code>"), "")

    def test_links_anchors_and_pictures(self):
        self.assertIn("leads to nothing", self.check('<a href="gone.html">x</a>'))
        self.assertIn("no anchor #y", self.check('<a href="#y">x</a>'))
        self.assertIn("is missing", self.check('<img src="gone.svg" alt="x">'))
        self.assertIn("without alternative text", self.check('<img src="data:," alt="">'))

    def test_requests_to_elsewhere(self):
        self.assertIn("fetched from elsewhere", self.check("", '<script src="https://example.org/x.js"></script>'))
        self.assertIn("fetched from elsewhere", self.check("", '<link rel="stylesheet" href="//example.org/x.css">'))
        self.assertIn("fetched from elsewhere", self.check('<img alt="x" src="http://example.org/x.png">'))

    def test_raw_marks(self):
        for raw in ("\\f[ x \\f]", "let $x$ be", "see \\cite key", "[x](y.md)", "packq2020q"):
            self.assertIn("raw" if "$" not in raw else "not turned into", self.check(f"<p>{raw}</p>"), raw)


class Search(unittest.TestCase):
    PAGE = ('<div class="title">Chapter 1. Euler</div><div class="contents"><p>Before.</p>'
            '<h1><a class="anchor" id="s11"></a> 1.1 Two&#160;lines</h1><p>Swap \\(\\lambda_n \\ge 0\\) and <b>wait</b>.<br>'
            '<div class="fragment">no code</div></p><table><tr><td>42</td></tr></table>'
            '<h2>Sum</h2>\\[ a + b + c + d + e + f + g \\] long</div><p>footer</p>')

    def test_sections_with_their_words(self):
        found = search_texts.entries_of_page("ch01.html", self.PAGE)
        self.assertEqual([(one["address"], one["title"], one["page"]) for one in found],
                         [("ch01.html", "Chapter 1. Euler", ""), ("ch01.html#s11", "1.1 Two lines", "Chapter 1. Euler"),
                          ("ch01.html", "Sum", "Chapter 1. Euler")])
        self.assertEqual([one["text"] for one in found], ["Before.", "Swap λn≥0 and wait.42", "… long"])

    def test_numbers_of_the_results_are_no_text(self):
        self.assertEqual(search_texts.entries_of_page("results.html", self.PAGE)[1]["text"], "Swap λn≥0 and wait.")

    def test_names_once_without_constructors(self):
        with tempfile.TemporaryDirectory() as name:
            tags = pathlib.Path(name) / "tag"
            member = "<member kind='function'><name>{}</name><anchorfile>b.html</anchorfile><anchor>x</anchor></member>"
            tags.write_text("<tagfile><compound kind='struct'><name>rigid::Row</name><filename>b.html</filename>"
                            + "".join(member.format(one) for one in ("Row", "~Row", "operator+", "flip", "flip"))
                            + "</compound><compound kind='class'><name>Eigen::X</name></compound></tagfile>")
            self.assertEqual([(one["title"], one["page"]) for one in search_texts.entries_of_names(tags)],
                             [("Row", "type"), ("flip", "rigid::Row")])


class Sidebar(unittest.TestCase):
    def test_a_chapter_comes_before_what_goes_deeper(self):
        deep = '    [ "Chapter 1 in depth", "a.html", [\n      [ "1.A", "a.html#a", null ]\n    ] ],\n'
        road = '    [ "Chapter 1. Euler", "b.html", [\n      [ "1.1", "b.html#b", null ]\n    ] ],\n'
        last = '    [ "Notation", "c.html", null ],\n'
        self.assertEqual(finish_html.in_order(deep + road + last), road + deep + last)
        self.assertEqual(finish_html.in_order(road + last), road + last)

    def test_its_table_of_places_follows(self):
        old = '"ch01_a_in_depth.html":[0],\n"ch01_a.html":[1],\n"ch01_a.html#x":[1,2],\n"ch02_b.html":[2],\n'
        new = '"ch01_a_in_depth.html":[1],\n"ch01_a.html":[0],\n"ch01_a.html#x":[0,2],\n"ch02_b.html":[2],\n'
        self.assertEqual(finish_html.places_in_order(old, {"ch01_a"}), new)


class Commands(Folder):
    """A program of the book is a script here: what it is called with, where, and how it ends."""

    def setUp(self):
        super().setUp()
        self.write("bin/01_euler", "#!/bin/sh\n"
                   'echo "$PWD $DISPLAY $*" >>"$(dirname "$0")/calls"\n'
                   'case "$*" in *"--scene five --steps 1"*) echo "five methods; a window shows 4" >&2; exit 2 ;; esac\n'
                   'case "$*" in *"--scene fails"*) echo "step 1: it fell over" >&2; exit 3 ;; esac\n'
                   "touch left_behind\n")
        (self.root / "bin/01_euler").chmod(0o755)

    def run_with(self, *arguments):
        tools = pathlib.Path(__file__).resolve().parent
        done = subprocess.run([sys.executable, "-B", str(tools / "check_commands.py"), *arguments],
                              capture_output=True, text=True)
        return done.returncode, done.stdout, done.stderr

    def checked(self, *lines):
        self.add("\n".join(["```sh", *lines, "```"]))
        return self.run_with(str(self.root / "bin"), "--root", str(self.root))

    def test_a_command_is_run_for_one_step_as_it_stands_and_without_a_window(self):
        code, out, err = self.checked("./book run 1 --scene fall --steps 900 --csv a.csv   # a comment")
        self.assertEqual((code, err), (0, ""))
        calls = [line.split(" ", 2) for line in self.read("bin/calls").splitlines()]
        self.assertEqual([c[2] for c in calls if not c[1]],
                         ["--scene fall --csv a.csv --steps 1", "--scene fall --headless --steps 1"])
        self.assertFalse((self.root / "left_behind").exists())
        self.assertTrue(all(not c[0].startswith(str(self.root)) for c in calls))

    def test_a_command_in_two_lines_is_one_command(self):
        code, out, err = self.checked("./book run 1 --scene fall \\", "    --steps 900")
        self.assertEqual((code, err), (0, ""))
        self.assertIn("--scene fall --steps 1", self.read("bin/calls"))

    def test_a_scene_that_is_called_like_a_file_of_the_book_is_no_file(self):
        self.write("book", "")
        self.write("problems/two.txt", "")
        self.assertEqual(self.checked("./book run 1 --scene book --problem problems/two.txt")[0], 0)
        self.assertEqual({line.split(" ", 2)[2] for line in self.read("bin/calls").splitlines()},
                         {f"--scene book --problem {self.root}/problems/two.txt"})

    def test_a_command_that_only_a_window_refuses(self):
        code, out, _ = self.checked("./book run 1 --scene five")
        self.assertEqual(code, 1)
        self.assertIn("README.md", out)
        self.assertIn("exit code 2: five methods; a window shows 4", out)

    def test_a_command_that_cannot_go_on(self):
        code, out, _ = self.checked("./book run 1 --scene fails")
        self.assertEqual(code, 1)
        self.assertIn("exit code 3: step 1: it fell over", out)

    def test_a_list_is_run_once_and_an_ellipsis_not_at_all(self):
        code, out, _ = self.checked("./book run 1 --list-scenes", "./book run 1 --scene NAME")
        self.assertEqual(code, 0)
        self.assertEqual(self.read("bin/calls").count("\n"), 1)

    def test_a_program_or_a_chapter_that_is_not_there(self):
        code, out, _ = self.checked("./book run 2")
        self.assertEqual(code, 1)
        self.assertIn("02_constraints", out)
        code, _, err = self.checked("./book run 7")
        self.assertEqual(code, 2)
        self.assertIn("there is no chapter 7", err)
        self.assertNotIn("Traceback", err)


    def test_limits_that_a_program_prints_and_refuses(self):
        self.write("bin/01_euler", """#!/bin/sh
case "$*" in
*--help) cat <<'END'
  fall: A bead that falls.
    --h 0.01 s, between 0.001 and 0.01666666667 s
    --set g=8 m/s²                Gravity; between 0 and 16 m/s²
    --set beads=1                 How many; whole number between 1 and 20; restarts the scene
END
;;
*0.01666666667*) echo "the time step --h is too long" >&2; exit 2 ;;
*beads=20*) echo "the tunable beads is 20" >&2; exit 2 ;;
*g=16*) echo "g does not go with beads" >&2; exit 2 ;;
*beads=1) exit 139 ;;
esac
""")
        tools = pathlib.Path(__file__).resolve().parent
        done = subprocess.run([sys.executable, "-B", str(tools / "check_limits.py"), str(self.root / "bin"), "01_euler"],
                              capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertEqual(done.stdout.splitlines(), [
            "01_euler --scene fall --h 0.01666666667: exit code 2: the time step --h is too long",
            "01_euler --scene fall --set beads=1: exit code 139: ",
            "01_euler --scene fall --set beads=20: exit code 2: the tunable beads is 20",
            "6 limits tried, 3 of them refused"])


class Demos(Folder):
    """The demos of the texts: how they are named, and what becomes of them on the site."""

    PLACE = "![A picture of a spring.](figures/ch01_spring.svg)"

    def place(self, comment):
        self.write("chapters/01_euler/program/main.cpp", "int main() {}\n")
        self.change("chapters/01_euler/README.md", self.PLACE, f"<!-- demo: {comment} -->\n{self.PLACE}")

    def page(self):
        return Page(Book(self.root), self.root / "chapters/01_euler/README.md").text()

    def test_all_parts_of_a_demo(self):
        demo = demos.parse("04_pgs/column, gauss_seidel sor, rows=20 h=0.01, break two sweeps: sor max_sweeps=2, opens, says: Ten, and more.", None, "a:1")
        self.assertEqual((demo["program"], demo["scene"], demo["methods"], demo["settings"]),
                         ("04_pgs", "column", ["gauss_seidel", "sor"], {"rows": 20, "h": 0.01}))
        self.assertEqual(demo["break"], {"label": "two sweeps", "methods": ["sor"], "settings": {"max_sweeps": 2}})
        self.assertTrue(demo["opens"])
        self.assertEqual(demo["says"], "Ten, and more.")
        self.assertEqual(demos.parse("column", "04_pgs", "a:1")["program"], "04_pgs")

    def test_a_demo_without_fault(self):
        self.place("springs, explicit")
        self.assertEqual(self.faults(), [])

    def test_a_setting_that_is_no_number(self):
        self.place("springs, h=fast")
        self.fails("h=fast is no number")

    def test_a_break_without_a_colon(self):
        self.place("springs, break explicit")
        self.fails("'break' names what is off")

    def test_a_program_that_is_not_there(self):
        self.place("09_none/springs")
        self.fails("there is no program 09_none")

    def test_without_the_programs_the_figure_stays_as_it_is(self):
        before = self.page()
        self.place("springs")
        self.assertEqual(self.page(), before)

    def test_with_the_programs_the_figure_waits_for_a_click(self):
        self.place('springs, explicit, h=0.1, break "slow": h=0.5')
        still = demos.demos_of(self.root, self.root / "chapters/01_euler/README.md")[0]["still"]
        self.write("build/docs/demos/demos.json", '{"%s": {"summary": "A <spring>", "width": 8, "height": 6}}' % still)
        page = self.page()
        for part in ('data-program="01_euler" data-scene="springs" data-methods="explicit" data-settings="h=0.1',
                     "data-break=\"&quot;slow&quot;||h=0.5\"", 'aria-label="Run the demo: A &lt;spring&gt;"',
                     'alt="A picture of a spring."', '<script src="demo.js" defer="defer">', "<b>Figure 1.1.</b>"):
            self.assertIn(part, page)

    def test_the_front_page_shows_a_frame_of_a_demo_for_a_chapter_that_has_one(self):
        page = '<td><img src="pictures/chapters/01_euler/figures/ch01_spring.svg" alt="A spring"/></td>'
        self.place("springs")
        self.assertEqual(finish_html.thumbnails(page, self.root), page)
        still = demos.demos_of(self.root, self.root / "chapters/01_euler/README.md")[0]["still"]
        self.write("build/docs/demos/demos.json", '{"%s": {"summary": "A <spring>"}}' % still)
        self.assertEqual(finish_html.thumbnails(page, self.root),
                         f'<td><img src="demos/{still}" alt="First frame of a demo: A &lt;spring&gt;"/></td>')
        other = page.replace("01_euler", "02_constraints")
        self.assertEqual(finish_html.thumbnails(other, self.root), other)

    def test_the_race_has_a_place_when_its_program_was_built_and_the_other_engine_when_it_is_there(self):
        self.change("chapters/01_euler/README.md", "## 1.2 Sources", "<!-- race -->\n\n## 1.2 Sources")
        self.assertNotIn('class="demo race"', self.page())
        self.write("build/docs/demos/race.js", "")
        page = self.page()
        self.assertIn('class="demo race"><', page)
        self.assertNotIn("box2d.js", page)
        self.write("build/docs/demos/box2d3_wasm.js", "")
        page = self.page()
        self.assertIn('class="demo race" data-peer=""><', page)
        self.assertIn('src="box2d.js"', page)

    def test_a_demo_is_run_as_a_command_and_with_its_idea_turned_off(self):
        self.place("springs, explicit, k=2, break off: h=0.5")
        demo = check_commands.demo_commands(self.root, self.root / "chapters/01_euler/README.md")
        self.assertEqual([words for _, _, words in demo],
                         [["--scene", "springs", "--headless", "--method", "explicit", "--set", "k=2"],
                          ["--scene", "springs", "--headless", "--method", "explicit", "--set", "k=2", "--h", "0.5"]])


class Sentences(Folder):
    """Sentences whose numbers can be dragged: how a text has them, and what becomes of them on the site."""

    COMMENT = "<!-- sentence: spring; h, the time step, from 0.1 to 2 by 0.1 s; shows a spring -->"
    WORDS = 'A step of <span data-slide="h">0.5</span> s gives <span data-value="energy 3">1.25</span> times $E$.'

    def place(self, comment=COMMENT, words=WORDS, models="rigid_sentence('spring', {});\n"):
        self.write("chapters/01_euler/sentence.js", models)
        self.change("chapters/01_euler/README.md", "## 1.1 From", f"{comment}\n{words}\n\n## 1.1 From")

    def test_a_sentence_without_fault(self):
        self.place()
        self.assertEqual(self.faults(), [])
        one, = sentences.sentences_of(self.root, self.root / "chapters/01_euler/README.md")
        self.assertEqual((one["model"], one["shows"], one["slides"], one["values"]), ("spring", "a spring", {"h": "0.5"}, [["energy 3", "1.25"]]))
        self.assertEqual(one["sliders"], [{"name": "h", "says": "the time step", "from": 0.1, "to": 2.0, "by": 0.1, "unit": "s", "value": 0.5}])

    def test_a_minus_and_thousands_are_numbers(self):
        self.assertEqual([sentences.number(one) for one in ("−1.5", "1,000", "7")], [-1.5, 1000, 7])

    def test_a_sentence_without_a_figure(self):
        self.place(comment="<!-- sentence: spring; h, the time step, from 0.1 to 2 by 0.1 s -->")
        self.fails("last what its figure 'shows")

    def test_a_range_that_is_none(self):
        self.place(comment="<!-- sentence: spring; h, the time step, from one to 2 by 0.1 s; shows a spring -->")
        self.fails("is a number to drag, not 'h, the time step, from one")

    def test_a_number_out_of_its_range_or_between_its_steps(self):
        for number in ("0.05", "2.5", "0.55"):
            with self.assertRaisesRegex(TextError, "not in its range"):
                comment, words = blocks(f"{self.COMMENT}\n{self.WORDS.replace('>0.5<', f'>{number}<')}")
                sentences.sentence_of(comment, words, "a:1")

    def test_a_number_that_is_not_dragged(self):
        self.place(words=self.WORDS.replace('"h"', '"k"'))
        self.fails("the paragraph drags ['k'], its comment ['h']")

    def test_a_comment_away_from_its_paragraph(self):
        self.place(comment=self.COMMENT + "\n")
        self.fails("right above its paragraph")

    def test_a_model_that_is_not_there(self):
        self.place(models="rigid_sentence('pendulum', {});\n")
        self.fails("sentence.js has no model spring")

    def test_other_html_is_still_a_fault(self):
        self.place(words=self.WORDS + ' <hr class="x"/>')
        self.fails("no HTML in the text: <hr")

    def test_its_words_are_counted_as_they_are_read(self):
        count = check_text.words_of(blocks(self.WORDS))
        self.assertEqual(count, len("A step of 0.5 s gives 1.25 times $E$.".split()))

    def test_the_site_gets_numbers_a_place_and_the_model(self):
        self.place()
        page = unpacked(Page(Book(self.root), self.root / "chapters/01_euler/README.md").text())
        for part in ('<script src="sentence_01_euler.js" defer="defer">', '<div class="sentence" data-sentence="{&quot;model&quot;: &quot;spring&quot;',
                     'A step of <span data-slide="h">0.5</span> s gives <span data-value="energy 3">1.25</span> times'):
            self.assertIn(part, page)


class Front(Folder):
    """The front page and the links to the neighbours, as the site shows them."""

    TABLE = ('<table class="markdownTable"><tr class="markdownTableHead"><th></th></tr><tr class="markdownTableRowOdd"><td class="x">'
             '<img src="{}" alt="A spring"/> </td><td class="x"><a class="el" href="ch01_euler.html">1. Euler</a> </td>'
             '<td class="x">Small <em>steps</em>. </td></tr></table>')

    def test_chapters_are_cards(self):
        page = "<head></head>" + self.TABLE.format("pictures/a.svg")
        self.assertEqual(finish_html.cards(page, self.root),
                         '<head></head><ul class="cards"><li class="card"><div class="card-picture"><img src="pictures/a.svg" alt="A spring"/></div>'
                         '<a class="el" href="ch01_euler.html">1. Euler</a><p>Small <em>steps</em>.</p></li></ul>')

    def test_a_card_knows_the_demo_whose_still_it_shows(self):
        self.write("chapters/01_euler/program/main.cpp", "int main() {}\n")
        self.change("chapters/01_euler/README.md", "![A picture", "<!-- demo: springs, explicit, h=0.1 -->\n![A picture")
        still = demos.demos_of(self.root, self.root / "chapters/01_euler/README.md")[0]["still"]
        page = finish_html.cards("<head></head>" + self.TABLE.format(f"demos/{still}"), self.root)
        self.assertIn('<li class="card" data-program="01_euler" data-scene="springs" data-methods="explicit" data-settings="h=0.1', page)
        self.assertIn('<script src="cards.js"', page)

    def test_other_tables_stay(self):
        table = '<table class="markdownTable"><tr class="markdownTableRowOdd"><td>a</td><td>b</td></tr></table>'
        self.assertEqual(finish_html.cards(table, self.root), table)

    def test_three_doors_and_play_leads_to_the_film_where_it_can_be_played(self):
        ways = "".join(f'<p ><b><a class="el" href="{one}.html">{one}</a></b>: so.</p>\n' for one in ("Play", "Read", "Use"))
        self.assertEqual(finish_html.doors(ways), f'<div class="doors">{ways.replace(": so", " So")}</div>')
        self.assertIn("Pull at the film above", finish_html.doors('<div class="demo"></div>' + ways))

    def test_the_neighbours_are_a_bar(self):
        line = '<p ><a class="anchor" id="md_a"></a> <a class="el" href="index.html">Contents</a> · <a class="el" href="b.html">Next: Rows</a></p>'
        self.assertEqual(finish_html.ways_on(line), '<a class="anchor" id="md_a"></a><nav class="ways-on" aria-label="Chapters">'
                         '<a class="el" href="index.html">Contents</a><a class="el" rel="next" href="b.html">Rows</a></nav>')
        # Doxygen leaves a blank before the end of a page's last paragraph
        self.assertEqual(finish_html.ways_on(line.replace("</p>", " </p>")), finish_html.ways_on(line))
        other = '<p ><a class="el" href="index.html">Contents</a> of a box</p>'
        self.assertEqual(finish_html.ways_on(other), other)


class Numbers(unittest.TestCase):
    """Chapters, sections, equations and figures with other numbers."""

    TEXTS = {
        "README.md": "| [1. One](chapters/01_one/README.md) | [2. Two](chapters/02_two/README.md#21-here) |\n",
        "chapters/01_one/README.md": "# Chapter 1. One\n\n## 1.1 There\n\n(1.2) of chapters 1 and 2, 1.2 m, h (1.2 s).\n\n"
                                     "![x](figures/ch01_x.svg)\n\n**Figure 1.1.** [Section 2.1](../02_two/README.md#21-here).\n",
        "chapters/01_one/figures/ch01_x.svg": "<svg>(1.2)</svg>\n",
        "chapters/02_two/README.md": "# Chapter 2. Two\n\n## 2.1 Here\n\n```math\nx \\tag{2.1}\n```\n\n"
                                     "Section 2.1, Figures 1.1 and 2.1: [2.1](#21-here), [1.1](../01_one/README.md#11-there).\n",
        "tests/01_one.cpp": "// (1.2), chapters/01_one, `./book run 1`, 1.2e3, f(1.5 * x), sqrt(1.2)\nint test_01_one;\n",
        "tests/table.csv": "name,chapter,value\na,1,1.2\nb,2,2.1\n",
    }

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name).resolve()
        for name, text in self.TEXTS.items():
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(text, encoding="utf-8")
        self.git("init", "-q")
        self.git("add", "-A")

    def tearDown(self):
        self.folder.cleanup()

    def git(self, *arguments):
        subprocess.run(["git", *arguments], cwd=self.root, check=True, capture_output=True)

    def now(self):
        return {str(path.relative_to(self.root)): path.read_text(encoding="utf-8")
                for path in self.root.rglob("*") if path.is_file() and ".git/" not in str(path)}

    def test_two_chapters_change_places_and_back(self):
        (self.root / "docs").mkdir()
        (self.root / redirects.LIST).write_text("09_old 01_one\n", encoding="utf-8")
        self.git("add", "-A")
        renumber.renumber(self.root, {1: 2, 2: 1}, {})
        there = self.now()
        self.assertEqual(there.pop("docs/redirects.txt"), "09_old 02_one\n01_one 02_one\n02_two 01_two\n")
        (self.root / redirects.LIST).unlink()
        self.assertEqual(there["README.md"],
                         "| [2. One](chapters/02_one/README.md) | [1. Two](chapters/01_two/README.md#11-here) |\n")
        self.assertEqual(there["chapters/02_one/README.md"],
                         "# Chapter 2. One\n\n## 2.1 There\n\n(2.2) of chapters 2 and 1, 1.2 m, h (1.2 s).\n\n"
                         "![x](figures/ch02_x.svg)\n\n**Figure 2.1.** [Section 1.1](../01_two/README.md#11-here).\n")
        self.assertEqual(there["tests/02_one.cpp"],
                         "// (2.2), chapters/02_one, `./book run 2`, 1.2e3, f(1.5 * x), sqrt(1.2)\nint test_02_one;\n")
        self.assertEqual(there["tests/table.csv"], "name,chapter,value\na,2,1.2\nb,1,2.1\n")
        self.assertEqual(there["chapters/02_one/figures/ch02_x.svg"], "<svg>(1.2)</svg>\n")  # a program draws it
        self.git("add", "-A")
        renumber.renumber(self.root, {1: 2, 2: 1}, {})
        self.assertEqual(self.now(), self.TEXTS)

    def test_links_follow_a_section_that_moves(self):
        one, two = self.root / "chapters/01_one/README.md", self.root / "chapters/02_two/README.md"
        one.write_text(one.read_text(encoding="utf-8") + "\n## 2.1 Here\n\n```math\nx \\tag{2.1}\n```\n", encoding="utf-8")
        two.write_text("# Chapter 2. Two\n\n(2.1) in [section 2.1](#21-here).\n", encoding="utf-8")
        renumber.renumber(self.root, {}, {("section", "2.1"): "1.2", ("equation", "2.1"): "1.3"})
        self.assertIn("\n## 1.2 Here\n\n```math\nx \\tag{1.3}", self.now()["chapters/01_one/README.md"])
        self.assertIn("[Section 1.2](README.md#12-here)", self.now()["chapters/01_one/README.md"])
        self.assertIn("(1.3) in [section 1.2](../01_one/README.md#12-here).", self.now()["chapters/02_two/README.md"])
        self.assertIn("(chapters/01_one/README.md#12-here)", self.now()["README.md"])

    def test_a_number_that_is_taken_is_refused(self):
        with self.assertRaisesRegex(TextError, "the same number"):
            renumber.renumber(self.root, {1: 2}, {})
        self.assertEqual(self.now(), self.TEXTS)


class Redirects(unittest.TestCase):
    """Old addresses of chapters."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name).resolve()
        for name in ("chapters/02_one", "chapters/03_two", "docs", "site"):
            (self.root / name).mkdir(parents=True)
        for name in ("02_one", "03_two"):
            (self.root / "chapters" / name / "README.md").write_text("# A chapter\n", encoding="utf-8")
            (self.root / "site" / f"ch{name}.html").write_text("", encoding="utf-8")
        (self.root / "site/ch03_two_in_depth.html").write_text("", encoding="utf-8")
        (self.root / "site/index.html").write_text("", encoding="utf-8")

    def tearDown(self):
        self.folder.cleanup()

    def list(self, text):
        (self.root / redirects.LIST).write_text(text, encoding="utf-8")

    def test_each_old_address_leads_to_a_page_that_is_there(self):
        self.list("# old and new\n01_one 02_one\n02_two 03_two\n")
        self.assertEqual(redirects.write(self.root, self.root / "site"), 4)
        leads = {path.name: re.search(r'url=([^"]*)"', path.read_text(encoding="utf-8"))
                 for path in (self.root / "site").glob("*.html")}
        self.assertEqual({name: to[1] for name, to in leads.items() if to},
                         {"ch01_one.html": "ch02_one.html", "ch01_one_in_depth.html": "ch02_one.html", "ch02_two.html": "ch03_two.html",
                          "ch02_two_in_depth.html": "ch03_two_in_depth.html"})
        self.assertIn(">chapter 3, two, in depth</a>", (self.root / "site/ch02_two_in_depth.html").read_text(encoding="utf-8"))
        self.assertEqual(check_html.check(self.root / "site"), [])

    def test_a_list_that_leads_nowhere_is_refused(self):
        for text, why in (("01_one\n", "is not the old and the present name"), ("01_one 04_none\n", "no such chapter"),
                          ("02_one 03_two\n", "a chapter of today"), ("01_one 02_one\n01_one 03_two\n", "twice")):
            self.list(text)
            with self.assertRaisesRegex(TextError, why):
                redirects.read_list(self.root)

    def test_a_page_that_the_site_lacks_is_refused(self):
        self.list("01_one 02_one\n")
        (self.root / "site/ch02_one.html").unlink()
        with self.assertRaisesRegex(TextError, "has no ch02_one.html"):
            redirects.write(self.root, self.root / "site")

    def test_the_list_follows_chapters_that_move(self):
        there = redirects.followed("# old\n01_one 02_one\n", {"02_one": "03_one", "03_two": "02_two"})
        self.assertEqual(there, "# old\n01_one 03_one\n02_one 03_one\n03_two 02_two\n")
        back = redirects.followed(there, {"03_one": "02_one", "02_two": "03_two"})
        self.assertEqual(back, "# old\n01_one 02_one\n02_two 03_two\n03_one 02_one\n")


class Paper(unittest.TestCase):
    PAGE = ('<div class="title">Chapter 1. Euler </div><div class="contents"><div class="textblock"><link href="demo.css" rel="stylesheet"/>'
            '<script src="demo.js"></script><nav class="ways-on"><a href="index.html">Contents</a></nav><h1><a class="anchor" id="s11"></a>\n1.1 Two</h1>'
            '<div class="demo"><div class="figure"><img src="a.svg"/></div><div class="demo-begin"><button>Run</button></div></div>'
            '<a class="el" href="ch02.html#eq_2_1">(2.1)</a> <a class="el" href="#s11">here</a> <a class="el" href="ch02.html">two</a> '
            '<a class="el" href="row_8hpp.html"><code>row.hpp</code></a> <a href="https://example.org">out</a>'
            "<details><summary>S</summary>1</details></div></div><!-- contents -->")

    def test_a_page_on_paper(self):
        title, content, sections = print_pages.inside("ch01", self.PAGE, {"ch01", "ch02"})
        self.assertEqual((title, sections), ("Chapter 1. Euler", [("s11", "1.1 Two")]))
        for part in ("<h2><a", '<a class="el" href="#eq_2_1">(2.1)</a>', '<a class="el" href="#s11">here</a>', '<a class="el" href="#page_ch02">two</a>',
                     " <code>row.hpp</code> ", '<a href="https://example.org">out</a>', '<details open="open">', '<img src="a.svg"/>'):
            self.assertIn(part, content)
        for part in ("<script", "<link", "<nav", "<button", "demo-begin"):
            self.assertNotIn(part, content)


class OddCalls(Folder):
    """Each tool ends with a sentence and not with a traceback, and what is not there does not pass."""

    def called(self, tool, *arguments, out=subprocess.PIPE):
        tools = pathlib.Path(__file__).resolve().parent
        done = subprocess.run([sys.executable, "-B", str(tools / tool), *arguments], stdout=out,
                              stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True, cwd=self.root)
        self.assertNotIn("Traceback", done.stderr, (tool, arguments))
        self.assertNotIn("Exception", done.stderr, (tool, arguments))
        return done.returncode, done.stderr

    def refused(self, tool, *arguments, **more):
        code, said = self.called(tool, *arguments, **more)
        self.assertNotEqual(code, 0, (tool, arguments))
        self.assertNotEqual(said.strip(), "", (tool, arguments))

    def test_the_address_of_the_site(self):
        place = "# Book\n\n<!-- play -->\n%s\n<!-- /play -->\n\n[One](chapters/01_euler/README.md)\n\n## Put it on the web\n"
        self.write("README.md", place % "x")
        self.assertEqual(self.called("site_address.py", "https://a.org/b/", "--root", str(self.root))[0], 0)
        self.assertIn("\n**[Play](https://a.org/b/)**", self.read("README.md"))
        self.assertEqual(self.faults(), [])
        self.assertEqual(self.called("site_address.py", "none", "--root", str(self.root))[0], 0)
        self.assertEqual(self.read("README.md"), place % site_address.NOWHERE)
        self.assertEqual(self.faults(), [])
        for wrong in ("a.org", "https://a.org/(b)", "https://a org", ""):
            self.refused("site_address.py", wrong, "--root", str(self.root))
        self.write("README.md", "# Book\n")
        self.refused("site_address.py", "none", "--root", str(self.root))

    def test_a_root_that_is_missing_or_no_book(self):
        self.write("empty/file", "")
        for tool in ("check_text.py", "sync_snippets.py"):
            for root in ("nowhere", "empty", "README.md"):
                self.refused(tool, "--root", root)
        self.refused("sync_snippets.py", "--check", "--root", "nowhere")
        self.refused("check_commands.py", ".", "--root", "nowhere")

    def test_arguments_that_are_missing_or_too_many(self):
        for tool in ("check_html.py", "finish_html.py", "doxygen_filter.py", "check_commands.py", "check_limits.py"):
            self.refused(tool)
            self.refused(tool, "a", "b", "c")
        for tool in ("check_text.py", "sync_snippets.py"):
            self.refused(tool, "a")
            self.refused(tool, "--root")

    def test_files_and_folders_that_are_not_what_they_should_be(self):
        self.write("site/index.html", "")
        self.write("tags", "no tags")
        for call in (("check_html.py", "nowhere"), ("check_html.py", "README.md"), ("finish_html.py", "nowhere", "tags"),
                     ("finish_html.py", "site", "nowhere"), ("finish_html.py", "site", "tags"),
                     ("doxygen_filter.py", "nowhere"), ("doxygen_filter.py", "site"), ("doxygen_filter.py", "README.md"),
                     ("check_limits.py", "nowhere"), ("check_limits.py", ".", "README"),
                     ("check_commands.py", "nowhere"), ("check_commands.py", "README.md")):
            self.refused(*call)

    def test_a_text_that_is_no_text(self):
        (self.root / "chapters/01_euler/README.md").write_bytes(b"# Chapter 1. \xff\xfe\n")
        self.refused("check_text.py", "--root", str(self.root))
        self.refused("sync_snippets.py", "--root", str(self.root))
        self.refused("check_commands.py", str(self.root), "--root", str(self.root))

    @unittest.skipUnless(pathlib.Path("/dev/full").exists(), "needs /dev/full")
    def test_a_full_disk(self):
        book = pathlib.Path(__file__).resolve().parents[2]
        self.write("chapters/01_euler/step.hpp", STEP.replace("x", "y"))
        with open("/dev/full", "w", encoding="utf-8") as full:
            self.refused("doxygen_filter.py", str(book / "README.md"), out=full)
            self.refused("sync_snippets.py", "--root", str(self.root), out=full)


class Reading(unittest.TestCase):
    def test_slugs_are_those_of_github(self):
        self.assertEqual(slug("1.1 From Newton's law to a step"), "11-from-newtons-law-to-a-step")
        seen = {}
        self.assertEqual([slug("Run it", seen), slug("Run it", seen)], ["run-it", "run-it-1"])

    def test_tokens(self):
        kinds = [(t.kind, t.text) for t in tokens("a $x$ `$y$` \\$ $`z|`$ [b](c) ![d](e) [[k]](r/references.bib) $5")]
        self.assertEqual([k for k in kinds if k[0] != "words"],
                         [("math", "$x$"), ("code", "`$y$`"), ("escape", "\\$"), ("math", "$`z|`$"),
                          ("link", "[b](c)"), ("image", "![d](e)"), ("cite", "[[k]](r/references.bib)")])

    def test_comments_of_cpp(self):
        source = 'auto a = "// (1.1)"; // (1.2)\nauto b = R"x(// (1.3))x"; /* (1.4)\n(1.5) */ auto c = 1\'000; // d'
        self.assertEqual(comments(source), [(1, "// (1.2)"), (2, "/* (1.4)"), (3, "(1.5) */"), (3, "// d")])

    def test_names_of_tests(self):
        self.assertEqual(test_names('TEST_CASE("a "\n  "b")\n{ SECTION("c") {} }'), [(1, "a b"), (3, "c")])

    def test_a_fence_without_end_is_refused(self):
        with self.assertRaises(TextError):
            blocks("```\ncode")


if __name__ == "__main__":
    unittest.main()
