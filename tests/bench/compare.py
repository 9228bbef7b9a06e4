#!/usr/bin/env python3
"""Runs the benchmark without and with truequad in turn, and prints the ratio of the times of each case.

    compare.py BENCH LIBTRUEQUAD [--rounds N] [--only PREFIX] [--touched] [--check | --instructions]

Both runs of a round follow each other, so that a machine that slows down slows both. Noise only ever adds time: requirements
(--check) are put to the ratio of the best times; medians are printed beside them. Many short samples find the undisturbed time
of either side where few long ones find none: on a busy machine hardly any 50 ms pass without a disturbance. Their number is
fixed, the same for both, and no sample is taken again because of what it showed.

Of either time a part is page faults, as that driver keeps every buffer of vertices. --touched measures the calls without them:
memory is touched beforehand, and a sample with faults is refused.

--instructions counts them by valgrind's callgrind instead, which no noise disturbs: the difference of a long and a short run.
"""
import argparse
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile

# Quads or triangles that an iteration of the benchmark sends (bench.cc).
PER_ITERATION = 1000
# Page faults that an iteration may have: one costs as much as a hundred quads.
FAULTS = 1
# Largest allowed ratio to native, by the first letters of a case's name.
LIMITS = {"affine": 1.6, "triangles": 1.05}


def environment_for(preload, stats):
    environment = dict(os.environ, GALLIUM_NOOP="1", TRUEQUAD_STATS=stats)
    environment.pop("LD_PRELOAD", None)
    if preload:
        environment["LD_PRELOAD"] = preload
    return environment


def run(options, case, preload, stats):
    """Times of a quad or triangle in ns. A process of its own for each case, as the driver keeps all memory."""
    command = [options.bench, "--benchmark_format=json", f"--benchmark_min_time={options.seconds}",
               "--benchmark_min_warmup_time=0.01", f"--benchmark_repetitions={options.samples}",
               f"--benchmark_filter=^{case}$"]
    environment = environment_for(preload, stats)
    if options.touched:
        # Large pages, so that touching takes seconds less.
        environment.update(BENCH_TOUCHED="1", GLIBC_TUNABLES="glibc.malloc.hugetlb=1")
    output = subprocess.run(command, env=environment, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    samples = [row for row in json.loads(output)["benchmarks"] if row["run_type"] == "iteration"]
    for row in samples:
        if options.touched and row["faults"] > FAULTS:
            sys.exit(f"compare: {case}: {row['faults']:.1f} page faults an iteration would be measured, not calls")
    return [row["cpu_time"] / PER_ITERATION for row in samples]


def instructions(options, case, preload, stats):
    """Of one quad or triangle of a case."""
    def total(repetitions):
        # Of the cases alone (bench.cc run()): what the library of benchmarks does between samples is as much again.
        command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "--toggle-collect=*::run*(*", options.bench,
                   f"--benchmark_filter=^{case}$", "--benchmark_min_time=0.000001",
                   f"--benchmark_repetitions={repetitions}"]
        log = subprocess.run(command, env=environment_for(preload, stats), check=True, stdout=subprocess.DEVNULL,
                             stderr=subprocess.PIPE, text=True).stderr
        return int(re.search(r"Collected : (\d+)", log)[1])
    # The driver sets up what it needs within the first ten.
    few, more = 12, 32
    return (total(more) - total(few)) / (more - few) / PER_ITERATION


def count(options, cases):
    print(f"{'case':24} {'native':>10} {'truequad':>10} {'ratio':>8}  instructions of one")
    for name in cases:
        before, after = (instructions(options, name, preload, os.devnull) for preload in (None, options.truequad))
        print(f"{name:24} {before:10.0f} {after:10.0f} {after / before:8.3f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("bench")
    parser.add_argument("truequad")
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--samples", type=int, default=5, help="of each case in a round")
    parser.add_argument("--seconds", type=float, default=0.02, help="least time of a sample")
    parser.add_argument("--only", metavar="PREFIX", default="", help="cases whose names begin so")
    parser.add_argument("--touched", action="store_true", help="measure without the driver's page faults")
    parser.add_argument("--check", action="store_true", help="fail when a requirement is not met")
    parser.add_argument("--instructions", action="store_true", help="count instead of measuring")
    options = parser.parse_args()
    cases = subprocess.run([options.bench, "--benchmark_list_tests", f"--benchmark_filter=^{options.only}"], check=True,
                           stdout=subprocess.PIPE, text=True).stdout.split()
    if options.instructions:
        return count(options, cases)

    native = {case: [] for case in cases}
    truequad = {case: [] for case in cases}
    with tempfile.TemporaryDirectory() as folder:
        for case in cases:
            stats = os.path.join(folder, f"{case}.json")
            for _ in range(options.rounds):
                native[case] += run(options, case, None, stats)
                truequad[case] += run(options, case, options.truequad, stats)
            with open(stats) as file:
                if "corrected" in case and json.load(file)["corrected"] == 0:
                    sys.exit(f"compare: {case}: no quad was corrected, so truequad was not at work")

    broken = []
    print(f"{'case':24} {'native ns':>10} {'truequad':>10} {'medians':>8} {'best':>8}  limit")
    for name in cases:
        before, after = native[name], truequad[name]
        medians = statistics.median(after) / statistics.median(before)
        best = min(after) / min(before)
        limit = next((l for prefix, l in LIMITS.items() if name.startswith(prefix)), None)
        print(f"{name:24} {statistics.median(before):10.3g} {statistics.median(after):10.3g} {medians:8.3f} {best:8.3f}"
              f"  {limit or ''}")
        if limit and best > limit:
            broken.append(f"{name}: {best:.3f} > {limit}")
    if options.check and broken:
        sys.exit("compare: too slow: " + ", ".join(broken))


if __name__ == "__main__":
    main()
