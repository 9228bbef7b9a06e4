"""Results of piglit runs: what got worse from one run to another, and what truequad saw in a run.

A run is a dictionary from the name of a test, or of one of its subtests, to its result in piglit's words.
"""
import bz2
import gzip
import json
import pathlib

SUBTEST = " » "

# From good to bad. "skip" means that the driver lacks what the test needs, so it is worse than any test that was run and
# passed, and better than one that failed. What has no result at all never came to its end.
ORDER = ["pass", "warn", "skip", "fail", "crash", "timeout", "incomplete"]


def badness(result):
    return ORDER.index(result) if result in ORDER else len(ORDER)


def read_results(folder):
    """The test entries of the results that `piglit run` left in a folder, by name."""
    openers = {".json": open, ".bz2": bz2.open, ".gz": gzip.open}
    for path in sorted(pathlib.Path(folder).glob("results.json*")):
        with openers[path.suffix](path, "rt") as file:
            return json.load(file)["tests"]
    raise FileNotFoundError(f"no results in {folder}")


def outcomes(tests):
    """Result of each test and subtest."""
    run = {}
    for name, test in tests.items():
        run[name] = test["result"]
        for subtest, result in test.get("subtests", {}).items():
            if subtest != "__type__":
                run[name + SUBTEST + subtest] = result
    return run


def not_passed(tests):
    """Names of the tests that did not pass, or have a subtest that did not."""
    return sorted({test_of(name) for name, result in outcomes(tests).items() if result != "pass"})


def test_of(name):
    """The test that has to be run again for this name."""
    return name.split(SUBTEST)[0]


def worse(before, after):
    """Names whose result is worse after than before; subtests that are gone never came to their end."""
    return sorted(name for name, result in before.items() if badness(after.get(name, "incomplete")) > badness(result))


def best(runs, name):
    return min((run.get(name, "incomplete") for run in runs), key=badness)


def judge(names, native_runs, other_runs):
    """Splits names into regressions and what is only unsteady.

    A regression was never as good in any of the other runs as natively. What once was is listed as unsteady, with all
    its results: tests that are so natively cannot prove anything. Nor can a test that natively always fails, now in one
    way and now in another: there the other runs may be as bad as the worst.
    """
    regressions, unsteady = [], []
    for name in names:
        native = [badness(run.get(name, "incomplete")) for run in native_runs]
        allowed = max(native) if min(native) >= badness("fail") else min(native)
        if badness(best(other_runs, name)) > allowed:
            regressions.append(name)
        else:
            unsteady.append(name)
    return regressions, unsteady


def statistics(tests):
    """What truequad counted in all tests: its JSON object is a line of what they wrote to stderr."""
    total = {"processes": 0, "quads": 0, "passed": 0, "corrected": 0, "triangles": 0}
    reasons, paths = {}, {}
    for test in tests.values():
        for line in (test.get("err") or "").splitlines():
            if not line.startswith('{"quads"'):
                continue
            try:
                counted = json.loads(line)
            except ValueError:
                continue
            total["processes"] += 1
            for key in total.keys() & counted.keys():
                total[key] += counted[key]
            for of, key in ((reasons, "pass_reasons"), (paths, "by_path")):
                for name, count in counted.get(key, {}).items():
                    of[name] = of.get(name, 0) + count
    return {**total, "pass_reasons": reasons, "by_path": paths}
