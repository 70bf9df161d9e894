#!/usr/bin/env python3
"""How long large-compression takes, and what it ends with; each run appends a row to the table.

    cargo build --release
    python3 benches/large_compression.py [SEED [THREADS]]      appends to data/bench/large-compression.csv
"""

import csv
import os
import resource
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
PROGRAM = os.path.join(ROOT, os.environ.get("CARGO_TARGET_DIR", "target"), "release", "ballast")
TABLE = os.path.join(ROOT, "data", "bench", "large-compression.csv")
MEASURES = ["isotropic_stress", "coordination_mechanical", "porosity", "unbalanced"]


def run(seed, threads):
    """Rows of the history, wall time [s] and processor time [s], generation included."""
    with tempfile.TemporaryDirectory() as folder:
        path = f"{folder}/rows.csv"
        command = [PROGRAM, "run", "large-compression", "--quiet", "--csv", path]
        command += ["--seed", str(seed), "--threads", str(threads)]
        start = time.perf_counter()
        done = subprocess.run(command, capture_output=True, text=True)
        wall = time.perf_counter() - start
        if done.returncode:
            sys.exit(done.stderr)
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        with open(path) as file:
            return list(csv.DictReader(file)), wall, usage.ru_utime + usage.ru_stime


def main():
    seed, threads = [int(given) for given in sys.argv[1:3] + ["1", "2"][len(sys.argv) - 1 :]]
    rows, wall, processor = run(seed, threads)
    last = {row["stage"]: row for row in rows}
    cycles = int(rows[-1]["cycle"])
    row = {"seed": seed, "threads": threads, "wall_s": f"{wall:.1f}", "busy": f"{processor / wall / threads:.2f}"}
    row |= {"cycles": cycles, "cycles_per_s": f"{cycles / wall:.0f}"}
    row |= {f"cycle_{stage}": last[stage]["cycle"] for stage in ("gather", "compress")}
    for stage in ("compress", "rest"):
        end = {name: float(last[stage][name]) for name in MEASURES + ["stress_11", "stress_22"]}
        row |= {f"{stage}_{name}": f"{end[name]:.6g}" for name in MEASURES}
        row[f"{stage}_ratio"] = f"{end['stress_11'] / end['stress_22']:.6f}"
    fresh = not os.path.exists(TABLE)
    with open(TABLE, "a") as file:
        writer = csv.DictWriter(file, row, lineterminator="\n")
        if fresh:
            writer.writeheader()
        writer.writerow(row)


if __name__ == "__main__":
    main()
