"""Times whole processes by turns, from files to the areas of all atoms, for bench/run.sh --peers.

Usage: python3 programs.py HARDSPHERE MOLECULE.pdb RESULT.json [--quick]

The inputs are made here: sets of a given size are copies of the molecule side by side, and small files are parts of it.
A turn is one run of each program, and what counts is its processor time, user and system, and its largest memory. The
program gets the radii of whom it is compared with: those of FreeSASA, or one for each element. Errors are against the
areas of hardsphere. Memory below that of Python, which starts the programs, is not seen. The result is what Google
Benchmark would write; a table of it is printed.
"""
import csv
import json
import os
import random
import shutil
import statistics
import subprocess
import sys
import tempfile

from trajectories import DEBIAN_PYTHON, PROBE, RADIUS, column, entry, read_atoms, skipped, version_of

SIZES, TURNS = (1, 1000, 100000, 1000000), 3
FILES, ATOMS_OF_FILE = 2000, (300, 5000)
GAP = 3.0  # angstrom, between copies
FREESASA = {"freesasa_sr_100": ("--shrake-rupley", "--resolution=100"),
            "freesasa_lr_20": ("--lee-richards", "--resolution=20")}
MDTRAJ = """
import json, sys
import mdtraj
radii = json.loads(sys.argv[2])
one = mdtraj.load(sys.argv[1])
areas = mdtraj.shrake_rupley(one, probe_radius=float(sys.argv[3]), n_sphere_points=100, change_radii=radii)
print("area\\n" + "\\n".join(str(100 * float(area)) for area in areas[0]))
"""


