"""Times hardsphere measure --trajectory by turns with gmx sasa and mdtraj, for bench/run.sh --peers.

Usage: python3 trajectories.py HARDSPHERE MOLECULE.pdb RESULT.json [--quick]

The run is made here: frames in which every atom is moved by random amounts about where the file has it, as a .trr file
of single precision. Everybody reads that file and gets the same radii and probe. A turn is one run of each program, and
what counts is its processor time, user and system; of mdtraj, reading and areas alone without the start of Python.
Errors are against the areas of hardsphere. The result is what Google Benchmark would write.
"""
import csv
import json
import os
import random
import re
import resource
import shutil
import statistics
import struct
import subprocess
import sys
import tempfile

FRAMES, TURNS = 301, 3
SPREAD = 0.2  # angstrom, of each coordinate
PROBE = 1.4
RADIUS = {"C": 1.7, "N": 1.55, "O": 1.52, "S": 1.8}
DOTS = (24, 100, 1000)  # gmx sasa's default is 24
POINTS = (100, 960)  # mdtraj's default is 960
DEBIAN_PYTHON = "/usr/bin/python3"  # for which Debian has mdtraj

MDTRAJ = """
import json, os, sys
import mdtraj
radii, points, probe = json.loads(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3])
before = os.times()
run = mdtraj.load("run.trr", top="run.pdb")
areas = mdtraj.shrake_rupley(run, probe_radius=probe, n_sphere_points=points, change_radii=radii)
after = os.times()
json.dump([after.user + after.system - before.user - before.system, (100.0 * areas.astype(float)).tolist()], sys.stdout)
"""


def read_atoms(path):
    """The lines of the atoms of a .pdb file and their coordinates in angstrom."""
    with open(path, encoding="ascii") as file:
        lines = [line for line in file if line.startswith("ATOM  ") and line[76:78].strip() in RADIUS]
    return lines, [[float(line[k:k + 8]) for k in (30, 38, 46)] for line in lines]


