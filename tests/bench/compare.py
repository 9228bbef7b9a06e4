#!/usr/bin/env python3
"""Runs the benchmark without and with truequad in turn, and prints the ratio of the times of each case.

    compare.py BENCH LIBTRUEQUAD [--rounds N] [--only PREFIX] [--check]

Both runs of a round follow each other, so that a machine that slows down slows both. Noise only ever adds time:
requirements (--check) are put to the ratio of the best times; medians are printed beside them.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile

# Quads or triangles that an iteration of the benchmark sends (bench.cc).
PER_ITERATION = 1000
# Largest allowed ratio to native, by the first letters of a case's name (issue "Speed").
LIMITS = {"affine": 1.6, "triangles": 1.05}


def run(options, preload, stats):
    environment = dict(os.environ, GALLIUM_NOOP="1", TRUEQUAD_STATS=stats)
    environment.pop("LD_PRELOAD", None)
    if preload:
        environment["LD_PRELOAD"] = preload
    command = [options.bench, "--benchmark_format=json", f"--benchmark_min_time={options.seconds}",
               f"--benchmark_filter=^{options.only}"]
    output = subprocess.run(command, env=environment, check=True, stdout=subprocess.PIPE,
                            stderr=subprocess.DEVNULL).stdout
    return {row["name"]: row["cpu_time"] for row in json.loads(output)["benchmarks"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("bench")
    parser.add_argument("truequad")
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--seconds", type=float, default=0.05, help="least time of a case in a round")
    parser.add_argument("--only", metavar="PREFIX", default="", help="cases whose names begin so")
    parser.add_argument("--check", action="store_true", help="fail when a requirement is not met")
    options = parser.parse_args()

    native, truequad = [], []
    with tempfile.TemporaryDirectory() as folder:
        stats = os.path.join(folder, "stats.json")
        for _ in range(options.rounds):
            native.append(run(options, None, stats))
            truequad.append(run(options, options.truequad, stats))
        with open(stats) as file:
            counts = json.load(file)
    if any("corrected" in name for name in native[0]) and counts["corrected"] == 0:
        sys.exit("compare: no quad was corrected, so truequad was not at work")

    broken = []
    print(f"{'case':24} {'native ns':>10} {'truequad':>10} {'medians':>8} {'best':>8}  limit")
    for name in native[0]:
        before, after = [r[name] / PER_ITERATION for r in native], [r[name] / PER_ITERATION for r in truequad]
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
