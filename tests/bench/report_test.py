#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What tools/report says of reports: marks, intervals that older reports lose, and pages that contradict their data."""

import contextlib
import copy
import io
import json
import re
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools" / "report"))

import agreement
import colors
import defaults
import economy_page
import kept
import levels
import rivals
import summary
import tables


def row(label, time=1.0, product=1.0, p=1.0, plain=None):
    """A value's row: `product` is its time x error, `plain` the same of all pixels."""
    interval = {"value": product, "low": 0.9 * product, "high": 1.1 * product, "p": p}

    def error(at_equal_time):
        return {"value": 1.0, "ratio": {"value": at_equal_time / time}, "typical": dict(interval),
                "ratio_at_equal_time": {"value": at_equal_time}, "typical_at_equal_time": dict(interval)}

    return {"label": label, "mse": error(plain or product), "trimmed_mse": error(product),
            "frame_ms": {"value": 1.0, "ratio": {"value": time, "low": time, "high": time, "p": 1.0}}}


def report(measured, parts, **more):
    """Rows by the name of their part."""
    return {"measured": measured, "finished": True, "intervals": "typical runs", "device": "none", "commit": "abc", "key": measured,
            "width": 1, "height": 1, "seeds": 2, "first_seed": 1,
            "parts": [{"part": name, "level": name.split()[0], "baseline": "base", "views": [{}] * 4, "seeds": 6, "first_seed": 1001,
                       "rows": [row("base"), *rows]} for name, rows in parts.items()]} | more


class Pictures(unittest.TestCase):
    def test_a_table_has_the_columns_of_its_part(self):
        def measure(value, ratio):
            return {"median": {"value": value, "low": None, "high": None}, "ratio": {"value": ratio}}

        part = {"part": "warehouse lamp", "baseline": "raw",
                "columns": [{"name": "mse", "heading": "MSE", "has_ratio": True}, {"name": "lag", "heading": "lag", "has_ratio": False},
                            {"name": "none", "heading": "nothing", "has_ratio": True}],
                "rows": [{"label": "raw", "mse": measure(0.5, 1.0), "lag": measure(1.0, 1.0)},
                         {"label": "full", "mse": measure(0.25, 0.5), "lag": measure(None, None)}]}
        (head, lines), = tables.picture({"parts": [part]})
        self.assertEqual(head, ["warehouse lamp", "MSE (/ raw)", "lag", "nothing (/ raw)"])
        self.assertEqual(lines, [["raw", "0.5 (1)", "1", ""], ["full", "0.25 (0.5)", "?", ""]])


class Statistics(unittest.TestCase):
    def test_ranks_are_those_of_the_sign_test(self):
        for count, rank in ((8, 1), (16, 4), (24, 7), (32, 10)):
            runs = list(range(1, count + 1))
            found = tables.typical_run([runs[i::4] for i in range(4)])
            self.assertEqual((found["value"], found["low"], found["high"]), (0.5 * (count + 1), rank, count + 1 - rank))
        self.assertIsNone(tables.typical_run([[1, 2], [3, 4], [5, 6]])["low"])  # three views
        self.assertIsNone(tables.typical_run([[1], [2], [3], [4]])["low"])  # four runs

    def test_marks_go_by_holm(self):
        chances = {"a": 0.03, "b": 0.01, "c": None, "d": 0.04, "e": 0.012}
        self.assertEqual(tables.standing_out(chances), {"b", "e"})
        self.assertEqual(tables.standing_out({"a": 0.02, "b": 0.02, "c": 0.02}), set())

    def test_agreement_is_a_rank_sum_test(self):
        low, high = [[1, 2, 3, 4]] * 4, [[5, 6, 7, 8]] * 4
        # Sum of ranks 10 of 18 +- sqrt(12) a view.
        self.assertAlmostEqual(agreement.chance(low, high), 2 * agreement.statistics.NormalDist().cdf(-31.5 / 48**0.5))
        self.assertGreater(agreement.chance([[1, 4, 5, 8]] * 4, [[2, 3, 6, 7]] * 4), 0.9)
        self.assertEqual(agreement.rank_sum([1, 1], [1, 2]), (4.0, 5.0, 1.0))  # three share rank 2
        self.assertIsNone(agreement.chance([[1, 1]], [[1, 1]]))


