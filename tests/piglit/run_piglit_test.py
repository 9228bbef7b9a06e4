"""The comparison itself, with a piglit that gives the results it is told to."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from piglit_results import ORDER, badness, judge, statistics, worse

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

    def test_statistics_are_summed_over_processes(self):
        entry = {"result": "pass", "err": SEEN + SEEN}
        seen = statistics({"a": entry, "b": {"result": "crash", "err": "{\"quads\": not json"}, "c": {"result": "skip"}})
        self.assertEqual((seen["processes"], seen["quads"], seen["corrected"]), (2, 16, 6))
        self.assertEqual(seen["pass_reasons"], {"affine": 10})


class Runs(unittest.TestCase):
    def run_with(self, native, truequad, rounds=1):
        """Runs are lists of dictionaries. Returns the exit status and what was printed."""
        with tempfile.TemporaryDirectory() as folder:
            # In the native run there is no truequad to write statistics.
            script = {"native": [{name: [result, subtests, ""] for name, (result, subtests, _) in run.items()} for run in native],
                      "truequad": truequad}
            results = pathlib.Path(folder) / "results.json"
            results.write_text(json.dumps(script))
            done = subprocess.run(
                [sys.executable, HERE / "run_piglit.py", "--truequad", os.environ["TRUEQUAD_LIBRARY"], "--out",
                 f"{folder}/out", "--piglit", HERE / "fake_piglit", "--rounds", str(rounds), "--jobs", "1"],
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
