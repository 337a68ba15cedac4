#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The checkers of pages find faults: each is given a small project with one, and one without.

pages_test.py
"""
import contextlib
import io
import json
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "tools" / "docs")]

import links_test
import names_test
import quoted_numbers as quoted
import sentences_test

TABLE = "<!--table t-->\n| level | `vlc`, time | range |\n|---|---|---|\n| `a` | **0.30** | 1.5 [1.2, 2.5] |\n"
OF_TABLE = "docs/t.md 0.30 1.5 1.2 2.5 # the table above\n"
LONG = "word " * (sentences_test.LIMIT + 1)


class Pages(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name).resolve()
        self.addCleanup(self.folder.cleanup)
        self.write("docs/results/full/quality.json", json.dumps({"parts": [{"part": "w", "rows": [
            {"label": "vlc", "mse": {"value": 0.1234, "ratio": {"value": 374.2}}}]}]}))
        self.write("docs/results/card/quality.json", json.dumps({"parts": [{"part": "w", "rows": [{"label": "vlc", "ms": 7.5}]}]}))

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def run_quietly(self, function, *arguments):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            status = function(*arguments)
        return status, said.getvalue()

    def numbers(self, text, *options, exceptions=""):
        self.write("README.md", text)
        self.write("docs/t.md", TABLE)
        self.write("tests/structure/numbers_exceptions", OF_TABLE + exceptions)
        return self.run_quietly(quoted.main, [*options, str(self.root)])

    def links(self):
        return self.run_quietly(links_test.main, self.root, self.root / "exceptions")

    def longest(self, text):
        self.write("README.md", text)
        return [sentence for _, block in sentences_test.blocks(text) for sentence in sentences_test.sentences(block)
                if len(sentences_test.words(sentence)) > sentences_test.LIMIT]


class Numbers(Pages):
    def test_fills_tables_and_reports(self):
        status, _ = self.numbers("It is <!--n t/a/vlc, time-->x<!--/n--> <!--n t/a/range/2-->x<!--/n--> <!--n t/a/range/all-->x<!--/n--> "
                                 "<!--n quality:w/vlc/mse; 2-->x<!--/n--> <!--n quality:w/vlc/mse.ratio-->x<!--/n--> "
                                 "<!--n card.quality:w/vlc/ms-->x<!--/n--> <!--n quality:w/vlc/mse.ratio over w/vlc/mse; 2-->x<!--/n--> "
                                 "<!--n t/a/vlc, time; 0%-->x<!--/n--> <!--n t/a/vlc, time; 1/2-->x<!--/n-->")
        self.assertEqual(status, 0)
        text = (self.root / "README.md").read_text()
        self.assertEqual(quoted.plain(text), "It is 0.30 1.2 1.5 [1.2, 2.5] 0.12 374 7.5 3,032 30% 3.3")

    def test_fills_defaults_of_variables(self):
        self.write("docs/play/cvars.md", "| `pt_a` | `0.03` | 0 | help |\n| `pt_b` | `auto` | | help |\n")
        status, _ = self.numbers("<!--n cvar:pt_b-->x<!--/n--> is <!--n cvar:pt_a-->x<!--/n-->")
        self.assertEqual(status, 1)  # a mark begins the line
        self.assertEqual(quoted.plain((self.root / "README.md").read_text()), "auto is 0.03")
        self.assertIn("no number cvar:pt_c", self.numbers("is <!--n cvar:pt_c-->1<!--/n-->", "--check")[1])

    def test_notices_another_number(self):
        status, said = self.numbers("is <!--n t/a/vlc, time-->0.31<!--/n-->", "--check")
        self.assertEqual(status, 1)
        self.assertIn("is 0.30, not 0.31", said)
        self.assertIn("0.31", (self.root / "README.md").read_text())

    def test_notices_keys_that_lead_nowhere(self):
        for key in ("t/b/vlc, time", "t/a/lh", "u/a/lh", "t/a/vlc, time/2", "quality:w/lh/mse", "quality:w/vlc/no", "none:w/vlc/mse"):
            status, said = self.numbers(f"is <!--n {key}-->1<!--/n-->", "--check")
            self.assertEqual(status, 1, key)
            self.assertIn(key, said)

    def test_notices_marks_that_begin_a_line(self):
        self.assertIn("begins the line", self.numbers("word\n<!--n t/a/vlc, time-->0.30<!--/n-->", "--check")[1])

    def test_notices_numbers_without_a_source(self):
        self.assertEqual(self.numbers("It is 0.5 times as fast.", "--check")[0], 1)
        self.assertEqual(self.numbers("It takes 5% of `0.5`, in Vulkan 1.2.", "--check")[0], 1)
        self.assertEqual(self.numbers("Vulkan 1.2, `0.5`\n\n    0.5\n", "--check")[0], 0)
        self.assertEqual(self.numbers("| 1 | 2 |\n|---|---|\n| 3 | `4` |\n", "--check")[0], 0)
        self.assertEqual(self.numbers("| 1 | 2 |\n|---|---|\n| 3 | 4 |\n", "--check")[0], 1)

    def test_notices_them_on_every_page(self):
        self.write("docs/learn/a.md", "0.5\n")
        self.assertIn("docs/learn/a.md: 0.5 has no source", self.numbers("none", "--check")[1])

    def test_exceptions_must_be_needed_and_have_reasons(self):
        for line, status in (("README.md 0.5 # a constant", 0), ("README.md 0.5", 1), ("README.md 0.5 0.6 # a constant", 1),
                             ("docs/u.md 0.5 # a constant", 1), ("# nothing", 1)):
            self.assertEqual(self.numbers("It is 0.5.", "--check", exceptions=line + "\n")[0], status, line)


class Links(Pages):
    def test_notices_dead_links_paths_and_places(self):
        self.write("docs/t.md", "# Title\n\n## One two\n")
        self.write("README.md", "[t](docs/t.md) [t](docs/t.md#one-two)\n")
        self.assertEqual(self.links()[0], 0, self.links()[1])
        for text in ("[x](docs/x.md)", "![x](x.png)", "[t](docs/t.md#three)", "see docs/x.md"):
            self.write("README.md", "[t](docs/t.md) " + text)
            self.assertEqual(self.links()[0], 1, text)

    def test_notices_pages_that_nobody_links(self):
        self.write("docs/t.md", "# Title\n")
        self.write("README.md", "nothing\n")
        self.assertIn("no page links to it", self.links()[1])

    def test_exceptions_must_be_needed_and_have_reasons(self):
        self.write("README.md", "see docs/x.md")
        self.write("exceptions", "README.md docs/x.md # to come\n")
        self.assertEqual(self.links()[0], 0)
        self.write("exceptions", "README.md docs/x.md\n")
        self.assertEqual(self.links()[0], 1)
        self.write("exceptions", "README.md docs/x.md # to come\nREADME.md docs/y.md # to come\n")
        self.assertEqual(self.links()[0], 1)


class Sentences(Pages):
    def test_counts_paragraphs_items_and_cells(self):
        for text in (LONG, f"Short. {LONG}", f"- {LONG}", f"- word\n  {LONG}", f"| {LONG} | b |", f"## {LONG}"):
            self.assertEqual(len(self.longest(text)), 1, text)

    def test_notices_text_that_joins_a_table(self):
        self.assertEqual(sentences_test.joined_to_tables("| a |\n|---|\n| b |\ntext\n"), [4])
        self.assertEqual(sentences_test.joined_to_tables("| a |\n|---|\n| b |\n\ntext\n"), [])

    def test_leaves_out_code_marks_and_numbers(self):
        half = "word " * (sentences_test.LIMIT // 2)
        for text in (f"    {LONG}", f"```\n{LONG}\n```", f"<!--{LONG}-->", f"a `{LONG}`", f"{half}. {half}.", f"- {half}\n- {half}",
                     f"| {half} | {half} |"):
            self.assertEqual(self.longest(text), [], text)


class Names(Pages):
    def names(self, text):
        self.write("docs/play/cvars.md", "| `pt_nee` | `vlc` |\n")
        self.write("docs/learn/lesson.md", "Type\n\n    pt_nee sll\n    vlcinfo\n")
        self.write("src/client/commands.cpp", '{"vlcinfo", ": prints"}, {"pt_preset", ": sets"}')
        self.write("README.md", text)
        return self.run_quietly(names_test.main, self.root)

    def test_notices_variables_and_commands_that_do_not_exist(self):
        self.assertEqual(self.names("`pt_nee`, `pt_preset` and `pt_...`")[0], 0)
        self.assertIn("no variable pt_no", self.names("`pt_no 1`")[1])
        self.names("word")
        self.write("docs/learn/lesson.md", "Type\n\n    vlcinf\n")
        self.assertIn("nobody can type vlcinf", self.run_quietly(names_test.main, self.root)[1])

    def test_notices_acronyms_that_are_not_explained(self):
        self.assertIn("MSE is not explained", self.names("The MSE is small.")[1])
        self.assertEqual(self.names("The mean squared error (MSE) is small.")[0], 0)
        self.assertEqual(self.names("The MSE is small ([glossary](glossary.md)).")[0], 0)


if __name__ == "__main__":
    unittest.main()