class OlderReports(unittest.TestCase):
    def test_lose_intervals_of_means_and_keep_those_of_times_over_four_views(self):
        interval = {"value": 2.0, "low": 1.0, "high": 3.0}
        part = {"part": "x", "views": [{}] * 4, "rows": [
            {"label": "a", "mse": interval | {"ratio": dict(interval)}, "frame_ms": interval | {"ratio": dict(interval)}}]}
        older = {"measured": "quality", "finished": True, "parts": [part, copy.deepcopy(part) | {"views": [{}] * 2}]}
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "quality.json"
            path.write_text(json.dumps(older))
            first, second = (part["rows"][0] for part in tables.load(path, "quality")["parts"])
        for value in (first["mse"], first["mse"]["ratio"], first["frame_ms"], second["frame_ms"]["ratio"]):
            self.assertEqual((value["value"], value["low"], value["high"]), (2.0, None, None))
        self.assertEqual(first["frame_ms"]["ratio"], interval)


class Tables(unittest.TestCase):
    def test_mark_what_stands_out_among_all_of_them(self):
        # 0.02 is enough for one comparison, not for four.
        one = report("quality", {"x": [row("a", product=0.5, p=0.02)]})
        four = report("quality", {"x": [row("a", product=0.5, p=0.02), *(row(name) for name in "bcd")]})
        for shown, text in ((one, "0.5; **0.5** [0.45, 0.55]"), (four, "0.5 [0.45, 0.55]")):
            _, lines = tables.by_technique("", shown["parts"], tables.MEASURES[2][1])
            self.assertIn(text, lines[0][2])
        self.assertNotIn("**", lines[0][2])


class Rivals(unittest.TestCase):
    """Rows of four views with two seeds, the same in each."""

    PRODUCT = ("mse", "frame_ms")

    def row(self, label, error, time, **more):
        def runs(value):
            return {"by_view_and_seed": [[value, value]] * 4}

        return {"label": label, "mse": runs(error), "trimmed_mse": runs(0.5 * error), "frame_ms": runs(time)} | more

    def part(self, *rows):
        return {"part": "x", "rows": list(rows)}

    def test_the_best_one_has_the_least_error_times_time(self):
        part = self.part(self.row("a", 3, 2), self.row("fast", 9, 0.5), self.row("exact", 1, 5), self.row("poor", 9, 2))
        self.assertEqual(rivals.best_rival(part, "a", [], self.PRODUCT), ("fast", {"value": 6 / 4.5, "low": 6 / 4.5, "high": 6 / 4.5}))
        self.assertEqual(rivals.best_rival(part, "a", ["exact", "poor"], self.PRODUCT)[0], "exact")
        head, lines = rivals.table([part, part], "a", [])
        self.assertEqual(head, ["level", "best other", "Trimmed MSE", "best other", "MSE"])
        self.assertEqual(lines[0], ["`x`", "`fast`", "1.33", "`fast`", "1.33"])
        self.assertEqual(lines[2], ["geometric mean", "", "1.33", "", "1.33"])

    def test_rows_that_miss_light_are_no_rivals(self):
        part = self.part(self.row("a", 3, 1), self.row("blind", 1, 1, misses_light=True), self.row("b", 6, 1))
        self.assertEqual(rivals.best_rival(part, "a", [], self.PRODUCT)[0], "b")
        self.assertIsNone(rivals.best_rival(part, "a", ["blind"], self.PRODUCT))
        self.assertEqual(rivals.table([part], "a", ["blind", "blind"])[1][0], ["`x`", "", "?", "", "?"])
        self.assertEqual(rivals.table([part], "a", ["blind"]), (["level", "Trimmed MSE", "MSE"], [["`x`", "?", "?"], ["geometric mean", "?", "?"]]))

    def test_what_is_compared_may_be_a_time_alone(self):
        part = self.part(self.row("a", 3, 2), self.row("b", 9, 4))
        self.assertEqual(rivals.table([part], "a", ["b"], (("Time", ("frame_ms",)),)), (["level", "Time"], [["`x`", "0.5"], ["geometric mean", "0.5"]]))

    def test_unknown_rows_are_named(self):
        with self.assertRaisesRegex(ValueError, "x: no row c"):
            rivals.best_rival(self.part(self.row("a", 1, 1)), "a", ["c"], self.PRODUCT)


