# SPDX-License-Identifier: GPL-2.0-or-later
"""What planted_faults.py takes for noticed, and what for an error: stand-ins for test programs end in every way."""

import json
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "tools" / "numerics"))
import planted_faults
from fault_table import FAULTS, Fault, part

REPORT = '''#!/usr/bin/env python3
import os, sys, time
report = next(word for word in sys.argv if word.startswith("--gtest_output=json:")).split(":", 1)[1]
'''


def report_of(*cases):
    """Writes GoogleTest's report; a case is a name, a result and whether it failed."""
    suite = {"name": "Suite", "testsuite": [
        {"name": name, "result": result, **({"failures": [{"failure": "no"}]} if failed else {})}
        for name, result, failed in cases]}
    return f"open(report, 'w').write({json.dumps(json.dumps({'testsuites': [suite]}))})\n"


PASSES = report_of(("Case", "COMPLETED", False))
FAILS = report_of(("Other", "COMPLETED", False), ("Case", "COMPLETED", True))


class Judgement(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.copy = planted_faults.Copy(Path(folder.name))
        self.copy.build_folder.mkdir()
        self.copy.build = lambda target: None
        self.source = self.copy.folder / "source.cpp"
        self.source.write_text("a = 1;\n")
        self.fault = Fault("fault", "source.cpp", "a = 1;", "a = 2;", part("program", "source.cpp"), "Suite.Case*")

    def results_of(self, code, fault=None):
        """What becomes of the fault if this is its test program; `source` is the planted file's text."""
        program = self.copy.build_folder / self.fault.program.path
        program.write_text(REPORT + f"source = open({str(self.source)!r}).read()\n" + code)
        program.chmod(0o755)
        told = []
        planted_faults.plant_all(self.copy, [fault or self.fault], lambda _, result, text: told.append((result, text)))
        self.assertEqual(self.source.read_text(), "a = 1;\n")
        self.assertEqual(len(told), 1)
        return told[0]

    def with_fault(self, code):
        """The same for a program that passes without the fault."""
        lines = "".join(f"    {line}\n" for line in code.splitlines())
        return self.results_of(f"if 'a = 2' in source:\n{lines}{PASSES}")

    def test_failed_tests_are_noticed(self):
        self.assertEqual(self.with_fault(FAILS + "sys.exit(1)"), ("noticed", "Suite.Case"))

    def test_passing_tests_are_not(self):
        self.assertEqual(self.results_of(PASSES)[0], "UNNOTICED")

    def test_a_signal_is_an_error(self):
        result, text = self.with_fault(FAILS + "os.kill(os.getpid(), 11)")
        self.assertEqual(result, "ERROR")
        self.assertIn("SIGSEGV", text)

    def test_a_time_out_is_an_error(self):
        limit = planted_faults.TIME_LIMIT
        self.addCleanup(lambda: setattr(planted_faults, "TIME_LIMIT", limit))
        planted_faults.TIME_LIMIT = 3
        result, text = self.with_fault("time.sleep(60)")
        self.assertEqual(result, "ERROR")
        self.assertIn("had not ended", text)

    def test_a_bad_end_without_failed_tests_is_an_error(self):
        self.assertEqual(self.with_fault("sys.exit(1)")[0], "ERROR")
        self.assertEqual(self.with_fault(PASSES + "sys.exit(1)")[0], "ERROR")
        self.assertEqual(self.with_fault(FAILS + "sys.exit(0)")[0], "ERROR")

    def test_tests_that_fail_without_a_fault_tell_nothing(self):
        self.assertEqual(self.results_of(FAILS + "sys.exit(1)"), ("ERROR", "Suite.Case fails without a fault"))

    def test_tests_that_do_not_run_tell_nothing(self):
        self.assertEqual(self.results_of(report_of(("Case", "SKIPPED", False)))[0], "ERROR")
        self.assertEqual(self.results_of(report_of(("Other", "COMPLETED", False)))[0], "ERROR")

    def test_a_line_that_has_changed_is_an_error(self):
        for before in ("a = 3;", " "):  # none; twice
            changed = Fault("fault", "source.cpp", before, "a = 2;", self.fault.program, "Suite.Case*")
            result, text = self.results_of(PASSES, changed)
            self.assertEqual(result, "ERROR")
            self.assertIn("out of date", text)

    def test_the_last_line_counts(self):
        results = planted_faults.Results()
        for result in ("noticed", "noticed", "UNNOTICED"):
            results.tell(self.fault, result, "")
        self.assertEqual(results.close(), 1)
        sound = planted_faults.Results()
        sound.tell(self.fault, "noticed", "")
        self.assertEqual(sound.close(), 0)
        sound.tell(self.fault, "ERROR", "")
        self.assertEqual(sound.close(), 1)


class Table(unittest.TestCase):
    def test_names_differ_and_faults_change_something(self):
        self.assertEqual(len({fault.name for fault in FAULTS}), len(FAULTS))
        for fault in FAULTS:
            self.assertNotEqual(fault.before, fault.after, fault.name)
        self.assertGreaterEqual(len(FAULTS), 30)

    def test_quick_faults_need_no_gpu(self):
        for fault in FAULTS:
            self.assertTrue(fault.program.sources or not fault.quick, fault.name)


if __name__ == "__main__":
    unittest.main()
