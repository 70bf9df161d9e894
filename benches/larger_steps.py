#!/usr/bin/env python3
"""What larger steps and heavier particles do to a shear test: periodic-shear under the exact law.

    cargo build --release
    python3 benches/larger_steps.py            writes data/bench/larger-steps.csv
"""

import csv
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
PROGRAM = os.path.join(ROOT, os.environ.get("CARGO_TARGET_DIR", "target"), "release", "ballast")
STRAINS = [0.0005, 0.001, 0.002, 0.0035]
DENSITY = 2650
CASES = [("0.1", 1), ("0.2", 1), ('"auto"', 1), ("0.4", 1)]
CASES += [("0.1", factor) for factor in (4, 10, 30, 100, 1000)] + [('"auto"', 10)]


def run(frac, factor, path):
    keys = {
        "model.law": '"mindlin-deresiewicz-exact"',
        "model.fracc_every": 1000,
        "history.every": 20,
        "model.frac": frac,
        "material.glass.density": DENSITY * factor,
    }
    command = [PROGRAM, "run", "periodic-shear", "--quiet", "--csv", path]
    for key, value in keys.items():
        command += ["--set", f"{key}={value}"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stderr)
    with open(path) as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        row.pop("stage")
    return [{key: float(value) for key, value in row.items()} for row in rows]


def main():
    table = []
    with tempfile.TemporaryDirectory() as folder:
        for frac, factor in CASES:
            rows = run(frac, factor, f"{folder}/rows.csv")
            # The start, where the rate sets in at once, is left out.
            later = rows[len(rows) // 20 :]
            unbalanced = sum(row["unbalanced"] for row in later) / len(later)
            near = [min(rows, key=lambda row: abs(row["deviator_strain"] - strain)) for strain in STRAINS]
            phi = [f"{row['sin_phi']:.4f}" for row in near]
            table.append([frac.strip('"'), factor, int(rows[-1]["cycle"]), *phi, f"{unbalanced:.4f}"])
    names = [f"sin_phi_at_{100 * strain:g}_percent" for strain in STRAINS]
    with open(os.path.join(ROOT, "data", "bench", "larger-steps.csv"), "w") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["frac", "density_factor", "cycles", *names, "mean_unbalanced"])
        writer.writerows(table)


if __name__ == "__main__":
    main()
