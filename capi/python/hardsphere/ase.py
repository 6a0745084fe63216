"""Solvation by area and volume, for ASE: energy, forces and stress of tension * sum_i sigma_i A_i + pressure * V, in eV
and angstrom.

    atoms.calc = SumCalculator([EMT(), Solvation(tension=0.0072 * kcal / mol, probe=1.4)])
"""
from __future__ import annotations

from typing import Any

import numpy
from ase.calculators.calculator import Calculator, all_changes

import hardsphere
from hardsphere._calls import copied


class Solvation(Calculator):
    """radii: one for each atom, by element if not given. sigma: weights of the atoms' areas, 1 if not given.
    Both are copied: arrays may change then. Energies of atoms are those of their areas and of their terms of the volume,
    in a box of the volumes of their shares: they sum to the energy."""
    implemented_properties = ["energy", "free_energy", "forces", "energies", "stress"]

    def __init__(self, tension: float, pressure: float = 0.0, probe: float = 1.4, radii: Any = None, sigma: Any = None,
                 **keywords: Any):
        super().__init__(**keywords)
        self.tension, self.pressure, self.probe = tension, pressure, probe
        self.given, self.sigma = copied(radii), copied(sigma)
        self.balls: Any = None

    def calculate(self, atoms: Any = None, properties: Any = ("energy",), system_changes: Any = all_changes) -> None:
        super().calculate(atoms, properties, system_changes)
        atoms = self.atoms
        if atoms.pbc.any() and not atoms.pbc.all():
            raise ValueError("periodic in all directions or in none")
        periodic = bool(atoms.pbc.all())
        more = {"vectors": atoms.cell.array} if periodic else {}
        if self.balls is None or "numbers" in system_changes or "pbc" in system_changes:
            radii = self.given
            if radii is None:
                radii = [hardsphere.radius_of(int(number)) for number in atoms.numbers]
            kind = hardsphere.Box if periodic else hardsphere.Balls
            self.balls = None  # if these are refused, the next step is not one of the balls of before
            alone = {"areas_alone": self.pressure == 0} if periodic else {}
            self.balls = kind(atoms.positions, radii, probe=self.probe, **more, **alone)
        else:
            self.balls.set(atoms.positions, **more)
        found = self.balls.gradient(self.tension, self.pressure, self.sigma)
        weights = 1.0 if self.sigma is None else numpy.asarray(self.sigma)
        energies = self.tension * weights * self.balls.areas
        if self.pressure != 0:
            measured = self.balls.measure()
            energies += self.pressure * (measured.share_volumes if periodic else measured.volume_terms)
        self.results = {"energy": found.value, "free_energy": found.value, "forces": found.forces, "energies": energies}
        if periodic:
            strain = found.d_strain / atoms.get_volume()
            self.results["stress"] = ((strain + strain.T) / 2).flat[[0, 4, 8, 5, 2, 1]]
