"""Exact areas, volumes, gradients, contacts, cavities, surfaces, pores and pictures of unions of balls.

    import hardsphere
    hardsphere.measure(centers, radii, probe=1.4).area       # the shortest way; centers [n][3], radii [n]

    balls = hardsphere.Balls(centers, radii, probe=1.4)      # more than one question, or frame after frame
    balls.area, balls.areas                                  # of the union, and what each ball has of it
    energy = balls.gradient(tension=0.0072)                  # .value, .d_centre, .d_radius
    balls.contacts(), balls.cavities(), balls.surface(), balls.mesh(0.5), balls.pores(), balls.svg()
    balls.set(next_centers)                                  # the next frame; memory is kept
    hardsphere.Box(centers, radii, vectors, probe=1.4)       # in a periodic box, with .gradient, .contacts, .pores

    molecule = hardsphere.read("x.pdb")                      # the atoms of a file, with radii and labels
    hardsphere.voids(molecule.centers, molecule.radii)       # and pockets, contacts, surface_mesh: one question each
    pandas.DataFrame(hardsphere.table(balls.contacts()))     # records as columns

Lengths are in any unit, areas in its square. Only what is asked for is computed. Arrays are numpy's where numpy is there,
and lists where it is not. Behind these classes are the handles of the C interface with all of its functions as methods:
`balls.boundary.get_vertices()`; `hardsphere.Topology` and the others serve on their own, too. A failed call raises
`hardsphere.Error` with `.status` and `.ball`. Threads run during calls; give each its own `Balls`.

The shared library is `$HARDSPHERE_LIBRARY`, else one beside this file or installed with it, else what the loader finds.
"""
from __future__ import annotations

import contextlib
import math
import os
from typing import Any, Iterator, NamedTuple, Sequence

from . import _interface, constants
from ._calls import Error, Handle, Misshapen, Record, Result, called, copied, library, numpy, shape_of
from ._interface import *  # noqa: F401,F403
from ._interface import (Boundary, Contacts, Mesh, Model, Periodic, Pores, Sticks, Surface, Topology, View)
from .arrays import Doubles, Integers, Numbers, Records, Rows, Truths, Values
from .molecule import Molecule, read
from .tables import table

__version__ = _interface.VERSION_STRING


class Measure(NamedTuple):
    """Of the union, and of each ball: its free area, and its term of the volume, which may be negative."""
    area: float
    volume: float
    areas: Doubles
    volume_terms: Doubles


class BoxMeasure(NamedTuple):
    """Of the union in a box, and of each ball: its free area, and the volume of its share."""
    area: float
    volume: float | None
    areas: Doubles
    share_volumes: Doubles | None


class Gradient(NamedTuple):
    """An energy of areas and the volume, and its derivatives: by centres [n][3], by radii [n], by the probe. flags [n]
    say where the derivative is one-sided. In a box by the strain and by its vectors too."""
    value: float
    d_centre: Doubles
    d_radius: Doubles
    flags: Numbers
    d_probe: float
    area: float
    volume: float
    d_strain: Doubles | None = None
    d_box: Doubles | None = None

    @property
    def forces(self) -> Doubles:
        """-d_centre."""
        return -self.d_centre if numpy is not None else [tuple(-x for x in row) for row in self.d_centre]


class Cavity(NamedTuple):
    """A hollow in which the probe fits and that it cannot leave: its volume, its area, the indices of its balls."""
    volume: float
    area: float
    balls: Numbers


class Pocket(NamedTuple):
    """Where a narrow probe fits and a wide one does not get to from the outside: volume and area of where the centre of
    the narrow one gets, None where its mouths cannot be closed; the widest probe that fits in it and its centre; the
    widest mouth, 0 without any, and how many there are; the indices of the balls around."""
    volume: float | None
    area: float | None
    radius: float
    center: Doubles
    mouth: float
    mouths: int
    balls: Numbers