def trr_frame(step, coordinates):
    """A frame in single precision without velocities and forces; coordinates, all of one after the other, in nm."""
    box = [8, 0, 0, 0, 8, 0, 0, 0, 8]
    head = struct.pack(">3i12s", 1993, 13, 12, b"GMX_trn_file")
    sizes = struct.pack(">10i", 0, 0, 4 * len(box), 0, 0, 0, 0, 4 * len(coordinates), 0, 0)
    return (head + sizes + struct.pack(">3i2f", len(coordinates) // 3, step, 0, float(step), 0) +
            struct.pack(f">{len(box) + len(coordinates)}f", *box, *coordinates))


def write_inputs(lines, at):
    """run.trr, and files that name its atoms and have their radii."""
    chance = random.Random(45)
    with open("run.trr", "wb") as file:
        for step in range(FRAMES):
            file.write(trr_frame(step, [(x + chance.gauss(0, SPREAD)) / 10 for atom in at for x in atom]))
    with open("run.pdb", "w", encoding="ascii") as file:
        file.writelines(lines)
    with open("run.xyzr", "w", encoding="ascii") as file:
        for line, atom in zip(lines, at):
            print(*atom, RADIUS[line[76:78].strip()], file=file)
    with open("vdwradii.dat", "w", encoding="ascii") as file:
        for element, radius in RADIUS.items():
            print("???", element, radius / 10, file=file)


def run(*command):
    """What the program prints, and the processor time that it takes."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, check=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def by_hardsphere(program):
    """The total of each frame, the mean of each atom, and seconds; so in what follows. The totals come from a run of
    their own, whose seconds do not count: areas are computed once."""
    measure = (program, "measure", "run.xyzr", "--trajectory", "run.trr", "--probe", str(PROBE), "--threads", "1")
    rows, _ = run(*measure)
    means, seconds = run(*measure, "--mean", "--csv")
    totals, atoms = ([float(row["area"]) for row in csv.DictReader(text.splitlines())] for text in (rows, means))
    return totals, atoms, seconds


def column(path, k):
    """Column k of an .xvg file in nm^2, in square angstrom."""
    with open(path, encoding="ascii") as file:
        return [100 * float(line.split()[k]) for line in file if line[0] not in "#@"]


def by_gmx(dots):
    _, seconds = run("gmx", "-nobackup", "sasa", "-f", "run.trr", "-s", "run.pdb", "-surface", "all", "-ndots",
                     str(dots), "-probe", str(PROBE / 10), "-nopbc", "-o", "total.xvg", "-oa", "atoms.xvg")
    return column("total.xvg", 1), column("atoms.xvg", 1), seconds


def by_mdtraj(points):
    text, _ = run(DEBIAN_PYTHON, "-c", MDTRAJ, json.dumps({e: r / 10 for e, r in RADIUS.items()}), str(points),
                  str(PROBE / 10))
    seconds, areas = json.loads(text)
    return [sum(frame) for frame in areas], [statistics.fmean(atom) for atom in zip(*areas)], seconds


def version_of(*command, pattern=r"(\d[\w.]*)"):
    """The version that a program says it has; None if it does not run."""
    try:
        return re.search(pattern, run(*command)[0])[1]
    except (OSError, subprocess.CalledProcessError, TypeError):
        return None


def entry(name, numbers):
    return {"name": name, "run_name": name, "run_type": "iteration", "time_unit": "s"} | numbers


def skipped(name, package):
    return entry("peers/skipped/" + name, {"error_occurred": True, "error_message": package + " is not installed"})


def main():
    program, molecule, result = map(os.path.abspath, sys.argv[1:4])
    turns = 1 if "--quick" in sys.argv else TURNS
    name = os.path.splitext(os.path.basename(molecule))[0]
    programs = {"library": lambda: by_hardsphere(program)}
    context, benchmarks = {}, []
    gmx = version_of("gmx", "--version", pattern=r"version:\s*(\S+)") if shutil.which("gmx") else None
    mdtraj = version_of(DEBIAN_PYTHON, "-c", "import mdtraj; print(mdtraj.version.version)")
    for title, version, package in (("GROMACS", gmx, "gromacs"), ("mdtraj", mdtraj, "python3-mdtraj")):
        if version is None:
            benchmarks.append(skipped(title, package))
        else:
            context["peer_" + title] = version
    if gmx is not None:
        programs |= {f"gmx_{dots}": lambda dots=dots: by_gmx(dots) for dots in DOTS}
    if mdtraj is not None:
        programs |= {f"mdtraj_{points}": lambda points=points: by_mdtraj(points) for points in POINTS}
    lines, at = read_atoms(molecule)
    seconds, right = {key: [] for key in programs}, None
    errors = {}
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        write_inputs(lines, at)
        for _ in range(turns):
            for key, measure in programs.items():
                totals, atoms, took = measure()
                seconds[key].append(took)
                right = right or (totals, atoms)
                if len(totals) != FRAMES or len(atoms) != len(at):
                    sys.exit(f"{key}: {len(totals)} frames of {len(atoms)} atoms")
                of_totals = [a - b for a, b in zip(totals, right[0])]
                of_atoms = [abs(a - b) for a, b in zip(atoms, right[1])]
                errors[key] = {"total_error": statistics.fmean(e * e for e in of_totals) ** 0.5,
                               "atom_error": max(of_atoms), "mean_atom_error": statistics.fmean(of_atoms)}
        os.chdir("/")
    for key, taken in seconds.items():
        ratios = [a / b for a, b in zip(taken, seconds["library"])]
        benchmarks.append(entry(f"peers/trajectories/{key}/{name}", {
            "cpu_time": min(taken), "atoms": len(at), "frames": FRAMES, "taken": statistics.median(taken),
            "ratio": statistics.median(ratios), "area": statistics.fmean(right[0])} | errors[key]))
    with open(result, "w", encoding="ascii") as file:
        json.dump({"context": context, "benchmarks": benchmarks}, file, indent=1)


if __name__ == "__main__":
    main()
