"""Frequencies of ethanol: xtb's own second derivatives in gas, and those of a surface tension by the program hardsphere.

normal_modes.py PROGRAM GEOMETRY HESSIAN

GEOMETRY is xtb's minimum, HESSIAN its file of second derivatives there. The surface must not know how the molecule is
turned: all frequencies are the same to 0.001 cm-1.
"""
import io
import subprocess
import sys

import numpy
import scipy.io
import scipy.spatial.transform
from ase import Atoms, io as files, units
from ase.vibrations import VibrationsData

program, geometry, hessian = sys.argv[1:]
molecule = files.read(geometry)
n = len(molecule)
words = open(hessian, encoding="ascii").read().split()[1:]  # behind a heading, in Eh / bohr^2
of_gas = numpy.array(words, dtype=float).reshape(3 * n, 3 * n) * units.Hartree / units.Bohr**2
tension = 0.0072 * units.kcal / units.mol  # per angstrom^2


def of_surface(atoms, options):
    """By x, y and z of one atom after the other, in angstrom."""
    lines = "".join("%s %.10f %.10f %.10f\n" % (a.symbol, *a.position) for a in atoms)
    call = [program, "hessian", "-", "--format", "xyz", "--probe", "1.4", "--tension", "%.17g" % tension, *options]
    done = subprocess.run(call, input="%d\n\n%s" % (n, lines), capture_output=True, text=True, check=True)
    return scipy.io.mmread(io.BytesIO(done.stdout.encode())).toarray()


def frequencies(atoms, matrix):
    """In cm-1; imaginary ones are negative."""
    symmetric = (matrix + matrix.T) / 2
    found = VibrationsData(atoms, symmetric.reshape(n, 3, n, 3)).get_frequencies()
    return numpy.sort(numpy.where(abs(found.imag) > abs(found.real), -found.imag, found.real))


alone = frequencies(molecule, of_gas)
print("gas          ", *("%10.4f" % f for f in alone[6:12]))
for options in [], ["--window", "0.1"]:
    seen = []
    for angles in (0, 0, 0), (0.3, 0.7, 1.1), (1.3, 2.1, 0.4):
        turn = scipy.spatial.transform.Rotation.from_euler("zyx", angles).as_matrix()
        atoms = Atoms(molecule.symbols, molecule.positions @ turn.T)
        every = numpy.kron(numpy.eye(n), turn)
        seen.append(frequencies(atoms, every @ of_gas @ every.T + of_surface(atoms, options)))
        print("window 0.1   " if options else "plain area   ", *("%10.4f" % f for f in seen[-1][6:12]))
    moved = numpy.abs(numpy.array(seen)[1:, 6:] - seen[0][6:]).max()
    assert moved < 1e-3, "orientations differ by %g cm-1" % moved
    shift = abs(seen[0][6:] - alone[6:]).max()
    assert shift > 1, "the surface changes no frequency by more than %g cm-1" % shift
