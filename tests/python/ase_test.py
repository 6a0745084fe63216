"""The calculator for ASE: forces and stress against difference quotients of the energy."""
import unittest

import program  # noqa: F401
from program import random_balls, run_block_of_page

import ase
import numpy

import hardsphere
from hardsphere.ase import Solvation


def molecule(n=40, side=9.0):
    centers, _ = random_balls(n, side, seed=3)
    return ase.Atoms("C" * (n // 2) + "O" * (n - n // 2), positions=centers)


def quotients(atoms, step=1e-4):
    """Of a turned cell every move is rounded to the lattice, 1e-8: a smaller step is of no use."""
    found = numpy.zeros((len(atoms), 3))
    for i in range(0, len(atoms), 7):
        for k in range(3):
            energy = []
            for side in step, -step:
                moved = atoms.copy()
                moved.positions[i, k] += side
                moved.calc = Solvation(0.01, 0.002)
                energy.append(moved.get_potential_energy())
            found[i, k] = -(energy[0] - energy[1]) / (2 * step)
    return found[::7]


class Calculator(unittest.TestCase):
    def test_energy_is_that_of_the_areas(self):
        atoms = molecule()
        atoms.calc = Solvation(0.01)
        radii = [hardsphere.radius_of(symbol) for symbol in atoms.symbols]
        areas = hardsphere.measure(atoms.positions, radii, probe=1.4).areas
        self.assertAlmostEqual(atoms.get_potential_energy(), 0.01 * areas.sum(), 12)
        self.assertTrue(numpy.allclose(atoms.get_potential_energies(), 0.01 * areas, rtol=1e-14))

    def test_forces(self):
        atoms = molecule()
        atoms.calc = Solvation(0.01, 0.002)
        forces = atoms.get_forces()
        self.assertTrue(numpy.allclose(forces[::7], quotients(atoms), atol=2e-5))
        self.assertGreater(abs(forces).max(), 1e-2)
        atoms.positions[0] += 0.5  # the next step, with the same calculator
        self.assertTrue(numpy.allclose(atoms.get_forces()[::7], quotients(atoms), atol=2e-5))

    def test_a_skew_cell_that_is_turned(self):
        for cell in [[1, 12, 0.5], [2, 1, 11], [13, 0, 1]], [[0.5, 12, 1], [11, 1, 2], [0, 1, 13]]:  # left-handed, too
            with self.subTest(cell):
                self.one_cell(cell)

    def one_cell(self, cell):
        atoms = molecule()
        atoms.cell, atoms.pbc = cell, True
        atoms.calc = Solvation(0.01, 0.002)
        self.assertTrue(numpy.allclose(atoms.get_forces()[::7], quotients(atoms), atol=2e-5))
        stress, step = atoms.get_stress(voigt=False), 1e-5
        for a, b in (0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2):
            energy = []
            for side in step, -step:
                strain = numpy.eye(3)
                strain[a, b] += side / 2
                strain[b, a] += side / 2
                other = atoms.copy()
                other.set_cell(atoms.cell @ strain.T, scale_atoms=True)
                other.calc = Solvation(0.01, 0.002)
                energy.append(other.get_potential_energy())
            self.assertAlmostEqual(stress[a, b], (energy[0] - energy[1]) / (2 * step) / atoms.get_volume(), 5)

    def test_arrays_of_the_caller_are_copied(self):
        """Before the first step, and between steps with and without a box."""
        atoms = molecule()
        for made in list, numpy.array:
            for changed in "radii", "sigma":
                given = {"radii": made([1.5, 1.8] * 20), "sigma": made([1.0, 0.5] * 20)}
                calculator = Solvation(0.01, **given)
                for pbc in False, True:
                    atoms.cell, atoms.pbc = [12, 12, 12], pbc
                    given[changed][0] += 1
                    expected = Solvation(0.01, radii=[1.5, 1.8] * 20, sigma=[1.0, 0.5] * 20)
                    for name in "energy", "forces", "energies":
                        same = calculator.get_property(name, atoms) == expected.get_property(name, atoms)
                        self.assertTrue(numpy.all(same), (made, changed, pbc, name))

    def test_energies_of_atoms_sum_to_the_energy(self):
        atoms = molecule()
        for pbc in False, True:
            atoms.cell, atoms.pbc = [12, 12, 12], pbc
            atoms.calc = Solvation(0.01, 0.002, sigma=[1.0, 0.5] * 20)
            self.assertAlmostEqual(atoms.get_potential_energies().sum(), atoms.get_potential_energy(), 10)

    def test_after_a_step_that_was_refused_nothing_is_of_the_balls_of_before(self):
        for change in {"numbers": [7, 16]}, {"pbc": False}:
            atoms = ase.Atoms("CO", positions=[[0, 0, 0], [1.2, 0, 0]], cell=[3, 3, 3], pbc=True)
            atoms.calc = Solvation(1.0, probe=0.0)
            atoms.get_potential_energy()
            for name, value in change.items():
                setattr(atoms, name, value)
            atoms.positions[0] = numpy.nan
            with self.assertRaises(ValueError):
                atoms.get_potential_energy()
            atoms.positions[0] = 0.0
            again = atoms.copy()
            again.calc = Solvation(1.0, probe=0.0)
            self.assertEqual(atoms.get_potential_energy(), again.get_potential_energy())

    def test_half_a_box_is_refused(self):
        atoms = molecule()
        atoms.cell, atoms.pbc = [9, 9, 9], [True, True, False]
        atoms.calc = Solvation(0.01)
        with self.assertRaises(ValueError):
            atoms.get_potential_energy()

    def test_the_lines_of_the_guide(self):
        atoms = run_block_of_page("ase.build")["atoms"]
        both = atoms.get_potential_energy()
        solvation = atoms.calc.mixer.calcs[1] if hasattr(atoms.calc, "mixer") else atoms.calc.calcs[1]
        self.assertNotEqual(solvation.get_potential_energy(atoms), 0)
        self.assertNotEqual(both, solvation.get_potential_energy(atoms))


if __name__ == "__main__":
    unittest.main()