class Levels(unittest.TestCase):
    def report(self, *labels):
        def row(label):
            runs = {"by_view_and_seed": [[1.23456, 1.0]] * 4, "value": 1.0, "typical": {"value": 0.5, "p": 1.0}, "typical_at_equal_time": {"value": 0.25, "p": 1.0},
                    "ratio": {"value": 0.5, "p": 1.0}, "ratio_at_equal_time": {"value": 0.25}, "median": {"value": 1.0}}
            measures = ("mse", "trimmed_mse", "relative_mse", "mean_ratio", "path_ms", "frame_ms")
            return {"label": label, "misses_light": False, "pass_ms": {}} | {name: runs for name in measures}

        return report("quality", {}) | {"parts": [{"part": "x", "level": "x", "baseline": "sll", "rows": [row(label) for label in labels]}]}

    def test_tables_have_all_rows_in_the_order_of_the_page(self):
        joined = levels.join(None, self.report("preset paper", *reversed(levels.ROWS[:7]), "vlc+cdq", "vlc"))
        self.assertEqual([row["label"] for row in joined["parts"][0]["rows"]], list(levels.ROWS))
        self.assertNotIn("pass_ms", joined["parts"][0]["rows"][0])
        self.assertEqual(joined["parts"][0]["rows"][0]["mse"]["by_view_and_seed"][0][0], 1.235)
        found = levels.page_tables(joined)
        self.assertTrue(found["levels-plain"].startswith("| MSE at equal time | `sll_64` | `sll_256` |"))
        self.assertIn("| `x` | 0.25 | 0.25 |", found["levels-plain"])
        self.assertIn("| `x` | 1 | 1 | 1 |", found["levels-guided"])

    def test_a_missing_row_is_named(self):
        with self.assertRaisesRegex(ValueError, "x: no row paper, vlc$"):
            levels.join(None, self.report(*levels.ROWS[:7], "vlc+cdq"))

    def test_a_level_takes_the_place_of_its_former_self(self):
        first, again = self.report(*levels.ROWS), self.report(*levels.ROWS) | {"commit": "def"}
        other = self.report(*levels.ROWS)
        other["parts"][0]["part"] = "y"
        joined = levels.join(levels.join(levels.join(None, first), other), again)
        self.assertEqual([(part["part"], part["commit"]) for part in joined["parts"]], [("x", "def"), ("y", "abc")])

    def test_levels_are_measured_alike(self):
        joined = levels.join(None, self.report(*levels.ROWS))
        with self.assertRaisesRegex(ValueError, "^width is 2, and 1 in "):
            levels.join(joined, self.report(*levels.ROWS) | {"width": 2})
        with self.assertRaisesRegex(ValueError, "not finished"):
            levels.join(joined, self.report(*levels.ROWS) | {"finished": False})

    def test_tables_are_put_where_the_page_has_their_names(self):
        page = "# A\n\n<!--table a-->\n| old |\n| --- |\n\n<!--table b-->\n| kept |\n\nText\n"
        self.assertEqual(levels.fill(page, {"a": "| new |\n"}), page.replace("| old |\n| --- |\n", "| new |\n"))
        with self.assertRaisesRegex(ValueError, "no table c"):
            levels.fill(page, {"c": "| new |\n"})


