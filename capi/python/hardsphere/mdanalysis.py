"""Areas and pockets of a selection over a trajectory, for MDAnalysis.

    from hardsphere.mdanalysis import SASA
    run = SASA(universe.select_atoms("protein"), environment=universe.select_atoms("protein or resname LIG")).run(step=10)
    run.results.area                # [frames]
    run.results.areas               # [frames][atoms of the selection]
    run.results.residue_areas       # [frames][residues of the selection]

    run = Pockets(universe.select_atoms("protein"), narrow=1.4, wide=3.0, least=20).run()
    run.results.volume              # [frames]: of all pockets of at least 20 cubic angstrom
    run.results.pockets             # a list for each frame, the largest first: hardsphere.Pocket
"""
from __future__ import annotations

from typing import Any

import numpy
from MDAnalysis.analysis.base import AnalysisBase
from MDAnalysis.core.groups import UpdatingAtomGroup
from MDAnalysis.topology.guessers import guess_atom_element

import hardsphere
from hardsphere._calls import copied


def radii_of(atoms: Any) -> Any:
    """The topology's radii, else van der Waals radii by element."""
    if hasattr(atoms, "radii"):
        return numpy.asarray(atoms.radii, dtype=float)
    elements = atoms.elements if hasattr(atoms, "elements") else [guess_atom_element(name) for name in atoms.names]
    known = {element: hardsphere.radius_of(element.capitalize()) for element in set(elements)}
    return numpy.array([known[element] for element in elements])


def _lasting(atoms: Any) -> Any:
    """Atoms that are the same in all frames, as radii and results have one place for each."""
    if isinstance(atoms, UpdatingAtomGroup):
        raise ValueError("a selection that updates has other atoms in other frames")
    return atoms


class SASA(AnalysisBase):
    """Areas of some atoms, each of them once, while all of the environment blocks. radii: one for each atom of the
    environment, in angstrom; they are copied: an array may change then. box=True: in the frame's periodic box.
    cavities=True: results.cavities too, a list for each frame."""

    def __init__(self, atoms: Any, environment: Any = None, radii: Any = None, probe: float = 1.4, box: bool = False,
                 cavities: bool = False, **keywords: Any):
        super().__init__(atoms.universe.trajectory, **keywords)
        if box and cavities:
            raise ValueError("cavities are those of balls in free space")
        self.atoms, self.environment = _lasting(atoms), _lasting(atoms if environment is None else environment)
        self.radii = radii_of(self.environment) if radii is None else copied(radii)
        self.probe, self.box, self.want_cavities = probe, box, cavities
        rank: dict[int, int] = {}
        for k, index in enumerate(self.environment.indices):
            rank.setdefault(index, k)  # of one that is there twice the first one has the area
        if any(index not in rank for index in self.atoms.indices):
            raise ValueError("the environment has to hold all atoms of the selection")
        if len(set(self.atoms.indices)) < len(self.atoms):
            raise ValueError("an atom is in the selection twice: its .unique has each once")
        self.own = numpy.array([rank[index] for index in self.atoms.indices], dtype=int)
        self.balls: Any = None

    def _prepare(self) -> None:
        self.results.area, self.results.areas = numpy.zeros(self.n_frames), numpy.zeros((self.n_frames, len(self.atoms)))
        self.results.cavities = []

    def _single_frame(self) -> None:
        if self.box and self._ts.dimensions is None:  # which would be the box of the frame before
            raise ValueError(f"frame {self._ts.frame} has no box")
        more = {"vectors": self._ts.triclinic_dimensions} if self.box else {}
        if self.balls is None:
            kind, alone = (hardsphere.Box, {"areas_alone": True}) if self.box else (hardsphere.Balls, {})
            self.balls = kind(self.environment.positions, self.radii, probe=self.probe, **more, **alone)
        else:
            self.balls.set(self.environment.positions, **more)
        self.results.areas[self._frame_index] = self.balls.areas[self.own]
        self.results.area[self._frame_index] = self.results.areas[self._frame_index].sum()
        if self.want_cavities:
            self.results.cavities.append(self.balls.cavities())

    def _conclude(self) -> None:
        groups, number = numpy.unique(self.atoms.resindices, return_inverse=True)
        self.results.residue_areas = numpy.zeros((len(self.results.areas), len(groups)))
        for frame, row in enumerate(self.results.areas):
            self.results.residue_areas[frame] = numpy.bincount(number, weights=row, minlength=len(groups))


class Pockets(AnalysisBase):
    """Where a narrow probe fits between atoms and a wide one does not get to from the outside, in each frame: those of a
    volume of `least` or more. radii: one for each atom, in angstrom; they are copied: an array may
    change then. Pockets have indices of balls, which count the atoms."""

    def __init__(self, atoms: Any, radii: Any = None, narrow: float = 1.4, wide: float = 3.0, least: float = 0.0,
                 **keywords: Any):
        super().__init__(atoms.universe.trajectory, **keywords)
        self.atoms, self.narrow, self.wide, self.least = _lasting(atoms), narrow, wide, least
        self.radii = radii_of(atoms) if radii is None else copied(radii)
        self.balls: Any = None

    def _prepare(self) -> None:
        self.results.volume, self.results.pockets = numpy.zeros(self.n_frames), []

    def _single_frame(self) -> None:
        if self.balls is None:
            self.balls = hardsphere.Balls(self.atoms.positions, self.radii)
        else:
            self.balls.set(self.atoms.positions)
        found = [pocket for pocket in self.balls.pockets(self.narrow, self.wide) if (pocket.volume or 0.0) >= self.least]
        self.results.volume[self._frame_index] = sum(pocket.volume or 0.0 for pocket in found)
        self.results.pockets.append(found)
