"""Times whole processes by turns, from files to the areas of all atoms, for bench/run.sh --peers and --programs.

Usage: python3 programs.py BUILD MOLECULE.pdb RESULT.json [--quick]

BUILD is a folder with the programs hardsphere, read_alone and gemmi_read in capi and bench. The inputs are made here:
sets of a given size are copies of the molecule side by side, small files are parts of it, and in a trajectory every
atom is moved by random amounts. A turn is one run of each program; what counts is its processor time, user and system,
the time that passes, and its largest memory. The program gets the radii of whom it is compared with: those of FreeSASA,
or one for each element. Errors are against the areas of hardsphere. Memory below that of Python, which starts the
programs, is not seen. The result is what Google Benchmark would write; a table of it is printed.
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
import time

from trajectories import DEBIAN_PYTHON, PROBE, RADIUS, column, entry, read_atoms, skipped, trr_frame, version_of

SIZES, TWO_THREADS, TURNS = (1, 1000, 100000, 1000000), 100000, 3
MOST_OF_MDTRAJ = 100000  # atoms: 40 s a turn
FILES, ATOMS_OF_FILE = 2000, (300, 5000)
FRAMES, ATOMS_OF_FRAME, SPREAD = 200, 4000, 0.2
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
BY_ELEMENT = ",".join(f"{e}={r}" for e, r in RADIUS.items())


def copies(lines, at, atoms):
    """Line and coordinates of the first atoms of copies of a molecule on a cubic grid."""
    step = [max(axis) - min(axis) + GAP for axis in zip(*at)]
    side = max(1, round((atoms / len(at)) ** (1 / 3)) + 1)
    for number in range(atoms):
        copy, k = divmod(number, len(at))
        chain = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"[copy % 26]
        line = f"{lines[k][:6]}{number % 99999 + 1:5d}{lines[k][11:21]}{chain}{lines[k][22:].rstrip()}"
        yield line, [x + s * (copy // side ** axis % side) for axis, (x, s) in enumerate(zip(at[k], step))]


def write_copies(lines, at, atoms, path):
    with open(path, "w", encoding="ascii") as file:
        for line, moved in copies(lines, at, atoms):
            file.write(f"{line[:30]}{''.join(f'{x:8.3f}' for x in moved)}{line[54:]}\n")
        file.write("END\n")


def write_cif(lines, at, atoms, path):
    items = ("group_PDB", "id", "type_symbol", "label_atom_id", "label_alt_id", "label_comp_id", "label_asym_id",
             "label_entity_id", "label_seq_id", "Cartn_x", "Cartn_y", "Cartn_z", "occupancy", "B_iso_or_equiv",
             "auth_seq_id", "auth_asym_id", "pdbx_PDB_model_num")
    with open(path, "w", encoding="ascii") as file:
        file.write("data_copies\nloop_\n" + "".join(f"_atom_site.{item}\n" for item in items))
        for number, (line, moved) in enumerate(copies(lines, at, atoms)):
            residue, place = line[22:26].strip(), " ".join(f"{x:.3f}" for x in moved)
            file.write(f"ATOM {number + 1} {line[76:78].strip()} {line[12:16].strip()} . {line[17:20]} {line[21]} 1 "
                       f"{residue} {place} 1.00 10.00 {residue} {line[21]} 1\n")


def write_trajectory(lines, at, atoms, frames):
    """frame.pdb, frame.xyzr and frames.trr."""
    chance = random.Random(50)
    write_copies(lines, at, atoms, "frame.pdb")
    places = []
    with open("frame.xyzr", "w", encoding="ascii") as file:
        for line, moved in copies(lines, at, atoms):
            print(*moved, RADIUS[line[76:78].strip()], file=file)
            places += moved
    with open("frames.trr", "wb") as file:
        for step in range(frames):
            file.write(trr_frame(step, [(x + chance.gauss(0, SPREAD)) / 10 for x in places]))


def run(command, out="out.txt"):
    """Processor seconds, seconds and megabytes; what the program prints goes to a file."""
    before = time.perf_counter()
    with open(out, "wb") as file:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=file, stderr=subprocess.DEVNULL)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = status
    passed = time.perf_counter() - before
    if status != 0:
        raise subprocess.CalledProcessError(status, command[0])
    return used.ru_utime + used.ru_stime, passed, used.ru_maxrss / 1024


def rows_of(path="out.txt"):
    with open(path, encoding="ascii") as file:
        return [float(row["area"]) for row in csv.DictReader(file)]


def areas_of_pdb(path="out.txt"):
    with open(path, encoding="ascii") as file:
        return [float(line[60:66]) for line in file if line.startswith(("ATOM  ", "HETATM"))]


def nothing():
    return []


def measure(program, *files, threads=1):
    return [program, "measure", *files, "--probe", str(PROBE), "--threads", str(threads)]


def gmx_sasa(structure, run_of_it, *options):
    return ["gmx", "-nobackup", "sasa", "-f", run_of_it, "-s", structure, "-surface", "all", "-ndots", "24", "-probe",
            str(PROBE / 10), "-nopbc", "-o", "total.xvg", *options]


def freesasa(threads):
    """Key and command, without the file."""
    found = FREESASA if shutil.which("freesasa") else {}
    return [(key, ["freesasa", *options, f"--n-threads={threads}"]) for key, options in found.items()]


# For each program: the run of hardsphere that it is compared with, its command, and the function that then finds its
# areas.


def peers_of(program, path, atoms, threads=1):
    """Areas of all atoms, printed. With the totals alone, too: that is what FreeSASA prints by itself."""
    both = measure(program, path, threads=threads)
    peers = {"library": (None, both + ["--radii", "protor", "--csv"], rows_of),
             "library_totals": ("library", both + ["--radii", "protor"], nothing),
             "library_by_element": (None, both + ["--radius", BY_ELEMENT, "--csv"], rows_of)}
    for key, command in freesasa(threads):
        peers[key] = ("library", command + ["--format=pdb", path], areas_of_pdb)
        peers[key + "_totals"] = ("library_totals", command + [path], nothing)
    if threads == 1 and shutil.which("gmx"):
        command = gmx_sasa(path, path, "-or", "residues.xvg", "-oa", "atoms.xvg")
        peers["gmx_24"] = ("library_by_element", command, lambda: column("atoms.xvg", 1))
    mdtraj = version_of(DEBIAN_PYTHON, "-c", "import mdtraj; print(mdtraj.version.version)")
    if threads == 1 and atoms <= MOST_OF_MDTRAJ and mdtraj:
        radii = json.dumps({e: r / 10 for e, r in RADIUS.items()})
        command = [DEBIAN_PYTHON, "-c", MDTRAJ, path, radii, str(PROBE / 10)]
        peers["mdtraj_100"] = ("library_by_element", command, rows_of)
    return peers


def peers_of_files(program, names):
    """Many small files, by one call and by a call for each; FreeSASA does not get through any file in a list."""
    options = ["--radii", "protor", "--json"]
    each = " ".join(measure(program, "$file") + options)
    peers = {"library": (None, measure(program, *names) + options, nothing),
             "library_each": ("library", ["sh", "-c", f"for file in [0-9]*.pdb; do {each} || exit 1; done"], nothing)}
    for key, command in freesasa(1):
        loop = f"for file in [0-9]*.pdb; do {' '.join(command)} $file || exit 1; done"
        peers[key] = ("library_each", ["sh", "-c", loop], nothing)
    return peers


def peers_of_frames(program):
    """gmx sasa has one thread for areas."""
    frames = measure(program, "frame.xyzr", "--trajectory", "frames.trr", threads=2)
    peers = {"library": (None, frames, nothing)}
    if shutil.which("gmx"):
        peers["gmx_24"] = ("library", gmx_sasa("frame.pdb", "frames.trr"), nothing)
    return peers


def readers_of(build, path):
    programs = {"library": f"{build}/bench/read_alone", "gemmi": f"{build}/bench/gemmi_read"}
    return {key: (None if key == "library" else "library", [program, path], nothing)
            for key, program in programs.items() if os.path.exists(program)}


def compare(name, peers, turns, atoms):
    """The results of so many turns."""
    seconds, walls, memory, found, failed = {}, {}, {}, {}, set()
    for _ in range(turns):
        for key, (_, command, read) in peers.items():
            if key in failed:
                continue
            try:
                took, passed, megabytes = run(command)
                found[key] = read()
            except (OSError, ValueError, subprocess.CalledProcessError):
                failed.add(key)
                continue
            seconds.setdefault(key, []).append(took)
            walls.setdefault(key, []).append(passed)
            memory[key] = max(megabytes, memory.get(key, 0.0))
    results = []
    for key, (reference, _, _) in peers.items():
        label = f"peers/programs/{key}/{name}/copies"
        if key in failed:
            results.append(entry(label, {"error_occurred": True, "error_message": "it fails on this input"}))
            continue
        own = reference or key
        ratio, wall_ratio = (statistics.median(a / max(b, 1e-3) for a, b in zip(times[key], times[own]))
                             for times in (seconds, walls))
        numbers = {"cpu_time": min(seconds[key]), "atoms": atoms, "megabytes": memory[key], "ratio": ratio,
                   "wall": min(walls[key]), "wall_ratio": wall_ratio}
        if found[key] and len(found[key]) == len(found[own]):
            total = sum(found[own])
            numbers["total_error"] = abs(sum(found[key]) - total) / total
            numbers["atom_error"] = statistics.fmean(abs(a - b) for a, b in zip(found[key], found[own]))
        results.append(entry(label, numbers))
        print(f"{label:55} {numbers['cpu_time']:9.3f} s {ratio:8.2f} times, {numbers['wall']:9.3f} s {wall_ratio:8.2f} "
              f"times by the wall, {memory[key]:7.0f} MB  total {numbers.get('total_error', 0.0):.1e}, atoms "
              f"{numbers.get('atom_error', 0.0):.3f}", flush=True)
    return results


def main():
    build, molecule, result = map(os.path.abspath, sys.argv[1:4])
    program = os.path.join(build, "capi", "hardsphere")
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
            benchmarks += compare(f"one_{atoms}", peers_of(program, "copies.pdb", atoms), turns, atoms)
        atoms = SIZES[1] if quick else TWO_THREADS
        write_copies(lines, at, atoms, "copies.pdb")
        write_cif(lines, at, atoms, "copies.cif")
        benchmarks += compare("two", peers_of(program, "copies.pdb", atoms, threads=2), turns, atoms)
        for kind in ("pdb", "cif"):
            benchmarks += compare(f"read_{kind}", readers_of(build, f"copies.{kind}"), turns, atoms)
        write_trajectory(lines, at, ATOMS_OF_FRAME, 3 if quick else FRAMES)
        benchmarks += compare("frames", peers_of_frames(program), turns, ATOMS_OF_FRAME)
        chance = random.Random(50)
        names = [f"{k:04}.pdb" for k in range(20 if quick else FILES)]
        sizes = [round(ATOMS_OF_FILE[0] * (ATOMS_OF_FILE[1] / ATOMS_OF_FILE[0]) ** chance.random()) for _ in names]
        for name, size in zip(names, sizes):
            write_copies(lines, at, size, name)
        benchmarks += compare("files", peers_of_files(program, names), turns, sum(sizes))
        os.chdir("/")
    context = {"peer_FreeSASA": version_of("freesasa", "--version"),
               "peer_GROMACS": version_of("gmx", "--version", pattern=r"version:\s*(\S+)")}
    with open(result, "w", encoding="ascii") as file:
        json.dump({"context": {key: value for key, value in context.items() if value}, "benchmarks": benchmarks}, file,
                  indent=1)


if __name__ == "__main__":
    main()