class Economy(unittest.TestCase):
    """Two levels, of which one has a sky."""

    def row(self, label, time=(1.0, 1.0, 1.0), compile_s=10.0, code=1000):
        interval = dict(zip(("value", "low", "high"), time))
        return {"label": label, "variables": {"pt_nee": "vlc", "pt_guide": "cdq", "pt_features": label},
                "path_ms": {"ratio": interval, "frames": [2.0, 4.0]}, "frame_ms": {"ratio": interval, "frames": [3.0]},
                "prepare_ms": {"share_of_path": interval, "frames": [1.0]}, "pass_frames_ms": {"octree_mark": [1.0]},
                "passes": [{"name": "primary", "median_ms": 2.0, "mean_ms": 2.0, "share": 0.5, "ratio": interval}],
                "shaders": [{"name": "primary"}], "compile_s": {"value": compile_s}, "code_bytes": {"value": code},
                "memory_bytes": {"value": 3 * 2**20, "by": {"octree nodes": 2**20, "bottom-level nodes": 2**21}},
                "upload_bytes": {"value": 800.0}, "still_upload_bytes": {"value": 400.0, "by": {"frame parameters": 376, "lights": 24}}}

    def part(self, level, features, rows, same):
        return {"part": level, "level": level, "baseline": "auto", "features": features, "same_as_auto": same, "rows": rows}

    def report(self, **sky):
        without = self.part("cave", ["lights"], [self.row("auto"), self.row("all", (1.2, 1.1, 1.3), 20.0, 2000), self.row("sky", **sky)], ["lights"])
        having = self.part("hill", ["lights", "sky"], [self.row("auto"), self.row("all", (1.3, 1.2, 1.4), 20.0, 2000)], ["lights", "sky"])
        return {"measured": "economy", "finished": True, "intervals": "typical runs", "device": "none", "commit": "abc", "width": 1, "height": 1,
                "seeds": 6, "warmup": 12, "key": "k", "planned": {}, "parts": [without, having]}

    def conclusion(self, **sky):
        return economy_page.conclusion(self.report(**sky)["parts"], "sky")

    def test_a_conclusion_says_what_a_constant_saves(self):
        self.assertIn("saves time of frames", self.conclusion(time=(1.1, 1.05, 1.2)))
        self.assertIn("saves time to compile, and none", self.conclusion(time=(1.1, 0.95, 1.2), compile_s=12.0))
        self.assertIn("saves code alone", self.conclusion(time=(0.9, 0.8, 0.95), code=1010))
        self.assertIn("saves nothing", self.conclusion(time=(0.99, 0.9, 1.1)))
        text = self.conclusion(time=(1.1, 1.05, 1.2), compile_s=12.0, code=1500)
        for said in ("1 of 2 levels", "10.0% more time", "slower for certain in `cave`", "20.0% more time to compile", "50.0% more"):
            self.assertIn(said, text)
        self.assertNotIn("All features together", text)
        self.assertIn("All features together cost 20.0% more", self.conclusion(time=(1.5, 1.4, 1.6)))
        self.assertIn("no level here can tell", economy_page.conclusion(self.report()["parts"], "lights"))

    def test_chance_is_asked_for_more_among_many_levels(self):
        self.assertEqual([economy_page.least_slower(levels) for levels in (1, 2, 3, 14, 15)], [1, 1, 2, 2, 3])

    def test_means_are_over_all_levels(self):
        head, lines = economy_page.overview(self.report()["parts"])
        self.assertEqual(lines[-1][0], "geometric mean")
        self.assertEqual(lines[-1][head.index("frame, all over auto")], "1.25")
        self.assertEqual(lines[-1][head.index("compile, all over auto")], "2")

    def test_memory_is_summed_by_kind(self):
        head, lines = economy_page.memory(self.report()["parts"])
        cells = dict(zip(head, lines[0]))
        self.assertEqual((cells["guiding"], cells["geometry"], cells["all"]), ("1.0", "2.0", "3.0"))
        self.assertEqual([economy_page.kind_of(name) for name in ("light caches", "light samples", "lights", "filter light", "unused", "top-level instances")],
                         ["guiding", "guiding", "lights", "pictures", "other", "geometry"])

    def test_what_is_kept_makes_the_same_page(self):
        whole = self.report()
        kept = economy_page.slim(whole)
        self.assertEqual(list(economy_page.page(kept)), list(economy_page.page(whole)))
        self.assertNotIn("pass_frames_ms", json.dumps(kept))

    def test_pieces_of_one_measurement_are_one_report(self):
        whole = self.report()
        pieces = [dict(whole, parts=[part]) for part in whole["parts"]]
        self.assertEqual(economy_page.merged(pieces)["parts"], whole["parts"])
        with self.assertRaises(ValueError):
            economy_page.merged([whole, dict(whole, commit="def")])

    def test_tables_have_a_column_for_each_feature(self):
        head, lines = next(tables.economy(self.report()))
        self.assertEqual(head, ["Time of path tracing", "auto", "all", "sky"])
        self.assertEqual(lines[1][3], "")


