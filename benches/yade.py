#!/usr/bin/env python3
"""Ballast against YADE on the same 600 spheres, paired: speed, contacts and stress after some steps.

    benches/yade.py [--ballast PATH] [--work FOLDER] [--rounds N] [--core N]

Needs YADE (Debian: apt install yade). YADE runs its Hertz-Mindlin law on the particles that
`ballast export lammps shear-600` writes, with the same step and the same shear of the periodic cell; it is
three-dimensional, so particles are kept in their plane. Times are processor time of its loop.
"""
import argparse
import csv
import io
import os
import re
import statistics
import subprocess

SCRIPT = '''
import csv, time
from yade import *
points = [(float(row["x"]), float(row["y"]), float(row["radius"])) for row in csv.DictReader(open("{table}"))]
depth, thickness = 10 * max(point[2] for point in points), {thickness}
O.periodic = True
O.cell.setBox({size}, depth)
O.materials.append(FrictMat(young=70e9, poisson=0.25, frictionAngle=math.atan(0.3), density=2650))
for x, y, radius in points:
    body = sphere((x, y, depth / 2), radius)
    body.state.blockedDOFs = "zXY"
    O.bodies.append(body)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=0.05e-3),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(en=0.5)],
                    [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(damping=0),
]
O.dt = {step}
O.cell.velGrad = Matrix3({rate}, 0, 0, 0, -{rate}, 0, 0, 0, 0)
O.run(200, True)
start = time.process_time()
O.run({steps}, True)
used = time.process_time() - start
stress = utils.getStress(O.cell.volume)
print("RATE", {steps} / used, sum(1 for i in O.interactions if i.isReal),
      -(stress[0, 0] + stress[1, 1]) / 2 * depth / thickness, flush=True)
'''


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ballast", default="ballast", help="the program")
    parser.add_argument("--yade", default="yade", help="YADE")
    parser.add_argument("--work", default="target/yade", help="folder for the particles")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--steps", type=int, default=20000)
    parser.add_argument("--core", type=int, default=None, help="run on this core")
    options = parser.parse_args()
    pin = [] if options.core is None else ["taskset", "-c", str(options.core)]

    def run(words):
        done = subprocess.run(pin + words, cwd=options.work, capture_output=True, text=True)
        if done.returncode:
            raise SystemExit(f"{' '.join(words)}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
        return done.stdout

    os.makedirs(options.work, exist_ok=True)
    run([options.ballast, "export", "lammps", "shear-600", "-o", ".", "-q"])
    deck = open(os.path.join(options.work, "in.periodic-shear")).read()
    data = open(os.path.join(options.work, "periodic-shear.data")).read()
    sides = [re.search(rf"^(\S+) (\S+) {axis}lo {axis}hi", data, re.M) for axis in "xy"]
    script = SCRIPT.format(
        table="periodic-shear.csv",
        size=", ".join(str(float(side.group(2)) - float(side.group(1))) for side in sides),
        thickness=re.search(r"^variable thickness equal (\S+)", deck, re.M).group(1),
        step=re.search(r"^timestep (\S+)", deck, re.M).group(1),
        rate=re.search(r"deform 1 x trate (\S+)", deck).group(1),
        steps=options.steps,
    )
    with open(os.path.join(options.work, "shear.py"), "w") as file:
        file.write(script)
    ours, theirs = [], []
    for _ in range(options.rounds):
        said = run([options.ballast, "bench", "shear-600", "--cycles", str(options.steps), "--csv", "-", "-q"])
        (row,) = csv.DictReader(io.StringIO(said))
        ours.append(float(row["cycles_per_s"]) / min(float(row["busy"]), 1.0))
        found = re.search(r"^RATE (\S+) (\S+) (\S+)", run([options.yade, "-n", "-x", "-j1", "shear.py"]), re.M)
        theirs.append(float(found.group(1)))
    a, b = statistics.median(ours), statistics.median(theirs)
    print(f"shear-600: {a:.4g} / {b:.4g} steps/s = {a / b:.1f}; contacts {float(row['contacts']):.0f} / "
          f"{found.group(2)}, mean stress {float(row['mean_stress']):.6g} / {float(found.group(3)):.6g} Pa")


if __name__ == "__main__":
    main()
