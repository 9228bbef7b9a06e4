"""The comparison itself, with a piglit that gives the results it is told to."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from piglit_results import ORDER, badness, judge, not_passed, statistics, worse

HERE = pathlib.Path(__file__).parent
SEEN = ('some words\n{"quads": 8, "passed": 5, "corrected": 3, "triangles": 40, "bound_px_max": 0.2, '
        '"by_path": {"immediate": 8}, "pass_reasons": {"affine": 5}}\n')


def test(result="pass", subtests=None, err=SEEN):
    return [result, subtests or {}, err]


class Words(unittest.TestCase):
    def test_results_are_ordered_from_good_to_bad(self):
        for better, bad in zip(ORDER, ORDER[1:]):
            self.assertLess(badness(better), badness(bad))
            self.assertEqual(worse({"t": better}, {"t": bad}), ["t"])
            self.assertEqual(worse({"t": bad}, {"t": better}), [])
            self.assertEqual(worse({"t": bad}, {"t": bad}), [])

    def test_what_is_unknown_or_gone_is_worst(self):
        self.assertEqual(worse({"t": "incomplete"}, {"t": "a new word"}), ["t"])
        self.assertEqual(worse({"t": "pass"}, {}), ["t"])
        self.assertEqual(worse({}, {"t": "crash"}), [])

    def test_one_good_run_makes_it_unsteady(self):
        bad, good = {"t": "fail"}, {"t": "pass"}
        self.assertEqual(judge(["t"], [good], [bad, bad]), (["t"], []))
        self.assertEqual(judge(["t"], [good], [bad, good]), ([], ["t"]))
        self.assertEqual(judge(["t"], [good, bad], [bad, bad]), (["t"], []))

    def test_a_test_that_natively_fails_in_many_ways_proves_nothing(self):
        fail, crash, warn = {"t": "fail"}, {"t": "crash"}, {"t": "warn"}
        self.assertEqual(judge(["t"], [fail, crash], [crash, crash]), ([], ["t"]))
        self.assertEqual(judge(["t"], [fail, fail], [crash, crash]), (["t"], []))
        self.assertEqual(judge(["t"], [warn, crash], [crash, crash]), (["t"], []))
        self.assertEqual(judge(["t"], [fail, crash], [{}, {}]), (["t"], []))

    def test_only_what_passes_in_all_its_parts_has_passed(self):
        tests = {"a": {"result": "pass"}, "b": {"result": "pass", "subtests": {"x": "skip"}}, "c": {"result": "warn"},
                 "d": {"result": "pass", "subtests": {"x": "pass", "__type__": "Subtests"}}}
        self.assertEqual(not_passed(tests), ["b", "c"])

    def test_statistics_are_summed_over_processes(self):
        entry = {"result": "pass", "err": SEEN + SEEN}
        seen = statistics({"a": entry, "b": {"result": "crash", "err": "{\"quads\": not json"}, "c": {"result": "skip"}})
        self.assertEqual((seen["processes"], seen["quads"], seen["corrected"]), (2, 16, 6))
        self.assertEqual(seen["pass_reasons"], {"affine": 10})


class Runs(unittest.TestCase):
    def run_with(self, native, truequad, *arguments, rounds=1, skip=None):
        """Runs are lists of dictionaries. Returns the exit status and what was printed."""
        with tempfile.TemporaryDirectory() as folder:
            # In the native run there is no truequad to write statistics.
            script = {"native": [{name: [result, subtests, ""] for name, (result, subtests, _) in run.items()} for run in native],
                      "truequad": truequad}
            results = pathlib.Path(folder) / "results.json"
            results.write_text(json.dumps(script))
            if skip is not None:
                file = pathlib.Path(folder) / "skip"
                file.write_text(skip)
                arguments = [*arguments, "--skip", file]
            done = subprocess.run(
                [sys.executable, HERE / "run_piglit.py", "--truequad", os.environ["TRUEQUAD_LIBRARY"], "--out",
                 f"{folder}/out", "--piglit", HERE / "fake_piglit", "--rounds", str(rounds), "--jobs", "1",
                 *arguments],
                env={**os.environ, "FAKE_RESULTS": str(results)}, capture_output=True, text=True)
            return done.returncode, done.stdout + done.stderr

    def test_equal_runs_pass(self):
        status, words = self.run_with([{"a": test(), "b": test("fail")}], [{"a": test(), "b": test("fail")}])
        self.assertEqual(status, 0, words)
        self.assertIn("0 regressions, 0 unsteady, 0 better", words)

    def test_what_is_worse_is_a_regression(self):
        bad = ORDER[1:]
        status, words = self.run_with([{result: test() for result in bad}], [{result: test(result) for result in bad}])
        self.assertEqual(status, 1, words)
        for result in bad:
            self.assertIn(f"REGRESSION: {result}: natively pass, pass; with truequad {result}, {result}\n", words)

    def test_so_is_a_subtest(self):
        native = [{"a": test("fail", {"x": "pass", "y": "fail", "z": "pass"})}]
        status, words = self.run_with(native, [{"a": test("fail", {"x": "fail", "y": "fail"})}])
        self.assertEqual(status, 1, words)
        self.assertIn("REGRESSION: a » x: natively pass, pass; with truequad fail, fail\n", words)
        self.assertIn("REGRESSION: a » z: natively pass, pass; with truequad no result\n", words)

    def test_what_passes_is_not_run_natively(self):
        # A piglit that is asked for a test which it does not know ends with an error.
        status, words = self.run_with([{"b": test("fail")}], [{"a": test(), "b": test("fail")}])
        self.assertEqual(status, 0, words)
        self.assertIn("native: 1 tests, ", words)
        status, words = self.run_with([], [{"a": test(), "b": test()}])
        self.assertEqual(status, 0, words)
        self.assertNotIn("native", words)
        self.assertIn("0 regressions, 0 unsteady, 0 better", words)

    def test_unless_both_runs_are_to_be_whole(self):
        native = [{"a": test("fail"), "b": test("pass", {"x": "pass"})}]
        truequad = [{"a": test(), "b": test("pass")}]
        status, words = self.run_with(native, truequad, "--whole")
        self.assertEqual(status, 1, words)
        self.assertIn("REGRESSION: b » x: natively pass, pass; with truequad no result\n", words)
        self.assertIn("better: a: natively fail, with truequad pass\n", words)

    def test_what_is_skipped_is_not_run(self):
        native, truequad = [{"a (1)": test()}], [{"a (1)": test("crash"), "a (1) long": test()}]
        self.assertEqual(self.run_with(native, truequad)[0], 1)
        status, words = self.run_with(native, truequad, skip="a (1) # takes long\n")
        self.assertEqual(status, 0, words)
        self.assertIn("truequad: 1 tests, ", words)

    def test_skipping_needs_a_reason(self):
        for line in ("a", "a # ", "# reason", " # reason", ""):
            status, words = self.run_with([], [{"a": test()}], skip=line + "\n")
            self.assertEqual(status, 1, words)
            self.assertIn("not a test and a reason", words)

    def test_a_failure_that_becomes_a_crash_is_a_regression(self):
        status, words = self.run_with([{"a": test("fail")}], [{"a": test("crash")}])
        self.assertEqual(status, 1, words)

    def test_what_passes_once_is_listed_only(self):
        status, words = self.run_with([{"a": test(), "b": test()}],
                                      [{"a": test("fail"), "b": test()}, {"a": test("fail")}, {"a": test()}], rounds=3)
        self.assertEqual(status, 0, words)
        self.assertIn("unsteady: a: natively pass, pass, pass; with truequad fail, fail, pass", words)

    def test_idle_truequad_proves_nothing(self):
        status, words = self.run_with([{"a": test()}], [{"a": test(err="")}])
        self.assertEqual(status, 1, words)
        self.assertIn("not at work", words)
        status, words = self.run_with([{"a": test()}], [{"a": test(err=SEEN.replace("affine", "unknown_context"))}])
        self.assertEqual(status, 1, words)
        self.assertIn("not at work", words)


if __name__ == "__main__":
    unittest.main()