def write_copies(lines, at, atoms, path):
    """The first atoms of copies of a molecule on a cubic grid."""
    step = [max(axis) - min(axis) + GAP for axis in zip(*at)]
    side = max(1, round((atoms / len(at)) ** (1 / 3)) + 1)
    with open(path, "w", encoding="ascii") as file:
        for number in range(atoms):
            copy, k = divmod(number, len(at))
            moved = [x + s * (copy // side ** axis % side) for axis, (x, s) in enumerate(zip(at[k], step))]
            place = "".join(f"{x:8.3f}" for x in moved)
            line = lines[k]
            chain = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"[copy % 26]
            file.write(f"{line[:6]}{number % 99999 + 1:5d}{line[11:21]}{chain}{line[22:30]}{place}{line[54:].rstrip()}\n")
        file.write("END\n")


def run(command, out="out.txt"):
    """Processor seconds and megabytes; what the program prints goes to a file."""
    with open(out, "wb") as file:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=file, stderr=subprocess.DEVNULL)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = status
    if status != 0:
        raise subprocess.CalledProcessError(status, command[0])
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def rows_of(path="out.txt"):
    with open(path, encoding="ascii") as file:
        return [float(row["area"]) for row in csv.DictReader(file)]


def areas_of_pdb(path="out.txt"):
    with open(path, encoding="ascii") as file:
        return [float(line[60:66]) for line in file if line.startswith(("ATOM  ", "HETATM"))]


def peers_of(program, path):
    """Of each program the one that has its radii, its command and where its areas are then."""
    measure = [program, "measure", path, "--probe", str(PROBE), "--threads", "1", "--csv"]
    by_element = ",".join(f"{e}={r}" for e, r in RADIUS.items())
    peers = {"library": (None, measure + ["--radii", "protor"], rows_of),
             "library_by_element": (None, measure + ["--radius", by_element], rows_of)}
    if shutil.which("freesasa"):
        for key, options in FREESASA.items():
            command = ["freesasa", *options, "--n-threads=1", "--format=pdb", path]
            peers[key] = ("library", command, areas_of_pdb)
    if shutil.which("gmx"):
        command = ["gmx", "-nobackup", "sasa", "-f", path, "-s", path, "-surface", "all", "-ndots", "24", "-probe",
                   str(PROBE / 10), "-nopbc", "-o", "total.xvg", "-or", "residues.xvg", "-oa", "atoms.xvg"]
        peers["gmx_24"] = ("library_by_element", command, lambda: column("atoms.xvg", 1))
    if version_of(DEBIAN_PYTHON, "-c", "import mdtraj; print(mdtraj.version.version)"):
        radii = json.dumps({e: r / 10 for e, r in RADIUS.items()})
        command = [DEBIAN_PYTHON, "-c", MDTRAJ, path, radii, str(PROBE / 10)]
        peers["mdtraj_100"] = ("library_by_element", command, rows_of)
    return peers


def compare(name, peers, turns, atoms, areas=True):
    """The results of so many turns."""
    seconds, memory, found, failed = {}, {}, {}, set()
    for _ in range(turns):
        for key, (_, command, read) in peers.items():
            if key in failed:
                continue
            try:
                took, megabytes = run(command)
                found[key] = read() if areas else []
            except (OSError, ValueError, subprocess.CalledProcessError):
                failed.add(key)
                continue
            seconds.setdefault(key, []).append(took)
            memory[key] = max(megabytes, memory.get(key, 0.0))
    results = []
    for key, (reference, _, _) in peers.items():
        label = f"peers/programs/{key}/{name}"
        if key in failed:
            results.append(entry(label, {"error_occurred": True, "error_message": "it fails on this input"}))
            continue
        own = reference or key
        numbers = {"cpu_time": min(seconds[key]), "atoms": atoms, "megabytes": memory[key],
                   "ratio": statistics.median(a / max(b, 1e-3) for a, b in zip(seconds[key], seconds[own]))}
        if areas and len(found[key]) == len(found[own]):
            total = sum(found[own])
            numbers["total_error"] = abs(sum(found[key]) - total) / total
            numbers["atom_error"] = statistics.fmean(abs(a - b) for a, b in zip(found[key], found[own]))
        results.append(entry(label, numbers))
        print(f"{label:55} {numbers['cpu_time']:9.3f} s {numbers['ratio']:8.2f} times {memory[key]:7.0f} MB  "
              f"total {numbers.get('total_error', 0.0):.1e}, atoms {numbers.get('atom_error', 0.0):.3f}", flush=True)
    return results


def compare_files(program, lines, at, files, turns):
    """Many small files: one call of the library's program, and one of another program for each file, as FreeSASA does
    not get through any file in a list."""
    chance = random.Random(50)
    names = [f"{k:04}.pdb" for k in range(files)]
    sizes = [round(ATOMS_OF_FILE[0] * (ATOMS_OF_FILE[1] / ATOMS_OF_FILE[0]) ** chance.random()) for _ in names]
    for name, atoms in zip(names, sizes):
        write_copies(lines, at, atoms, name)
    peers = {"library": (None, [program, "measure", *names, "--probe", str(PROBE), "--radii", "protor", "--threads",
                                "1", "--json"], None)}
    if shutil.which("freesasa"):
        for key, options in FREESASA.items():
            loop = f"for file in [0-9]*.pdb; do freesasa {' '.join(options)} --n-threads=1 $file || exit 1; done"
            peers[key] = ("library", ["sh", "-c", loop], None)
    return compare(f"{files}_files", peers, turns, sum(sizes), areas=False)


def main():
    program, molecule, result = map(os.path.abspath, sys.argv[1:4])
    quick = "--quick" in sys.argv
    turns = 1 if quick else TURNS
    lines, at = read_atoms(molecule)
    benchmarks = [skipped(*package) for package in (("FreeSASA", "freesasa"), ("GROMACS", "gromacs"))
                  if not shutil.which({"gromacs": "gmx"}.get(package[1], package[1]))]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with open("vdwradii.dat", "w", encoding="ascii") as file:
            file.writelines(f"??? {element} {radius / 10}\n" for element, radius in RADIUS.items())
        for atoms in SIZES[:2] if quick else SIZES:
            write_copies(lines, at, atoms, "copies.pdb")
            benchmarks += compare(str(atoms), peers_of(program, "copies.pdb"), turns, atoms)
        benchmarks += compare_files(program, lines, at, 20 if quick else FILES, turns)
        os.chdir("/")
    with open(result, "w", encoding="ascii") as file:
        json.dump({"context": {}, "benchmarks": benchmarks}, file, indent=1)


if __name__ == "__main__":
    main()