class Summary(unittest.TestCase):
    def test_says_in_three_sentences_what_reports_say(self):
        some = report("quality", {"warehouse": [row("vlc", time=1.2, product=0.5)], "gallery": [row("vlc", time=1.1, product=1.3)]})
        self.assertEqual(summary.sentences([some]), [
            "This page has 1 experiment of commit abc on none.",
            "At equal time the trimmed error of light caches (vlc) is 0.5 (warehouse) to 1.3 (gallery) of that of light lists (sll); below 1 is better.",
            "A frame with vlc takes 1.1 (gallery) to 1.2 (warehouse) of the time with sll."])
        without = summary.sentences([report("ring", {"9 degrees": []})])
        self.assertEqual(len(without), 3)
        self.assertTrue(all("Nothing" in sentence for sentence in without[1:]))

    def test_a_technique_has_one_color(self):
        self.assertEqual(colors.color_of("vlc"), colors.color_of("vlc+cdq"))
        self.assertNotEqual(colors.line_of("vlc"), colors.line_of("vlc+cdq"))
        self.assertEqual(colors.color_of("cdq32"), colors.color_of("cdq128"))
        self.assertEqual(colors.color_of("preset fast"), colors.color_of("preset paper"))
        self.assertEqual(len(set(colors.COLORS.values())), len(colors.COLORS))
        self.assertIn(colors.color_of("nomerge"), colors.OTHERS)


