"""Molecules of files, as the program hardsphere reads them: all of its formats, radii and selections.

    molecule = hardsphere.read("4hhb.pdb", no_water=True)
    molecule.balls(probe=1.4).area
"""
from __future__ import annotations

from copy import copy
from typing import Any

from . import program
from ._calls import numpy
from .arrays import Doubles

LABELS = ("atom", "element", "chain", "residue", "number", "insertion")


class Molecule:
    """centers [n][3] and radii [n], and a list for each of atom, element, chain, residue, number and insertion: "" or None
    where the file has none. `input` is what the program says of the file: its unit, radii, and all that was left out."""
    centers: Doubles
    radii: Doubles
    atom: list[str]
    element: list[str]
    chain: list[str]
    residue: list[str]
    number: list[int | None]
    insertion: list[str]

    def __init__(self, balls: list[dict[str, Any]], given: dict[str, Any]):
        centers: Any = [ball["xyz"] for ball in balls]
        radii: Any = [ball["radius"] for ball in balls]
        if numpy is not None:
            centers, radii = numpy.array(centers, dtype=float).reshape(-1, 3), numpy.array(radii, dtype=float)
        self.centers, self.radii = centers, radii
        for label in LABELS:
            nothing = None if label == "number" else ""
            setattr(self, label, [ball.get(label, nothing) for ball in balls])
        self.input = given

    def __len__(self) -> int:
        return len(self.radii)

    def __repr__(self) -> str:
        return f"Molecule({len(self)} atoms of {self.input.get('file')})"

    def balls(self, probe: float = 0.0, threads: int = 1, **options: float) -> Any:
        """These atoms as hardsphere.Balls."""
        from . import Balls
        return Balls(self.centers, self.radii, probe, threads, **options)

    def table(self) -> dict[str, Any]:
        """A column for each label, x, y, z and radius: pandas.DataFrame takes it. Columns are copies: a change of one is
        none of the molecule."""
        columns: dict[str, Any] = {label: copy(getattr(self, label)) for label in LABELS}
        for axis, name in enumerate("xyz"):
            columns[name] = copy(self.centers[:, axis]) if numpy is not None else [row[axis] for row in self.centers]
        return {**columns, "radius": copy(self.radii)}


def read(file: str, *, radii: str | None = None, format: str | None = None, only: str | None = None,
         hide: str | None = None, **options: Any) -> Molecule:
    """The atoms of a file: .pdb, .cif, .gro, .sdf, .mol2, .pqr, .xyz and others. radii: "bondi", "chem3d", "uff", "protor",
    "naccess" or a file. only, hide: selections such as "chain:A" and "water". options: others of `hardsphere measure` by
    name, such as no_water=True and model=2. ValueError says why a file is refused."""
    found = program.said("measure", file, "--per-ball", radii=radii, format=format, only=only, hide=hide, **options)
    return Molecule(found["balls"], found.get("input", {}))
