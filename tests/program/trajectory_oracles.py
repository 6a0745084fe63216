"""See trajectory_oracles.sh."""
import csv
import os
import subprocess
import sys

program, source, work = sys.argv[1:]
MOLECULE = os.path.join(source, "bench", "molecules", "crambin.pdb")
with open(MOLECULE) as file:
    LINES = [line for line in file if line.startswith(("ATOM", "HETATM"))]
COORDINATES = [[float(line[at:at + 8]) for at in (30, 38, 46)] for line in LINES]
# Orthorhombic, and triclinic as GROMACS has it; in Angstrom.
BOXES = [[[40.96, 0, 0], [0, 18.65, 0], [0, 0, 22.52]], [[25, 0, 0], [7, 18, 0], [-9, 5, 20]],
         [[30, 0, 0], [0, 30, 0], [0, 0, 30]]]


def frames():
    """Coordinates of each frame, moved by multiples of 0.01 Angstrom, with its box."""
    state = 1
    for number, box in enumerate(BOXES):
        moved = []
        for place in COORDINATES:
            row = []
            for x in place:
                state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
                row.append(round(x, 2) + ((state >> 40) % 61 - 30) / 100 * number)
            moved.append(row)
        yield moved, box


def run(arguments):
    result = subprocess.run([program] + arguments, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit("hardsphere %s: %s" % (" ".join(arguments), result.stderr))
    return list(csv.DictReader(result.stdout.splitlines()))


def measured_alone(coordinates, box):
    """The molecule with these coordinates, as a trajectory of one frame in a file with more digits than they have."""
    path = os.path.join(work, "frame.xyz")
    with open(path, "w") as file:
        file.write("%d\nLattice=\"%s\"\n" % (len(coordinates), " ".join("%.5f" % x for row in box for x in row)))
        for place in coordinates:
            file.write("C %s\n" % " ".join("%.5f" % x for x in place))
    return run(["measure", MOLECULE, "--trajectory", path, "--box", "file"])[0]


def compare(name, path, read):
    """read: (coordinates, box) of every frame of the file, in Angstrom, by somebody else."""
    found = run(["measure", MOLECULE, "--trajectory", path, "--box", "file"])
    if len(found) != len(read):
        sys.exit("%s: %d frames, not %d" % (name, len(found), len(read)))
    for row, (coordinates, box) in zip(found, read):
        alone = measured_alone(coordinates, box)
        # Files hold floats, of which the others keep no more.
        for key, tolerance in (("area", 2e-2), ("volume", 2e-2), ("box_volume", 2e-2)):
            if abs(float(row[key]) - float(alone[key])) > tolerance:
                sys.exit("%s, frame %s: %s is %s, not %s" % (name, row["frame"], key, row[key], alone[key]))
    areas = {row["area"] for row in found}
    if len(areas) != len(found):
        sys.exit("%s: frames are alike" % name)
    print("%s: %d frames" % (name, len(found)))


def with_mdtraj():
    import mdtraj
    import numpy

    everything = list(frames())
    xyz = numpy.array([moved for moved, _ in everything], dtype=numpy.float32) / 10
    boxes = numpy.array([box for _, box in everything], dtype=numpy.float32) / 10
    trajectory = mdtraj.Trajectory(xyz, mdtraj.load(MOLECULE, standard_names=False).topology)
    trajectory.unitcell_vectors = boxes
    for ending in ("xtc", "dcd", "nc"):
        path = os.path.join(work, "mdtraj." + ending)
        trajectory.save(path)
        again = mdtraj.load(path, top=trajectory.topology)
        compare("mdtraj " + ending, path,
                [(10.0 * again.xyz[k], 10.0 * again.unitcell_vectors[k]) for k in range(len(everything))])


def with_mdanalysis():
    import MDAnalysis
    import numpy

    everything = list(frames())
    universe = MDAnalysis.Universe(MOLECULE)
    for ending in ("xtc", "dcd", "ncdf"):
        path = os.path.join(work, "mdanalysis." + ending)
        with MDAnalysis.Writer(path, len(LINES)) as writer:
            for moved, box in everything:
                universe.atoms.positions = numpy.array(moved, dtype=numpy.float32)
                universe.dimensions = MDAnalysis.lib.mdamath.triclinic_box(*numpy.array(box, dtype=float))
                writer.write(universe.atoms)
        read = []
        for step in MDAnalysis.Universe(MOLECULE, path).trajectory:
            read.append((step.positions.astype(float), step.triclinic_dimensions.astype(float)))
        compare("MDAnalysis " + ending, path, read)


def with_scipy():
    """AMBER's conventions, in both classic formats that scipy writes, as floats and as doubles, scaled or not."""
    import numpy
    from scipy.io import netcdf_file

    for version, kind, scale in ((1, "f4", None), (2, "f8", None), (2, "f4", 0.5)):
        path = os.path.join(work, "scipy_%d_%s_%s.nc" % (version, kind, scale))
        with netcdf_file(path, "w", version=version) as file:
            file.Conventions, file.ConventionVersion, file.program = "AMBER", "1.0", "scipy"
            for name, size in (("frame", None), ("spatial", 3), ("atom", len(LINES)), ("cell_spatial", 3),
                               ("cell_angular", 3), ("label", 5)):
                file.createDimension(name, size)
            file.createVariable("spatial", "c", ("spatial",))[:] = list("xyz")
            time = file.createVariable("time", "f4", ("frame",))
            time.units = "picosecond"
            xyz = file.createVariable("coordinates", kind, ("frame", "atom", "spatial"))
            xyz.units = "angstrom"
            if scale is not None:
                xyz.scale_factor = scale
            lengths = file.createVariable("cell_lengths", "f8", ("frame", "cell_spatial"))
            angles = file.createVariable("cell_angles", "f8", ("frame", "cell_angular"))
            lengths.units, angles.units = "angstrom", "degree"
            for number, (moved, box) in enumerate(frames()):
                box = numpy.array(box, dtype=float)
                size = numpy.linalg.norm(box, axis=1)
                time[number] = 2.5 * number
                xyz[number] = numpy.array(moved) / (scale or 1)
                lengths[number] = size
                angles[number] = [numpy.degrees(numpy.arccos(box[i] @ box[j] / size[i] / size[j]))
                                  for i, j in ((1, 2), (0, 2), (0, 1))]
        with netcdf_file(path, "r", mmap=False) as file:
            read = [((scale or 1) * place.astype(float), box)
                    for place, (_, box) in zip(file.variables["coordinates"][:], frames())]
        compare("scipy %d %s %s" % (version, kind, scale), path, read)


ran = False
for test, package in ((with_mdtraj, "mdtraj"), (with_mdanalysis, "MDAnalysis"), (with_scipy, "scipy")):
    try:
        __import__(package)
    except ImportError as error:
        print("without %s: %s" % (package, error))
        continue
    test()
    ran = True
if not ran:
    sys.exit(77)
