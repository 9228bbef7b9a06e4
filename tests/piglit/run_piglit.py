"""Runs piglit without and with truequad and compares test by test.

    run_piglit.py --truequad LIBRARY --out FOLDER [--select REGEX]… [--skip FILE] [--whole] [--profile NAME] [--jobs N] [--rounds N]

Ends with status 1 if a test, or a subtest, is worse with truequad than without. What differs is run again, natively and with
truequad in turn, and counts only if it never gets as good with truequad as it was without. Needs an X server.

A test that passes with truequad cannot be worse than natively, so only the others are run natively, unless --whole asks for both
runs whole. That also shows what is better with truequad, or that a test which passes has lost a subtest.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

from piglit_results import judge, not_passed, outcomes, read_results, statistics, test_of, worse

TEST_LIMIT_S = 600
REASON = " # "


def environment(home, preload):
    env = {key: value for key, value in os.environ.items() if not key.startswith("TRUEQUAD_")}
    env.pop("LD_PRELOAD", None)
    # llvmpipe spends most of the tests' time on its shaders, each of which is drawn with once or twice: not worth optimising.
    env.update(HOME=str(home), XDG_CACHE_HOME=str(home / "cache"), LC_ALL="C", LIBGL_ALWAYS_SOFTWARE="1", GALLIVM_PERF="nopt")
    if preload:
        env.update(LD_PRELOAD=str(preload), TRUEQUAD_STATS="-")
    return env


def read_skipped(path):
    """Names of tests in a file of lines `NAME # REASON`."""
    names = []
    for line in path.read_text().splitlines():
        name, has_reason, reason = line.partition(REASON)
        if not has_reason or not name.strip() or not reason.strip():
            sys.exit(f"run_piglit: {path}: not a test and a reason: {line!r}")
        names.append(name.strip())
    return names


class Piglit:
    def __init__(self, options):
        self.options = options
        self.skipped = read_skipped(options.skip) if options.skip else []
        self.home = options.out / "home"
        self.home.mkdir(parents=True)

    def run(self, name, preload, only=None):
        """Entries of the results. `only`: the tests to run, instead of those selected."""
        folder = self.options.out / name
        command = [self.options.piglit, "run", "--overwrite", "-p", "mixed_glx_egl", "-j", str(self.options.jobs),
                   "--timeout", str(TEST_LIMIT_S)]
        if only is None:
            for regex in self.options.select:
                command += ["-t", regex]
            for test in self.skipped:
                command += ["-x", f"^{re.escape(test)}$"]
        else:
            names = self.options.out / f"{name}.tests"
            names.write_text("".join(f"{test}\n" for test in only))
            command += ["--test-list", str(names)]
        began = time.monotonic()
        log = self.options.out / f"{name}.log"
        with open(log, "wb") as file:
            status = subprocess.run([*command, self.options.profile, str(folder)], stdin=subprocess.DEVNULL, stdout=file,
                                    stderr=subprocess.STDOUT, env=environment(self.home, preload)).returncode
        if status != 0:
            sys.exit(f"run_piglit: {name}: piglit ended with status {status}, see {log}")
        tests = read_results(folder)
        run = outcomes(tests)
        counts = {}
        for result in run.values():
            counts[result] = counts.get(result, 0) + 1
        print(f"{name}: {len(tests)} tests, with subtests {len(run)} results "
              f"({', '.join(f'{counts[key]} {key}' for key in sorted(counts))}), {time.monotonic() - began:.0f} s", flush=True)
        return tests, run


def compare(piglit, truequad, rounds, whole):
    """True if nothing is worse with truequad."""
    tests, run = piglit.run("truequad", truequad)
    if not run:
        sys.exit("run_piglit: no test was selected")
    if back := [test for test in piglit.skipped if test in tests]:
        sys.exit(f"run_piglit: these were to be skipped: {back}")
    wanted = None if whole else not_passed(tests)
    native_tests, native = piglit.run("native", None, wanted) if wanted != [] else ({}, {})

    seen = statistics(tests)
    print("seen:", seen)
    # Piglit draws hardly a quad that needs correction; but all have to be looked at, in contexts that are known.
    at_work = seen["quads"] > 0 and not seen["pass_reasons"].get("unknown_context")
    if not at_work:
        print("run_piglit: truequad was not at work in the tests")
    if statistics(native_tests)["processes"]:
        sys.exit("run_piglit: truequad was in the run without it")

    native_runs, runs = [native], [run]
    names = worse(native, run)
    for number in range(1, rounds + 1):
        again = sorted({test_of(name) for name in judge(names, native_runs, runs)[0]})
        if not again:
            break
        native_runs.append(piglit.run(f"native-{number}", None, again)[1])
        runs.append(piglit.run(f"truequad-{number}", truequad, again)[1])

    regressions, unsteady = judge(names, native_runs, runs)
    for title, listed in (("unsteady", unsteady), ("REGRESSION", regressions)):
        for name in listed:
            of = [[known for known in (r.get(name) for r in all_runs) if known] for all_runs in (native_runs, runs)]
            print(f"{title}: {name}: natively {', '.join(of[0])}; with truequad {', '.join(of[1]) or 'no result'}")
    better = worse({name: result for name, result in run.items() if whole or test_of(name) in native_tests}, native)
    for name in better:
        print(f"better: {name}: natively {native[name] if name in native else 'no result'}, with truequad {run[name]}")
    print(f"{len(regressions)} regressions, {len(unsteady)} unsteady, {len(better)} better")
    return at_work and not regressions


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--truequad", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--profile", default="quick_gl")
    parser.add_argument("--select", action="append", default=[], metavar="REGEX", help="tests whose name matches one of these")
    parser.add_argument("--skip", type=pathlib.Path, metavar="FILE", help="tests that are not run, each with its reason")
    parser.add_argument("--whole", action="store_true", help="run all tests natively, also those that pass with truequad")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--rounds", type=int, default=4, help="how often to run again what is worse")
    parser.add_argument("--piglit", default="piglit", help="the program")
    options = parser.parse_args()
    options.out = options.out.resolve()
    options.truequad = options.truequad.resolve(strict=True)
    if not shutil.which(options.piglit):
        sys.exit(f"run_piglit: {options.piglit} is not installed")
    shutil.rmtree(options.out, ignore_errors=True)
    well = compare(Piglit(options), options.truequad, options.rounds, options.whole)
    shutil.rmtree(options.out / "home", ignore_errors=True)
    sys.exit(0 if well else 1)


if __name__ == "__main__":
    main()