class Triangles(NamedTuple):
    """A mesh: vertices [v][3], triangles [t][3] of their indices, outward normals [v][3], and the ball of each vertex."""
    vertices: Doubles
    triangles: Numbers
    normals: Doubles
    balls: Numbers

    def write(self, path: str) -> None:
        """As a text file .ply, with normals and the ball of each vertex, or .obj, with normals."""
        kind = os.path.splitext(os.fspath(path))[1].lower()
        if kind not in (".ply", ".obj"):
            raise ValueError(f"{path}: is no .ply or .obj file")
        vertices, normals = (_rows_of(rows) for rows in (self.vertices, self.normals))
        with open(path, "w", encoding="ascii", newline="\n") as file:
            if kind == ".obj":
                file.writelines(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in vertices)
                file.writelines(f"vn {x:.6g} {y:.6g} {z:.6g}\n" for x, y, z in normals)
                file.writelines("f " + " ".join(f"{k + 1}//{k + 1}" for k in corners) + "\n"
                                for corners in _rows_of(self.triangles))
                return
            names = [f"property double {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
            file.write("\n".join(["ply", "format ascii 1.0", f"element vertex {len(vertices)}", *names,
                                  "property uint ball", f"element face {len(self.triangles)}",
                                  "property list uchar uint vertex_indices", "end_header", ""]))
            for (x, y, z), (a, b, c), ball in zip(vertices, normals, _rows_of(self.balls)):
                file.write(f"{x:.9g} {y:.9g} {z:.9g} {a:.6g} {b:.6g} {c:.6g} {ball}\n")
            file.writelines("3 {} {} {}\n".format(*corners) for corners in _rows_of(self.triangles))


class Space(NamedTuple):
    """Where larger probes fit: records of the widest places and of the gates between them, largest first as the library
    has them; `handle` answers more: `.widest(a, b)`, `.find_pockets(..)`, `.find_tunnel(..)`."""
    maxima: Records
    gates: Records
    handle: Pores


class Svg(str):
    """A picture as text, which notebooks show."""

    def _repr_svg_(self) -> str:
        return str(self)


def _plain(values: Any) -> Any:
    """As plain numbers, whose text has all digits: that of numpy's arrays has as many as a program likes to print."""
    return values.tolist() if hasattr(values, "tolist") else values


def _rows_of(values: Any) -> list[Any]:
    return list(_plain(values))


def _energy(found: Any, **more: Any) -> Gradient:
    e = found.energy
    return Gradient(e.value, found.d_centre, found.d_radius, found.flags, e.d_probe, e.area, e.volume, **more)


class _Set:
    """What balls in free space and in a box have in common."""
    n: int

    def __init__(self, probe: float, threads: int, options: dict[str, float]):
        self._options, self._threads = {"probe": probe, **options}, threads
        self._radii: Any = None
        self._computed: dict[Any, Any] = {}
        self._handles: dict[Any, Any] = {}

    def __repr__(self) -> str:
        return f"{type(self).__name__}({getattr(self, 'n', 0)} balls, probe {self._options['probe']:g})"

    def _once(self, name: str, compute: Any) -> Any:
        if name not in self._computed:
            self._computed[name] = compute()
        return self._computed[name]

    def _handle(self, kind: type, *given: Any, key: Any = None, own: Any = None, compute: str = "compute",
                **named: Any) -> Any:
        """A handle of a kind, computed from others once for each set of balls and key; a handle of its own for each
        `own`, where callers keep them."""
        place = kind, own
        handle = self._handles.setdefault(place, kind())
        ready = (compute, key)
        if self._computed.get(place) != ready:
            self._computed.pop(place, None)
            getattr(handle, compute)(*given, **named)
            self._computed[place] = ready
        return handle

    def _drop(self) -> None:
        raise NotImplementedError

    def _radii_from(self, radii: Values | None) -> Any:
        """Those of this frame, and of the next ones if these come without: a copy, for what the caller does with an array
        later is not about them."""
        if radii is not None:
            self._radii = copied(radii)
        return self._radii

    @contextlib.contextmanager
    def _taking(self) -> Iterator[None]:
        """Other balls. If they are refused there are none, not those of before: what asks for them raises Error."""
        self._computed.clear()
        self.n = 0
        try:
            yield
        except (TypeError, ValueError):  # before the library has seen them
            with contextlib.suppress(Error):
                self._drop()
            raise

    def measure(self, selected: Truths | None = None) -> Any:
        raise NotImplementedError

    @property
    def area(self) -> float:
        """Of the union's surface."""
        return self._once("measure", self.measure).area

    @property
    def volume(self) -> float:
        """Of the union."""
        return self._once("measure", self.measure).volume

    @property
    def areas(self) -> Doubles:
        """What each ball has of the surface: with a probe, its solvent-accessible area."""
        areas = self._once("measure", self.measure).areas
        return areas.copy() if numpy is not None else list(areas)  # the caller's own, to be changed


class Balls(_Set):
    """Balls, and what is known of their union."""

    def __init__(self, centers: Rows, radii: Values, probe: float = 0.0, threads: int = 1, **options: float):
        """probe is added to all radii. threads share boundaries, measures and gradients, whose bits are the same for any
        number. options: step and largest_radius, as of hsp_model_options."""
        super().__init__(probe, threads, options)
        self.model = Model()
        self.set(centers, radii)

    def set(self, centers: Rows, radii: Values | None = None) -> Balls:
        """Other centres, as of the next frame; other radii if they are given. All are copied: arrays may change then."""
        with self._taking(), called(xyz="centers", radius="radii"):
            self.model.set(centers, self._radii_from(radii), **self._options)
        self.n = self.model.n
        return self

    def _drop(self) -> None:
        self.model.set([[math.nan] * 3], [0.0])

    @property
    def boundary(self) -> Boundary:
        """The boundary of the union: vertices, arcs, circles, faces, loops, shells."""
        return self._handle(Boundary, self.model, compute="compute_with", threads=self._threads)

    @property
    def topology(self) -> Topology:
        """Shells, components and the hollows of the union."""
        return self._handle(Topology, self.boundary)

    @property
    def counts(self) -> Any:
        """How many balls are exposed, vertices, arcs, faces, shells, components, voids there are."""
        return self.boundary.get_counts()

    def measure(self, selected: Truths | None = None) -> Measure:
        """Area and volume. selected: n truth values; other balls only block, and have 0."""
        found = self.boundary.get_measures(selected=selected, threads=self._threads)
        return Measure(found.totals.area, found.totals.volume, found.area, found.volume_term)

    def gradient(self, tension: float = 1.0, pressure: float = 0.0, sigma: Values | None = None,
                 tangency: int = 0) -> Gradient:
        """Of tension * sum_i sigma_i A_i + pressure * V. sigma: n weights, 1 if not given."""
        return _energy(self.boundary.get_gradient(tension=tension, pressure=pressure, sigma=sigma, tangency=tangency,
                                                  threads=self._threads))

    def contacts(self, groups: Integers | None = None) -> Records:
        """Records of the balls whose shares touch: area, rim, distance, ball. groups: a number for each ball, as of
        residues or chains; then records of groups: area, rim, group, contacts."""
        handle = self._handle(Contacts, self.boundary)
        with called(group="groups"):
            return handle.get_pairs() if groups is None else handle.group(groups)

    def cavities(self) -> list[Cavity]:
        """The hollows, largest first. The probe fits into each."""
        if self.counts.voids == 0:
            return []
        topology = self.topology
        found = [Cavity(float(region["volume"]), float(region["area"]), topology.get_region_balls(k))
                 if numpy is not None else Cavity(region.volume, region.area, topology.get_region_balls(k))
                 for k, region in enumerate(topology.get_regions()) if k > 0]
        return sorted(found, key=lambda cavity: -cavity.volume)

    def surface(self) -> Result:
        """The smooth surface that the probe rolls over, the solvent-excluded one: .totals, and .balls, a record each."""
        return self._handle(Surface, self.boundary).measure()

    def mesh(self, edge: float, smooth: bool = False) -> Triangles:
        """Triangles with edges of about that length: of the union's surface, or of the smooth one."""
        source = self._handle(Surface, self.boundary) if smooth else self.boundary
        with called(edge_length="edge"):
            mesh = self._handle(Mesh, source, edge, key=edge, compute="compute_surface" if smooth else "compute")
        points = mesh.get_vertices()
        return Triangles(points.xyz, mesh.get_triangles(only="corners"), points.normals, points.balls)

    def pores(self, floor: float | None = None) -> Space:
        """Free space for probes of any radius from the floor on: 0, or what is given."""
        return _space(self._handle(Pores, self.model, own=floor, floor=floor))

    def pockets(self, narrow: float = 1.4, wide: float = 3.0) -> list[Pocket]:
        """Where a probe of the radius `narrow` fits and one of the radius `wide` does not get to from the outside, that
        of the largest volume first. Radii of probes are beyond that of these balls."""
        pores = self.pores().handle
        count = pores.find_pockets(narrow, wide)
        found = pores.get_pockets(0, count)
        maxima = pores.get_maxima(0, pores.get_counts().maxima)
        sizes = self._sizes_of_pockets(pores) if count > 0 else []
        pockets = []
        for k in range(count):
            closed = _field(sizes[k], "closed") == 1
            center = _field(maxima[int(_field(found[k], "maximum"))], "xyz")
            pockets.append(Pocket(float(_field(sizes[k], "volume")) if closed else None,
                                  float(_field(sizes[k], "area")) if closed else None, float(_field(found[k], "radius")),
                                  center if numpy is not None else list(center),
                                  float(_field(found[k], "mouth")) if _field(found[k], "mouths") > 0 else 0.0,
                                  int(_field(found[k], "mouths")), pores.get_pocket_balls(k)))
        return sorted(pockets, key=lambda pocket: -1.0 if pocket.volume is None else pocket.volume, reverse=True)

    def _sizes_of_pockets(self, pores: Pores) -> Any:
        """With plugs in the mouths, and with more of them while there are leaks; on a coarser lattice where a plug is too
        large for that of the balls."""
        step = self.model.get_info().step
        with_plugs, before, sizes = pores.get_plugged_balls(), 0, None
        while len(with_plugs.radius) > before:
            while max(with_plugs.radius) >= (2 ** 30 - 1) * step:
                step *= 10.0
            plugged = Balls(with_plugs.xyz, with_plugs.radius, step=step)
            space = plugged.pores().handle
            sizes = pores.measure_pockets(space, plugged.boundary)
            before, with_plugs = len(with_plugs.radius), space.get_plugged_balls()
        return sizes

    def pairs(self, once: bool = True) -> list[tuple[int, int]]:
        """The balls that meet; each pair once, or from both sides."""
        found = self.model.query_pairs(_interface.PAIRS_ONCE if once else 0)
        return [(i, int(j)) for i in range(len(found.first) - 1) for j in found.ids[found.first[i]:found.first[i + 1]]]

    def svg(self, colors: Integers | None = None, *, bonds: Sequence[Sequence[Any]] | None = None, stick: float = 0.2,
            towards: Values | None = None, up: Values | None = None, style: str = "soft", title: str | None = None,
            **options: Any) -> Svg:
        """A picture. colors: n times 0xRRGGBB. bonds: pairs of balls, drawn as sticks of that radius between small
        balls; (i, j, kind) as strands half as thick again in all, where kind is 2, 3 or "aromatic"; 1 is one stick.
        towards: from the molecule to the viewer. style: flat, headlight or soft. options: as of hsp_picture_options,
        such as width, fog and outline."""
        if style not in ("flat", "headlight", "soft"):
            raise ValueError(f"style: {style!r}, expected flat, headlight or soft")
        options["style"] = getattr(_interface, f"STYLE_{style.upper()}")
        look = {"towards": towards, "up": up}
        key = repr((_plain(towards), _plain(up)))
        if bonds is None:
            view = self._handle(View, self.model, self.boundary, key=key, **look)
            with called(colour="colors"):
                text = view.picture_write(colors, title, **options)
        else:
            pairs = list(map(tuple, bonds))  # once: what comes from zip is gone then
            sticks = self._handle(Sticks, self.model, [_stick_of(*bond) for bond in pairs], stick,
                                  key=repr((key, pairs, stick)), **look)
            with called(colour="colors"):
                text = sticks.picture_write_sticks(colors, title, **options)
        return Svg(text.decode())


_STRANDS = {1: 0, 2: _interface.STICK_DOUBLE, 3: _interface.STICK_TRIPLE, "aromatic": _interface.STICK_AROMATIC}


def _stick_of(first: int, second: int, kind: Any = 1) -> Any:
    if kind not in _STRANDS:
        raise ValueError(f"a bond of kind {kind!r}: it is 1, 2, 3 or 'aromatic'")
    return _interface.Stick(ball=(first, second), flags=_STRANDS[kind])


class Box(_Set):
    """Balls in a periodic box. vectors: three lengths, or [3][3], any three. All that has a direction is in their frame.
    areas_alone: areas and their gradient are all that is asked for, in a third of the time; volumes are None."""

    def __init__(self, centers: Rows, radii: Values, vectors: Rows | Values, probe: float = 0.0, threads: int = 1,
                 areas_alone: bool = False, **options: float):
        super().__init__(probe, threads, {**options, "areas_alone": int(areas_alone)})
        self.handle = Periodic()
        self.set(centers, radii, vectors)

    def set(self, centers: Rows, radii: Values | None = None, vectors: Rows | Values | None = None) -> Box:
        """Other centres, as of the next frame; radii and vectors if they are given. All are copied, as by Balls."""
        with self._taking(), called(xyz="centers", radius="radii", box="vectors"):
            radii = self._radii_from(radii)
            if vectors is not None:
                shape = shape_of(vectors)
                if shape not in ((3,), (3, 3)):
                    raise Misshapen("vectors", f"shape {shape}, expected (3,) or (3, 3)")
                rows: Any = vectors
                if len(shape) == 1:
                    rows = [[x if i == j else 0.0 for j in range(3)] for i, x in enumerate(vectors)]
                self._box = [float(x) for row in rows for x in row]
            self.handle.compute_with(centers, radii, self._box, threads=self._threads, **self._options)
        self.n = self.handle.n
        return self

    def _drop(self) -> None:
        self.handle.compute_with([[math.nan] * 3], [0.0], [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0])

    @property
    def totals(self) -> Any:
        """Area, volume, the box's volume, what is free of it, and the area of contacts."""
        return self.handle.measure(only="totals")

    def measure(self, selected: Truths | None = None) -> BoxMeasure:
        """Area and volume, and those of each ball's share."""
        if selected is not None:
            raise ValueError("in a box all balls are measured")
        if self._options["areas_alone"]:
            found = self.handle.measure(only=["totals", "area"])
            return BoxMeasure(found.totals.area, None, found.area, None)
        found = self.handle.measure()
        return BoxMeasure(found.totals.area, found.totals.volume, found.area, found.share_volume)

    def gradient(self, tension: float = 1.0, pressure: float = 0.0, sigma: Values | None = None,
                 tangency: int = 0) -> Gradient:
        """As that of Balls, and by the strain and the vectors of the box. d_strain over the volume is the stress."""
        found = self.handle.get_gradient(tension=tension, pressure=pressure, tangency=tangency, sigma=sigma,
                                         threads=self._threads)
        return _energy(found, d_strain=_matrix(found.d_strain), d_box=_matrix(found.d_box))

    def contacts(self, groups: Integers | None = None) -> Records:
        """As those of Balls; a record says by which vectors the second ball is moved."""
        with called(group="groups"):
            return self.handle.get_contacts() if groups is None else self.handle.group_contacts(groups)

    def pores(self, floor: float | None = None) -> Space:
        """As those of Balls; `handle` answers `.get_channels(radius)`, too."""
        return _space(self._handle(Pores, self.handle, own=floor, compute="compute_periodic", floor=floor))


def _space(handle: Pores) -> Space:
    counts = handle.get_counts()
    return Space(handle.get_maxima(0, counts.maxima), handle.get_gates(0, counts.gates), handle)


def _field(record: Any, name: str) -> Any:
    """Of a row of numpy's array of records, or of a record."""
    return record[name] if numpy is not None else getattr(record, name)


def _matrix(nine: Any) -> Any:
    return nine.reshape(3, 3) if numpy is not None else [tuple(nine[k:k + 3]) for k in (0, 3, 6)]


def measure(centers: Rows, radii: Values, probe: float = 0.0, selected: Truths | None = None, threads: int = 1,
            **options: float) -> Measure:
    """Area and volume of a union of balls. probe is added to all radii; selected balls are measured, others block."""
    return Balls(centers, radii, probe, threads, **options).measure(selected)


def voids(centers: Rows, radii: Values, probe: float = 0.0, **options: float) -> list[Cavity]:
    """The hollows of a union of balls in which a probe fits, largest first."""
    return Balls(centers, radii, probe, **options).cavities()


def pockets(centers: Rows, radii: Values, probe: float = 1.4, wide: float = 3.0, **options: float) -> list[Pocket]:
    """Where a probe fits and a wide one does not get to from the outside, that of the largest volume first."""
    return Balls(centers, radii, **options).pockets(probe, wide)


def contacts(centers: Rows, radii: Values, probe: float = 0.0, groups: Integers | None = None,
             **options: float) -> Records:
    """Records of the balls, or of the groups of balls, that touch, with the area of what they have in common."""
    return Balls(centers, radii, probe, **options).contacts(groups)


def surface_mesh(centers: Rows, radii: Values, edge: float, probe: float = 0.0, smooth: bool = False,
                 **options: float) -> Triangles:
    """Triangles with edges of about that length, of the surface of a union of balls or, with smooth=True, of the one that
    the probe leaves: .vertices, .triangles, .normals, .balls, .write("x.ply")."""
    return Balls(centers, radii, probe, **options).mesh(edge, smooth)


def radius_of(element: str | int) -> float:
    """The van der Waals radius of an element by symbol or atomic number, in angstrom, after Bondi and Mantina."""
    number = _interface.element_number(element) if isinstance(element, str) else element
    return _interface.element_radius(_interface.RADII_BONDI, number).radius


def colors_of(elements: Sequence[str | int], palette: int = 0) -> list[int]:
    """A colour for each element, 0xRRGGBB."""
    numbers = (_interface.element_number(e) if isinstance(e, str) else e for e in elements)
    return [_interface.palette_colour(palette, number, 0) for number in numbers]
