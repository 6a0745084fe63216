"""A surface energy, tension * sum of solvent-accessible areas, in LAMMPS as it is installed: nothing is compiled. In an
input file, with a radius for each type of atom:

    fix sasa all external pf/callback 1 1
    fix_modify sasa energy yes virial yes
    python surface input 1 SELF format p here "from hardsphere.lammps_fix import Surface; surface = Surface('sasa', 0.0072, [2.0, 1.7])"
    python surface invoke

`f_sasa` is the energy; it and the virial count in thermo output and barostats. Ghosts have to reach
2 * (largest radius + probe) and the skin of neighbour lists, by `comm_modify cutoff` where the pair style's are shorter;
a run whose ghosts are too short ends before it begins. Energies and lengths are in the units of the simulation. It
takes LAMMPS's package PYTHON, NumPy, and for several ranks Open MPI; each rank computes its own atoms, and forces have the
same bits for every number of ranks.

The area's forces jump where spheres begin to touch, and a minimiser may stop there. With `window=0.05` its place takes the
mean over all radii within 0.05 of their own, which is smooth: for a molecule in open space, `boundary f f f`, on one rank.
"""
from __future__ import annotations

import ctypes as C
import os
import traceback
from typing import Any, Sequence

import numpy

import hardsphere

_program = C.CDLL(None)  # LAMMPS, in which this runs
_program.lammps_extract_atom.restype = C.c_void_p
C.pythonapi.PyCapsule_GetPointer.restype = C.c_void_p
C.pythonapi.PyCapsule_GetPointer.argtypes = [C.py_object, C.c_char_p]
_CALLBACK = C.CFUNCTYPE(None, C.c_void_p, C.c_int64, C.c_int, C.c_void_p, C.c_void_p, C.c_void_p)


def _rows(pointer: int, rows: int) -> Any:
    """LAMMPS's own memory behind a double **."""
    first = C.cast(pointer, C.POINTER(C.POINTER(C.c_double)))[0]
    return numpy.ctypeslib.as_array(first, (rows, 3))


def _sum_of_ranks(lammps: Any, values: Any) -> Any:
    """Over the ranks of this simulation, by LAMMPS's MPI."""
    if _program.lammps_extract_setting(lammps, b"world_size") == 1:
        return values
    found = numpy.zeros_like(values)
    _program.MPI_Comm_f2c.restype = C.c_void_p
    double, add = (C.byref(C.c_char.in_dll(_program, name)) for name in ("ompi_mpi_double", "ompi_mpi_op_sum"))
    _program.MPI_Allreduce(values.ctypes.data_as(C.c_void_p), found.ctypes.data_as(C.c_void_p), len(values), double, add,
                           C.c_void_p(_program.MPI_Comm_f2c(_program.lammps_get_mpi_comm(lammps))))
    return found


class Surface:
    """fix: the name of the fix external. radii: by type, the first one that of type 1. virial=False saves the time that it
    takes. threads: of each rank. window: length, 0 for the area itself."""

    def __init__(self, fix: str, tension: float, radii: Sequence[float], probe: float = 1.4, virial: bool = True,
                 threads: int = 1, window: float = 0.0):
        self.fix, self.tension, self.virial, self.threads = fix.encode(), tension, virial, threads
        self.window = window
        self.radii = numpy.array([0.0, *radii])
        self.options = {"probe": probe, "largest_radius": self.radii.max() + window}  # the same lattice on all ranks
        self.model, self.boundary, self.lammps = hardsphere.Model(), hardsphere.Boundary(), C.c_void_p()
        self.callback = _CALLBACK(self._step)

    def __call__(self, capsule: Any) -> None:
        """What `python surface invoke` does: from now on the fix calls."""
        self.lammps = C.c_void_p(C.pythonapi.PyCapsule_GetPointer(capsule, None))
        _program.lammps_set_fix_external_callback(self.lammps, self.fix, self.callback, None)
        # Only LAMMPS knows its cutoff of ghosts: each run sets up computes first, and this one, which nothing evaluates,
        # ends the run if its own cutoff and the skin exceed that of ghosts.
        ghosts, reach = self.fix + b"_ghosts", 2 * (self.options["largest_radius"] + self.options["probe"])
        if _program.lammps_has_id(self.lammps, b"compute", ghosts):
            self._command(b"uncompute %b" % ghosts)
        self._command(b"compute %b all rdf 1 cutoff %.17g" % (ghosts, reach))
        self._command(b'print "fix %b: comm_modify cutoff has to be at least %.10g and the skin, unless the pair cutoff is"'
                      % (self.fix, reach))

    def _command(self, line: bytes) -> None:
        _program.lammps_command(self.lammps, line)

    def _step(self, _: Any, step: int, own: int, tags: Any, x: int, forces: int) -> None:
        try:
            self._compute(own, x, forces)
        except Exception:
            traceback.print_exc()
            os._exit(1)  # a callback of C has no other way to end a run

    def _compute(self, own: int, x: int, forces: int) -> None:
        sums = numpy.zeros(7)  # energy, and virial as LAMMPS has it: xx yy zz xy xz yz
        if own > 0:  # else there is no memory of positions
            every = _program.lammps_extract_setting(self.lammps, b"nall")
            at, types = _rows(x, every), C.cast(_program.lammps_extract_atom(self.lammps, b"type"), C.POINTER(C.c_int))
            find = self._mean if self.window > 0 else self._area
            sums[0], slope, strain = find(own, at, self.radii[numpy.ctypeslib.as_array(types, (every,))])
            _rows(forces, own)[:] = -slope
            sums[1:] = -strain[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
        sums = _sum_of_ranks(self.lammps, sums)
        _program.lammps_fix_external_set_energy_global(self.lammps, self.fix, C.c_double(sums[0]))
        _program.lammps_fix_external_set_virial_global(self.lammps, self.fix, sums[1:].ctypes.data_as(C.c_void_p))

    def _area(self, own: int, at: Any, radii: Any) -> Any:
        """The energy of this rank's atoms, its derivatives by their centers, and by strain."""
        every, strain = len(at), numpy.zeros((3, 3))
        self.model.set(at, radii, **self.options)
        self.boundary.compute_with(self.model, selected=numpy.arange(every) < own, threads=self.threads)
        found = self.boundary.get_gradient(tension=self.tension, only=["energy", "d_centre"], threads=self.threads)
        if self.virial:
            rows = self.boundary.get_area_rows(only=[], threads=self.threads)
            away = at[rows.ball] - at[numpy.repeat(numpy.arange(every), numpy.diff(rows.first))]
            strain = self.tension * rows.d_centre.T @ away
        return found.energy.value, found.d_centre[:own], strain

    def _mean(self, own: int, at: Any, radii: Any) -> Any:
        """The same of the mean over the window, (V(R + window) - V(R - window)) / (2 window)."""
        if len(at) > own:
            raise ValueError("a window is for atoms in open space, on one rank")
        value, slope = 0.0, numpy.zeros((own, 3))
        for side in self.window, -self.window:
            self.model.set(at, numpy.maximum(0, radii + side), **self.options)
            self.boundary.compute_with(self.model, threads=self.threads)
            found = self.boundary.get_gradient(pressure=self.tension / (2 * side), only=["energy", "d_centre"],
                                               threads=self.threads)
            value, slope = value + found.energy.value, slope + found.d_centre
        return value, slope, slope.T @ at