class Defaults(unittest.TestCase):
    def page(self, trade, again=None, arguments=()):
        """What defaults.py prints, and what it complains of."""
        out, err = io.StringIO(), io.StringIO()
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            paths = []
            for measured in filter(None, (trade, again)):
                paths.append(str(Path(folder) / f"{measured['measured']}.json"))
                Path(paths[-1]).write_text(json.dumps(measured))
            with self.assertRaises(SystemExit) as ended:
                defaults.main([*paths, *arguments])
        code = ended.exception.code
        return out.getvalue(), err.getvalue() + (code if isinstance(code, str) else ""), code

    def confirm(self, *rows, name="pt_spp", **more):
        return report("confirm", {f"hall {name}": rows}, **({"trade": {"key": "trade", "commit": "abc"}} | more))

    better = row("pt_spp=2", time=2.0, product=0.8)
    trade = report("trade", {"hall pt_spp": [better]})

    def test_what_looks_better_must_be_measured_again(self):
        text, faults, code = self.page(self.trade)
        self.assertIn("was not measured again", text)
        self.assertIn("pt_spp=2", faults)
        self.assertEqual(code, 1)

    def test_what_does_not_look_better_need_not_be(self):
        for other in (row("pt_spp=2", product=1.2), row("pt_spp=2", product=0.8, plain=1.2)):
            text, faults, code = self.page(report("trade", {"hall pt_spp": [other]}))
            self.assertEqual((faults, code), ("", 0))
            self.assertNotIn("looks better", text)

    def test_luck_is_not_confirmed(self):
        for again in (row("pt_spp=2", time=2.0, product=1.1, p=0.001), row("pt_spp=2", time=2.0, product=0.9, p=0.3),
                      row("pt_spp=2", time=2.0, product=0.9, p=0.001, plain=1.3)):
            text, faults, code = self.page(self.trade, self.confirm(again))
            self.assertIn("on fresh seeds that is not confirmed", text)
            self.assertEqual((faults, code), ("", 0))

    def test_a_reason_is_given_where_it_is_needed(self):
        text, faults, code = self.page(self.trade, self.confirm(row("pt_spp=2", time=2.0, product=0.8, p=0.001)))
        self.assertIn(defaults.REASONS["pt_spp"].text, text)
        self.assertEqual((faults, code), ("", 0))

    def test_a_reason_that_the_data_deny_is_an_error(self):
        # One sample makes the shortest frames, says the reason.
        text, faults, code = self.page(self.trade, self.confirm(row("pt_spp=2", time=0.9, product=0.8, p=0.001)))
        self.assertIn("REASONS of pt_spp, pt_spp=2: its frames are not longer on hall", faults)
        self.assertEqual(code, 1)
        values = defaults.defaults()
        denied = defaults.REASONS["pt_sll_max"].denied
        self.assertEqual(denied({}, values), "")
        self.assertNotEqual(denied({}, values | {"pt_nee": "sll"}), "")
        self.assertNotEqual(denied({}, values | {"pt_vlc_bucket": "16"}), "")

    def test_what_is_better_without_a_reason_is_an_error(self):
        rows = [row("pt_made_up=2", product=0.8, p=0.001)]
        trade = report("trade", {"hall pt_made_up": rows})
        _, faults, code = self.page(trade, self.confirm(*rows, name="pt_made_up"))
        self.assertIn("pt_made_up=2 is better than the default", faults)
        self.assertEqual(code, 1)

    def test_what_is_better_may_be_the_default_since(self):
        rows = [row(f"pt_cut_size={defaults.defaults()['pt_cut_size']}", product=0.8, p=0.001)]
        trade = report("trade", {"hall pt_cut_size": rows})
        text, faults, code = self.page(trade, self.confirm(*rows, name="pt_cut_size"))
        self.assertIn("is the default since then", text)
        self.assertEqual((faults, code), ("", 0))

    def test_better_here_and_worse_there_is_not_better(self):
        levels = {"hall pt_made_up": [row("pt_made_up=2", product=0.5, p=0.001)],
                  "cave pt_made_up": [row("pt_made_up=2", product=1.4, p=0.001)]}
        again = report("confirm", levels, trade={"key": "trade"})
        text, _, code = self.page(report("trade", levels), again)
        self.assertIn("not confirmed", text)
        self.assertEqual(code, 0)

    def test_many_comparisons_ask_for_more(self):
        better = row("pt_spp=2", time=2.0, product=0.8, p=0.01)
        self.assertNotIn("not confirmed", self.page(self.trade, self.confirm(better))[0])
        others = [row(f"pt_spp={value}") for value in range(3, 9)]
        self.assertIn("not confirmed", self.page(self.trade, self.confirm(better, *others))[0])

    def test_reports_are_of_one_commit(self):
        again = self.confirm(row("pt_spp=2", time=2.0, product=1.1), commit="def")
        text, faults, _ = self.page(self.trade, again)
        self.assertEqual(text, "")
        self.assertIn("of commit def", faults)
        text, _, code = self.page(self.trade, again, ["--commits-differ"])
        self.assertIn("The two reports are of different commits", text)
        self.assertEqual(code, 0)
        _, faults, _ = self.page(self.trade, self.confirm(self.better, trade={"key": "other", "commit": "abc"}))
        self.assertIn("another report", faults)

    def test_a_page_that_differs_from_its_report_is_an_error(self):
        text, _, _ = self.page(self.trade)
        with tempfile.TemporaryDirectory() as folder:
            committed = Path(folder) / "trade.md"
            committed.write_text(text)
            self.assertEqual(self.page(self.trade, arguments=["--check", str(committed)]), ("", "", 0))
            # What a reason asks of other variables is not on the page.
            rows = [row("pt_sll_max=64", product=0.8, p=0.001)]
            again = [report("trade", {"hall pt_sll_max": rows}), self.confirm(*rows, name="pt_sll_max")]
            committed.write_text(self.page(*again)[0])
            self.assertEqual(self.page(*again, ["--check", str(committed)]), ("", "", 0))
            committed.write_text(text)
            self.assertIn("| `2` |", text)
            for changed in (text.replace("| `2` |", "| `3` |"), text.replace(" = 0.8 ", " = 0.9 "), text + "\n"):
                committed.write_text(changed)
                self.assertIn("is not the page of", self.page(self.trade, arguments=["--check", str(committed)])[1])

    def test_reasons_have_no_numbers_of_their_own(self):
        for name, reason in defaults.REASONS.items():
            self.assertIsNone(re.search(r"\d+\.\d|\d%|\[\d", reason.text), name)


