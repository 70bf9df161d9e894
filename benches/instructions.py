#!/usr/bin/env python3
"""Instructions per contact update, counted by callgrind: a change that costs five per cent is seen.

Counts do not depend on how busy the machine is. Two runs of different length are compared, so that
reading the preset and starting up cancel. Needs valgrind (Debian: apt install valgrind), which knows
AVX2 but not AVX-512.

    cargo build --release
    python3 benches/instructions.py            compare with data/bench/instructions.csv
    python3 benches/instructions.py --record   write that file anew
"""

import csv
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
PROGRAM = os.path.join(ROOT, os.environ.get("CARGO_TARGET_DIR", "target"), "release", "ballast")
RECORD = os.path.join(ROOT, "data", "bench", "instructions.csv")
LAWS = ["linear", "hertz-mindlin", "mindlin-deresiewicz", "mindlin-deresiewicz-exact"]
ISAS = ["baseline", "avx2"]
# Enough that the share of the first cycles, in which lists are made, is small.
SHORT, LONG = 500, 2500
# A change above this share is told.
NOTICED = 0.05


def scene(law, cycles):
    return ["run", "periodic-shear", "--set", f'model.law="{law}"', "--cycles", str(cycles), "--quiet"]


def instructions(folder, isa, law, cycles):
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", PROGRAM]
    command += scene(law, cycles) + ["--isa", isa, "--csv", f"{folder}/{isa}-{law}-{cycles}.csv"]
    done = subprocess.run(command, capture_output=True, text=True)
    found = re.search(r"Collected : (\d+)", done.stderr)
    if not found:
        sys.exit(f"{' '.join(command)}\n{done.stderr}")
    return int(found.group(1))


def touching(path):
    with open(path) as file:
        rows = list(csv.DictReader(file))
    # Coordination number times particles over two.
    return sum(float(row["coordination"]) for row in rows) / len(rows) * 600 / 2


def measured():
    counts = {}
    with tempfile.TemporaryDirectory() as folder:
        for law in LAWS:
            # Prepares the sample, which is kept, with all the speed there is.
            first = f"{folder}/first-{law}.csv"
            subprocess.run([PROGRAM] + scene(law, LONG) + ["--csv", first], check=True)
            contacts = touching(first)
            for isa in ISAS:
                ends = [instructions(folder, isa, law, cycles) for cycles in (SHORT, LONG)]
                counts[law, isa] = (ends[1] - ends[0]) / (LONG - SHORT) / contacts
    return counts


def main():
    counts = measured()
    if "--record" in sys.argv:
        with open(RECORD, "w") as file:
            file.write("law,isa,instructions_per_contact_update\n")
            for (law, isa), count in counts.items():
                file.write(f"{law},{isa},{count:.1f}\n")
    with open(RECORD) as file:
        before = {(row["law"], row["isa"]): float(row["instructions_per_contact_update"]) for row in csv.DictReader(file)}
    dearer = False
    print(f"{'law':28}{'isa':10}{'recorded':>10}{'now':>10}{'change':>9}")
    for key, count in counts.items():
        change = count / before[key] - 1
        dearer |= change > NOTICED
        print(f"{key[0]:28}{key[1]:10}{before[key]:10.1f}{count:10.1f}{100 * change:8.1f}%")
    if dearer:
        sys.exit(f"dearer by more than {100 * NOTICED:.0f} %")


if __name__ == "__main__":
    main()
