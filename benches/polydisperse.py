#!/usr/bin/env python3
"""What a contact costs where sizes differ, against equal discs: benches/polydisperse.toml, four times.

    benches/polydisperse.py [--ballast PATH] [--rounds N] [--core N] [--csv FILE]

20 000 discs with radii from a log-normal distribution cut to a ratio of 1 : 30 against 20 000 equal ones, and
50 000 equal discs with one of 100 times their radius among them against 50 000 without. All are gathered in a
periodic cell until they press on each other, and then held. Samples are prepared in each round anew: some minutes
each. The cost of a contact is the processor time of a whole cycle, motion included, over its touching contacts, on
one core; ratios are medians of the rounds.
"""
import argparse
import csv
import io
import math
import os
import statistics
import subprocess
import sys

RADIUS = 1e-3
LARGE = 100
SPREAD = 0.57
RATIO = 30
# What the preset presses them to [Pa].
STRESS = 5e3


def mean_square():
    """Of the radii of the log-normal scene, over that of equal ones."""
    limit = 0.5 * math.log(RATIO)
    steps = [limit * (2 * (k + 0.5) / 2000 - 1) for k in range(2000)]
    weights = [math.exp(-0.5 * (z / SPREAD) ** 2) for z in steps]
    return sum(w * math.exp(2 * z) for w, z in zip(weights, steps)) / sum(weights)


def overrides(grains, distribution, area, large):
    """Settings of a scene whose discs cover so much; generated at random they cover half of the cell."""
    edge = math.sqrt(area / 0.5)
    return [
        f"generate.grains.distribution={{{distribution}, count={grains}}}",
        f"generate.grains.in={{rectangle={{min=[0.0, 0.0], max=[{edge!r}, {edge!r}]}}}}",
        f"cell.size=[{edge!r}, {edge!r}]",
        f"particle.1.at=[{edge / 2!r}, {edge / 2!r}]",
        f"particle.1.radius={large!r}",
    ]


def scenes():
    disc = math.pi * RADIUS**2
    equal = f'kind="uniform", min={RADIUS}, max={RADIUS}'
    # The mean and the deviation of the radius itself, before it is cut.
    mean = RADIUS * math.exp(SPREAD**2 / 2)
    deviation = mean * math.sqrt(math.exp(SPREAD**2) - 1)
    low, high = RADIUS / math.sqrt(RATIO), RADIUS * math.sqrt(RATIO)
    spread = f'kind="lognormal", mean={mean!r}, deviation={deviation!r}, min={low!r}, max={high!r}'
    return {
        "equal-20k": overrides(19_999, equal, 20_000 * disc, RADIUS),
        "lognormal-20k": overrides(19_999, spread, 20_000 * disc * mean_square(), RADIUS),
        "equal-50k": overrides(49_999, equal, 50_000 * disc, RADIUS),
        "one-large-50k": overrides(49_999, equal, (50_000 + LARGE**2) * disc, LARGE * RADIUS),
    }


PAIRS = [("lognormal-20k", "equal-20k"), ("one-large-50k", "equal-50k")]


def measured(ballast, core, settings):
    deck = os.path.join(os.path.dirname(os.path.abspath(__file__)), "polydisperse.toml")
    command = [ballast, "bench", deck, "--quiet", "--csv", "-"]
    for setting in settings:
        command += ["--set", setting]
    if core is not None:
        command = ["taskset", "-c", str(core)] + command
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{done.stderr}")
    row = next(csv.DictReader(io.StringIO(done.stdout)))
    if not 0.5 < float(row["mean_stress"]) / STRESS < 2:
        sys.exit(f"{' '.join(command)}\nthey press with {row['mean_stress']} Pa instead of {STRESS}")
    updates = float(row["contact_updates_per_s"]) / float(row["busy"])
    cycles = float(row["cycles_per_s"])
    return {
        "particles": row["particles"],
        "pairs": row["pairs"],
        "contacts": round(float(row["contact_updates_per_s"]) / cycles),
        "ns": 1e9 / updates,
        "isa": row["isa"],
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ballast", default="ballast", help="the program")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--core", type=int, default=None, help="run on this core")
    parser.add_argument("--csv", default=None, help="write the table there, too")
    options = parser.parse_args()
    rounds = []
    for _ in range(options.rounds):
        rounds.append({name: measured(options.ballast, options.core, set) for name, set in scenes().items()})
    rows = []
    for name, base in PAIRS:
        for scene in (base, name):
            last = rounds[-1][scene]
            ns = statistics.median(all[scene]["ns"] for all in rounds)
            ratio = statistics.median(all[scene]["ns"] / all[base]["ns"] for all in rounds)
            rows.append([scene, last["particles"], last["contacts"], last["pairs"], f"{ns:.2f}", f"{ratio:.2f}", last["isa"]])
            print(f"{scene:14} {last['particles']:>6} particles {last['contacts']:>6} contacts {last['pairs']:>6} pairs "
                  f"{ns:6.2f} ns/update = {ratio:.2f} of {base}", flush=True)
    if options.csv:
        with open(options.csv, "w", newline="") as file:
            table = csv.writer(file)
            table.writerow(["scene", "particles", "contacts", "pairs", "ns_per_update", "ratio", "isa"])
            table.writerows(rows)


if __name__ == "__main__":
    main()