class Kept(unittest.TestCase):
    def measured(self, part, value, finished=True):
        mse = {"value": value, "by_view_and_seed": [[1.0, 2.0, 4.0], [3.0, 3.0, 9.0]]}
        return {"measured": "quality", "commit": "c", "finished": finished,
                "parts": [{"part": part, "views": [{}, {}], "rows": [{"label": "vlc", "mse": mse, "pass_ms": {"direct": [[1.0]]}}]}]}

    def test_has_values_and_views_but_no_runs(self):
        part = kept.join(None, self.measured("w", 1.23456))["parts"][0]
        self.assertEqual(part["rows"], [{"label": "vlc", "mse": {"value": 1.235, "by_view": [2.0, 3.0]}}])
        self.assertEqual((part["commit"], part["views"]), ("c", 2))

    def test_takes_the_place_of_the_same_part(self):
        joined = kept.join(None, self.measured("w", 1.0))
        for part, value in (("g", 2.0), ("w", 3.0)):
            joined = kept.join(joined, self.measured(part, value))
        self.assertEqual([(part["part"], part["rows"][0]["mse"]["value"]) for part in joined["parts"]], [("w", 3.0), ("g", 2.0)])

    def test_reads_what_test_programs_recorded(self):
        tests = [{"name": "Costs", "measured/rest/mse": "2.5", "measured/rest/error": "0.5", "result": "COMPLETED"}, {"name": "Other", "result": "COMPLETED"}]
        joined = kept.join(None, {"testsuites": [{"testsuite": tests}]})
        self.assertEqual(joined, {"parts": [{"part": "Costs", "rows": [{"label": "rest", "mse": 2.5, "error": 0.5}]}]})

    def test_reads_traced_levels(self):
        level = {"name": "w", "triangles": 7, "build_ms": 1.0, "rows": [{"rays": "shadow", "ratio": 0.5}]}
        part = kept.join(None, {"device": "d", "levels": [level]})["parts"][0]
        self.assertEqual((part["part"], part["device"], part["rows"]), ("w", "d", [{"rays": "shadow", "ratio": 0.5, "label": "shadow"}]))

    def test_reads_timed_demos(self):
        passes = [{"name": "direct", "share": 0.5}, {"name": "filter_taa", "share": 0.25}, {"name": "filter_tiles", "share": 0.25}]
        joined = None
        for name, fps in (("fast", 9.0), ("balanced", 6.0)):
            joined = kept.join(joined, {"demo": "w", "fps": fps, "repetitions": [{}, {}], "passes": passes}, name)
        self.assertEqual([(part["part"], part["rows"][0]["fps"], part["rows"][0]["share"]["filter"]) for part in joined["parts"]],
                         [("fast", 9.0, 0.5), ("balanced", 6.0, 0.5)])

    def test_reads_how_long_the_suite_took(self):
        part, = kept.tested("== Done (both), commit abc\n   packages and program 6 s, unit tests 30 s\n1 passed\n", "cold")["parts"]
        self.assertEqual((part["part"], part["rows"][0]["label"]), ("abc", "cold"))
        self.assertEqual(part["rows"][0]["seconds"], {"packages and program": 6, "unit tests": 30, "all": 36})

    def test_refuses_what_is_not_finished(self):
        with self.assertRaises(ValueError):
            kept.join(None, self.measured("w", 1.0, finished=False))
        with self.assertRaises(ValueError):
            kept.tested("== Building build/vigil\n", "cold")


if __name__ == "__main__":
    unittest.main()
