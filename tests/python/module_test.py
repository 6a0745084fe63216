"""The Python module against the program, closed forms and the record of the binary interface."""
import array
import contextlib
import inspect
import math
import os
import pickle
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from unittest import mock
from xml.etree import ElementTree

import program
from program import CRAMBIN, SOURCE, random_balls, said

import hardsphere
from hardsphere import _calls, _interface

CENTERS, RADII = program.read_of(CRAMBIN)
LENS = [[0, 0, 0], [1, 0, 0]]  # of radius 1: each loses a cap of height 1/2


def plain(values):
    return values.tolist() if hasattr(values, "tolist") else values


def field(record, name):
    """Of a struct, or of a row of numpy's array of them."""
    return record[name] if hasattr(record, "dtype") else getattr(record, name)


def rows_of(name):
    """The rows of a record of the binary interface, as words."""
    with open(f"{SOURCE}/capi/abi/{name}.txt") as file:
        return [row.split() for row in file if not row.startswith("#")]


class Declarations(unittest.TestCase):
    def test_layouts_are_those_of_the_record(self):
        sizes = {}
        for name, number, *_ in rows_of("structs"):
            sizes[name] = int(number.split("/")[0])
        self.assertGreater(len(_calls._records), 80)
        for struct, record in _calls._records.items():
            self.assertEqual(_calls.C.sizeof(record), sizes.pop(struct), struct)
            for name, *_ in record._fields_:
                self.assertEqual(getattr(record, name).offset, sizes.pop(f"{struct}.{name}"), f"{struct}.{name}")
        self.assertEqual(sizes, {})

    def test_constants_are_those_of_the_record(self):
        for name, value in rows_of("constants"):
            self.assertEqual(getattr(hardsphere, name.removeprefix("HSP_")), int(value), name)

    def test_the_library_has_every_function(self):
        for name in _interface.FUNCTIONS:
            _calls._described(name)

    def test_every_function_is_called_by_something(self):
        text = inspect.getsource(_interface)
        for name in _interface.FUNCTIONS:
            if not name.endswith(("_bytes", "_init", "_init_surface")):
                self.assertIn(f'return call("{name}"', text)

    def test_what_is_printed_of_balls(self):
        balls = hardsphere.Balls([[0, 0, 0], [1, 0, 0]], [1, 1], probe=1.4)
        self.assertEqual(repr(balls), "Balls(2 balls, probe 1.4)")
        self.assertEqual(repr(hardsphere.Box([[0, 0, 0]], [1], [4, 4, 4])), "Box(1 balls, probe 0)")


class Program(unittest.TestCase):
    """To the last bit: the program prints all digits of a number."""

    def test_areas(self):
        for probe in 0, 1.4:
            found = said("measure", CRAMBIN, "--per-ball", "--probe", str(probe))
            measured = hardsphere.measure(CENTERS, RADII, probe=probe)
            self.assertEqual((measured.area, measured.volume), (found["area"], found["volume"]))
            self.assertEqual(plain(measured.areas), [ball["area"] for ball in found["balls"]])
            alone = hardsphere.areas(CENTERS, RADII, probe)
            self.assertEqual(plain(alone.area), plain(measured.areas))

    def test_gradients(self):
        found = said("measure", CRAMBIN, "--gradient")["balls"]
        balls = hardsphere.Balls(CENTERS, RADII)
        area, volume = balls.gradient(), balls.gradient(0, 1)
        self.assertEqual(list(map(list, plain(area.d_centre))), [ball["area_gradient"] for ball in found])
        self.assertEqual(list(map(list, plain(volume.d_centre))), [ball["volume_gradient"] for ball in found])
        self.assertEqual(plain(area.d_radius), [ball["area_dr"] for ball in found])
        self.assertEqual([-x for x in plain(area.forces)[5]], list(plain(area.d_centre)[5]))

    def test_contacts(self):
        found = said("contacts", CRAMBIN)
        records = hardsphere.Balls(CENTERS, RADII).contacts()
        self.assertEqual([(list(field(r, "ball")), field(r, "area")) for r in records],
                         [(pair["balls"], pair["area"]) for pair in found["pairs"]])
        chains = hardsphere.Balls(CENTERS, RADII).contacts([k % 2 for k in range(len(RADII))])
        self.assertEqual(len(chains), 1)
        self.assertAlmostEqual(field(chains[0], "area"), sum(p["area"] for p in found["pairs"]
                                                             if sum(p["balls"]) % 2), 8)

    def test_cavities(self):
        found = said("voids", CRAMBIN, "--probe", "0.4", "--balls")["voids"]
        cavities = hardsphere.Balls(CENTERS, RADII, probe=0.4).cavities()
        self.assertGreater(len(found), 2)
        self.assertEqual([(c.volume, c.area, plain(c.balls)) for c in cavities],
                         [(v["volume"], v["area"], v["balls"]) for v in found])

    def test_smooth_surface(self):
        found = said("measure", CRAMBIN, "--probe", "1.4", "--surface", "ses")
        totals = hardsphere.Balls(CENTERS, RADII, probe=1.4).surface().totals
        self.assertEqual((totals.area, totals.volume), (found["area"], found["volume"]))

    def test_boxes(self):
        found = said("measure", CRAMBIN, "--per-ball", "--gradient", "--box", "45,0,0,3,20,0,4,5,25")
        box = hardsphere.Box(CENTERS, RADII, [[45, 0, 0], [3, 20, 0], [4, 5, 25]])
        self.assertEqual((box.area, box.volume, box.totals.free_volume),
                         (found["area"], found["volume"], found["free_volume"]))
        self.assertEqual(plain(box.areas), [ball["area"] for ball in found["balls"]])
        self.assertEqual([x for row in plain(box.gradient().d_strain) for x in row], found["strain_area"])
        pairs = said("contacts", CRAMBIN, "--box", "45,0,0,3,20,0,4,5,25")["pairs"]
        self.assertEqual([list(field(r, "shift")) for r in box.contacts()], [pair["shift"] for pair in pairs])


class Values(unittest.TestCase):
    def test_two_balls(self):
        measured = hardsphere.measure(LENS, [1, 1])
        self.assertAlmostEqual(measured.area, 6 * math.pi, 12)
        self.assertAlmostEqual(measured.areas[0], 3 * math.pi, 12)
        self.assertAlmostEqual(measured.volume, 2 * math.pi * 27 / 24, 12)
        self.assertAlmostEqual(hardsphere.Balls(LENS, [1, 1]).gradient().d_centre[1][0], 2 * math.pi, 6)

    def test_areas_are_the_callers_own(self):
        balls = hardsphere.Balls(LENS, [1, 1])
        balls.areas[0] = 0
        self.assertAlmostEqual(balls.areas[0], 3 * math.pi, 12)

    def test_arrays_of_the_caller_are_copied(self):
        """Radii are those of the next frame, too."""
        kinds = [list, lambda values: array.array("d", values)]
        if _calls.numpy is not None:
            kinds.append(lambda values: _calls.numpy.array(values, dtype=float))
        for made in kinds:
            for kind, more in (hardsphere.Balls, []), (hardsphere.Box, [made([9, 9, 9])]):
                centers, radii, others = [made(center) for center in LENS], made([1, 1]), made([1, 1])
                balls = kind(centers, radii, *more)
                for changed in radii, centers[1], *more:
                    changed[0] = 3
                self.assertAlmostEqual(balls.area, 6 * math.pi, 12)
                self.assertAlmostEqual(balls.set(LENS).area, 6 * math.pi, 12)
                balls.set(LENS, others)
                others[0] = 3
                self.assertAlmostEqual(balls.set(LENS).area, 6 * math.pi, 12)
                if more:
                    self.assertAlmostEqual(balls.totals.box_volume, 729, 9)

    def test_what_is_not_selected_blocks(self):
        measured = hardsphere.measure(LENS, [1, 1], selected=[True, False])
        self.assertAlmostEqual(measured.area, 3 * math.pi, 12)
        self.assertEqual(measured.areas[1], 0)

    def test_weights(self):
        balls = hardsphere.Balls(LENS, [1, 1])
        self.assertAlmostEqual(balls.gradient(sigma=[1, 0]).value, 3 * math.pi, 12)
        self.assertAlmostEqual(balls.gradient(2, 3).value, 2 * balls.area + 3 * balls.volume, 12)

    def test_the_next_frame_and_more_balls(self):
        balls = hardsphere.Balls(LENS, [1, 1])
        self.assertEqual((balls.area, balls.cavities()), (hardsphere.measure(LENS, [1, 1]).area, []))
        topology = balls.topology
        balls.set([[0, 0, 0], [5, 0, 0]])
        self.assertAlmostEqual(balls.area, 8 * math.pi, 12)
        with self.assertRaises(hardsphere.Error) as refused:  # results of another set
            topology.get_counts()
        self.assertEqual(refused.exception.status, hardsphere.E_STATE)
        centers, radii = random_balls(3000, 30)
        balls.set(centers, radii)
        fresh = hardsphere.Balls(centers, radii)
        self.assertEqual(plain(balls.areas), plain(fresh.areas))
        self.assertEqual(balls.topology.get_counts().shells, fresh.counts.shells)

    def test_nothing_answers_for_balls_of_before(self):
        """Nor where more balls need another model than the one that it looks at."""
        for number in 20, 2000:
            balls = hardsphere.Balls(*random_balls(20, 8))
            paths = hardsphere.Paths().compute(balls.model)
            readers = [lambda: paths.find([-9, 0, 0], [9, 0, 0]), balls.pores().handle.get_counts,
                       balls.topology.get_counts, hardsphere.Cells().compute(balls.model).get_counts,
                       hardsphere.View().compute(balls.model, towards=[0, 0, 1]).get_info]
            readers = [read for read in readers if read()]
            balls.set(*random_balls(number, 30))
            for read in readers:
                with self.assertRaises(hardsphere.Error) as refused:
                    read()
                self.assertEqual(refused.exception.status, hardsphere.E_STATE)

    def test_meshes(self):
        balls = hardsphere.Balls(CENTERS, RADII, probe=1.4)
        for smooth in False, True:
            mesh = balls.mesh(0.7, smooth)
            edges = {}
            for a, b, c in plain(mesh.triangles):
                for edge in (a, b), (b, c), (c, a):
                    edges[edge] = edges.get(edge, 0) + 1
            self.assertEqual(set(edges), {(b, a) for a, b in edges})
            self.assertEqual(len(mesh.vertices), len(mesh.normals))
            self.assertLess(max(max(t) for t in plain(mesh.triangles)), len(mesh.vertices))
        self.assertGreater(len(balls.mesh(0.4).triangles), len(balls.mesh(0.8).triangles))
        surface = hardsphere.Surface().compute(balls.boundary)
        shared = hardsphere.Mesh().compute_surface_with(surface, 0.7, threads=2)
        self.assertEqual(plain(shared.get_vertices().xyz), plain(balls.mesh(0.7, True).vertices))

    def test_pores(self):
        """A probe in the middle of a cube of eight balls, and the gates, its faces."""
        corners = [[x, y, z] for x in (0, 4) for y in (0, 4) for z in (0, 4)]
        space = hardsphere.Balls(corners, [1.0] * 8).pores()
        widest = max(field(m, "radius") for m in space.maxima)
        self.assertAlmostEqual(widest, math.sqrt(12) - 1, 7)
        self.assertAlmostEqual(space.handle.widest([2, 2, 2]).radius, math.sqrt(8) - 1, 7)
        higher = hardsphere.Balls(corners, [1.0] * 8).pores(floor=2.6)
        self.assertEqual(len(higher.maxima), 0)

    def test_pores_of_two_floors(self):
        """The first one stays as it is, in a box too."""
        for balls in hardsphere.Balls(CENTERS, RADII), hardsphere.Box(CENTERS, RADII, [40, 40, 40]):
            space = balls.pores()
            above = balls.pores(0.5)
            self.assertLess(len(above.maxima), len(space.maxima))
            self.assertEqual(space.handle.get_counts().maxima, len(space.maxima))
            self.assertEqual(above.handle.get_counts().maxima, len(above.maxima))
            self.assertIs(balls.pores(0.5).handle, above.handle)

    def test_sizes_of_pockets(self):
        """The same cube, whose faces are closed by plugs; it is what eight eighths of balls leave of a cube."""
        corners = [[x, y, z] for x in (0, 4) for y in (0, 4) for z in (0, 4)]
        pores = hardsphere.Balls(corners, [2.1] * 8).pores().handle
        self.assertEqual(pores.find_pockets(0.1, 0.8), 1)
        with_plugs = pores.get_plugged_balls()
        self.assertEqual(len(with_plugs.radius), 8 + 6)
        plugged = hardsphere.Balls(with_plugs.xyz, with_plugs.radius)
        size, = pores.measure_pockets(plugged.pores().handle, plugged.boundary)
        self.assertEqual((field(size, "closed"), field(size, "regions")), (1, 1))
        lens = math.pi * (4 * 2.2 + 4) * (2 * 2.2 - 4) ** 2 / 12
        lids = 64 - 4 / 3 * math.pi * 2.2 ** 3 + 3 * lens
        plug = plain(with_plugs.radius)[8]
        self.assertLess(field(size, "volume"), lids)
        self.assertGreater(field(size, "volume"), lids - 6 * 2 / 3 * math.pi * plug ** 3)

    def test_pores_of_a_box(self):
        """Balls on a cubic lattice: a place in the middle, three gates, the faces; the next frame has other ones."""
        box = hardsphere.Box([[0, 0, 0]], [1.0], [4, 4, 4])
        space = box.pores()
        self.assertEqual((len(space.maxima), len(space.gates)), (1, 3))
        self.assertAlmostEqual(field(space.maxima[0], "radius"), math.sqrt(12) - 1, 7)
        self.assertEqual(field(space.handle.get_channels(1.0)[0], "directions"), 3)
        self.assertEqual(len(box.pores(floor=2.6).maxima), 0)
        box.set([[0, 0, 0]], vectors=[6, 6, 6])
        self.assertAlmostEqual(field(box.pores(floor=2.6).maxima[0], "radius"), math.sqrt(27) - 1, 7)
        with self.assertRaises(hardsphere.Error):
            box.set([[0, 0, math.nan]])
        with self.assertRaises(hardsphere.Error):
            box.pores()

    def test_regions_of_a_box(self):
        """A box has its own boundary."""
        box = hardsphere.Box([[1, 1, 1]], [1.0], [4, 4, 4])
        pores = hardsphere.Pores().compute_periodic(box.handle)
        self.assertAlmostEqual(pores.find_regions().access.accessible_volume, 64 - 4 / 3 * math.pi, 7)

    def test_threads_give_the_same_bits(self):
        centers, radii = random_balls(1500, 20)
        for kind, more in ((hardsphere.Balls, {}), (hardsphere.Box, {"vectors": [20, 21, 22]})):
            alone, shared = (kind(centers, radii, probe=0.2, threads=threads, **more) for threads in (1, 3))
            self.assertEqual(plain(alone.areas), plain(shared.areas))
            self.assertEqual(plain(alone.gradient().d_centre), plain(shared.gradient().d_centre))
            self.assertEqual(alone.area, shared.area)

    def test_areas_alone_in_a_box(self):
        centers, radii = random_balls(200, 12)
        whole = hardsphere.Box(centers, radii, [12, 12, 12], probe=0.5)
        alone = hardsphere.Periodic().compute_with(centers, radii, [12, 0, 0, 0, 12, 0, 0, 0, 12], areas_alone=1, probe=0.5)
        self.assertEqual(plain(alone.get_gradient(tension=1.0, only="area")), plain(whole.areas))
        box = hardsphere.Box(centers, radii, [12, 12, 12], probe=0.5, areas_alone=True)
        self.assertEqual((box.area, plain(box.areas), box.volume), (whole.area, plain(whole.areas), None))
        self.assertEqual(plain(box.gradient().d_centre), plain(whole.gradient().d_centre))
        with self.assertRaises(hardsphere.Error):
            alone.get_counts()

    def test_rows_of_the_jacobian(self):
        centers, radii = random_balls(100, 8)
        balls = hardsphere.Balls(centers, radii)
        rows, whole = balls.boundary.get_area_rows(), balls.gradient()
        sums = [[0.0] * 3 for _ in range(balls.n)]
        for j, d in zip(plain(rows.ball), plain(rows.d_centre)):
            for k in range(3):
                sums[j][k] += d[k]
        self.assertEqual((rows.first[0], rows.first[balls.n]), (0, len(rows.ball)))
        for got, known in zip(sums, plain(whole.d_centre)):
            for k in range(3):
                self.assertAlmostEqual(got[k], known[k], 10)

    def test_errors_name_what_is_to_blame(self):
        balls = hardsphere.Balls(CENTERS, RADII)
        for call, text in [(lambda: balls.mesh(0), "edge: 0 is not above 0"),
                           (lambda: balls.mesh(math.nan), "edge: nan is not finite"),
                           (lambda: balls.svg(width=0), "width: 0 is not above 0"),
                           (lambda: balls.gradient(tension=math.inf), "tension: inf is not finite"),
                           (lambda: hardsphere.measure(CENTERS, RADII, step=-1.0), "step: -1.0 is negative"),
                           (lambda: hardsphere.Balls(CENTERS, RADII, probe=-1).area, "probe: -1 is negative")]:
            with self.assertRaises(hardsphere.Error) as refused:
                call()
            self.assertTrue(str(refused.exception).startswith(text + " in hsp_"), refused.exception)

    def test_handles_say_what_they_are(self):
        balls = hardsphere.Balls(CENTERS, RADII)
        self.assertEqual(repr(balls.boundary), f"Boundary({balls.n} balls)")
        self.assertEqual(repr(hardsphere.Model()), "Model(0 balls)")

    def test_constants(self):
        names = hardsphere.constants.__all__
        self.assertIn("PIECES_OUTSIDE_ALL", names)
        for name in names:
            self.assertEqual(getattr(hardsphere.constants, name), getattr(hardsphere, name))
            self.assertTrue(name.isupper())

    def test_second_derivatives(self):
        centers, radii = random_balls(40, 6)
        direction = [[math.sin(3 * i + k) for k in range(3)] for i in range(40)]
        boundary = hardsphere.Balls(centers, radii).boundary
        rows = boundary.get_hessian_rows(tension=0.5, pressure=-1.0)
        product = plain(boundary.get_hessian_product(direction, tension=0.5, pressure=-1.0).product)
        first, ball, block = plain(rows.first), plain(rows.ball), plain(rows.block)
        step, moved = 1e-4, []
        for side in step, -step:
            there = [[x + side * d for x, d in zip(*pair)] for pair in zip(centers, direction)]
            moved.append(plain(hardsphere.Balls(there, radii).gradient(tension=0.5, pressure=-1.0).d_centre))
        for i in range(40):
            for p in range(3):
                found = sum(block[k][p][q] * direction[ball[k]][q] for k in range(first[i], first[i + 1]) for q in range(3))
                self.assertAlmostEqual(found, product[i][p], 9)
                self.assertAlmostEqual((moved[0][i][p] - moved[1][i][p]) / (2 * step), product[i][p], delta=0.1)

    def test_pairs(self):
        centers, radii = random_balls(60, 8)
        near = [(i, j) for i in range(60) for j in range(i + 1, 60)
                if math.dist(centers[i], centers[j]) < radii[i] + radii[j]]
        balls = hardsphere.Balls(centers, radii)
        self.assertEqual(sorted(tuple(sorted(p)) for p in balls.pairs()), near)
        self.assertEqual(len(balls.pairs(once=False)), 2 * len(near))

    def test_pictures(self):
        balls = hardsphere.Balls(CENTERS, RADII)
        picture = balls.svg(hardsphere.colors_of(["C"] * balls.n), towards=[0, 0, 1], width=400, title="a < b")
        self.assertEqual(picture._repr_svg_(), picture)
        drawn = {node.get("data-ball") for node in ElementTree.fromstring(picture).iter()} - {None}
        self.assertGreater(len(drawn), 100)
        self.assertTrue(drawn <= set(map(str, range(balls.n))))
        self.assertNotEqual(picture, balls.svg(towards=[0, 1, 0], width=400))
        sticks = hardsphere.Balls([[0, 0, 0], [2, 0, 0]], [0.5, 0.5]).svg(bonds=[(0, 1)], towards=[0, 0, 1])
        self.assertGreater(len(list(ElementTree.fromstring(sticks).iter())), 3)
        pair = hardsphere.Balls([[0, 0, 0], [2, 0, 0]], [0.5, 0.5])
        arcs = {}  # bytes of them
        for kind in (1, 2, 3, "aromatic"):
            arcs[kind] = len(pair.svg(bonds=[(0, 1, kind)], towards=[0, 0, 1]))
        self.assertEqual(pair.svg(bonds=[[0, 1, 1]], towards=[0, 0, 1]), sticks)
        self.assertTrue(arcs[1] < arcs[2] < arcs[3], arcs)
        self.assertGreater(arcs["aromatic"], arcs[2])
        three = hardsphere.Balls([[0, 0, 0], [2, 0, 0], [4, 0, 0]], [0.5] * 3)
        drawn = [three.svg(bonds=zip([k], [k + 1]), towards=[0, 0, 1]) for k in (0, 1)]
        self.assertEqual(drawn, [three.svg(bonds=[(k, k + 1)], towards=[0, 0, 1]) for k in (0, 1)])
        with self.assertRaises(hardsphere.Error) as refused:  # the ball in the middle
            three.svg(bonds=[(0, 2)])
        conflict = refused.exception.conflict
        self.assertEqual((conflict.kind, conflict.first, conflict.second), (hardsphere.STICKS_STICK_IN_BALL, 0, 1))
        for kind in (0, 4, "double", None):
            with self.assertRaises(ValueError):
                pair.svg(bonds=[(0, 1, kind)])
        if _calls.numpy is not None:  # however many digits a program prints of arrays
            with _calls.numpy.printoptions(precision=1):
                self.assertNotEqual(*(pair.svg(towards=_calls.numpy.array([y, 0, 1])) for y in (0.51, 0.54)))
                self.assertNotEqual(*(pair.svg(bonds=[(0, 1)], up=_calls.numpy.array([0.1, y, 1])) for y in (0.51, 0.54)))

    def test_moves(self):
        centers, radii = random_balls(40, 8)
        moving = hardsphere.Moving(neighbours=100).set(hardsphere.Balls(centers, radii).model, 1.0, 0.0, 0)
        for step in range(5):
            centers[step] = [x + 0.3 for x in centers[step]]
            moving.move([step], [centers[step]])
        self.assertEqual(moving.measure(only="totals").area, hardsphere.measure(centers, radii).area)
        shared = hardsphere.Moving().set_with(hardsphere.Balls(centers, radii).model, tension=1.0, threads=2)
        self.assertEqual(shared.measure(only="totals").area, hardsphere.measure(centers, radii).area)
        with self.assertRaises(hardsphere.Error):  # nothing was set
            hardsphere.Moving().move([0], [centers[0]])
        model = hardsphere.Model().set([[0, 0, 0]] * 40, [1] * 40)
        moving.get_model(model)
        self.assertEqual(hardsphere.Boundary().compute(model).measure(only=["totals"]).area,
                         hardsphere.measure(centers, radii).area)

    def test_moves_that_take_more_room_than_there_was(self):
        centers = [[10.0 * k, 0, 0] for k in range(400)]
        model = hardsphere.Model().set(centers, [1] * 400, probe=0.25)
        sigma = [1 + k / 1000 for k in range(400)]
        moving = hardsphere.Moving().set(model, 1.0, 0.5, 0, sigma)
        sigma[:] = [7] * 400  # the caller's own again
        moving.move([399], [[20, 0.5, 0]])
        energy, areas = moving.gradient(only="energy").value, plain(moving.measure().area)
        together = [[0.0005 * k, 0.001 * k, 0] for k in range(350)]
        for place in "_make", "_grow":  # of the model, and of the balls
            with mock.patch.object(_calls.Handle, place, side_effect=MemoryError), self.assertRaises(MemoryError):
                moving.move(range(350), together)
            self.assertEqual((moving.gradient(only="energy").value, plain(moving.measure().area)), (energy, areas))
        failing = _calls._described("hsp_moving_set")
        refusing = failing._replace(function=lambda *_: hardsphere.E_CHECK)
        with mock.patch.dict(_calls._ready, hsp_moving_set=refusing), self.assertRaises(hardsphere.Error):
            moving.move(range(350), together)
        self.assertEqual((moving.gradient(only="energy").value, plain(moving.measure().area)), (energy, areas))
        moving.move(range(350), together)
        moved = together + centers[350:399] + [[20, 0.5, 0]]
        step = moving.get_info().step
        known = hardsphere.Model().set(moved, [1] * 400, probe=0.25, step=step)
        afresh = hardsphere.Moving(neighbours=400).set(known, 1.0, 0.5, 0, [1 + k / 1000 for k in range(400)])
        self.assertEqual(plain(moving.measure().area), plain(afresh.measure().area))
        self.assertEqual(plain(moving.gradient().d_centre), plain(afresh.gradient().d_centre))
        self.assertEqual(moving.gradient(only="energy").value, afresh.gradient(only="energy").value)
        self.assertEqual((moving.n, model.n), (400, 400))
        boundary = hardsphere.Boundary().compute(model)  # the caller's model has its own balls
        self.assertAlmostEqual(boundary.measure(only="totals").area, 400 * 4 * math.pi * 1.25 ** 2, 6)
        with self.assertRaises(hardsphere.Error):
            moving.move([400], [[0, 0, 0]])
        self.assertEqual(moving.gradient(only="energy").value, afresh.gradient(only="energy").value)

    def test_a_way_that_takes_more_room_than_there_was(self):
        centers, radii = random_balls(200, 20, low=0.5, high=1.0)
        paths = hardsphere.Paths().compute(hardsphere.Balls(centers, radii, probe=0.2).model)
        path = paths.find([-5, -5, -5], [25, 25, 25])
        points = plain(paths.get_points())
        self.assertEqual((list(points[0]), list(points[-1])), ([-5] * 3, [25] * 3))
        self.assertAlmostEqual(path.length, sum(map(math.dist, points, points[1:])), 9)

    def test_elements(self):
        self.assertEqual((hardsphere.radius_of("C"), hardsphere.radius_of(8)), (1.7, 1.52))
        with self.assertRaises(hardsphere.Error):
            hardsphere.radius_of("Xx")
        self.assertGreater(len(hardsphere.residue_get_atoms(hardsphere.RADII_PROTOR)), 100)

    def test_poses(self):
        fixed = hardsphere.Body().set(hardsphere.Balls([[0, 0, 0]], [1]).model)
        apart = [hardsphere.pose_from_matrix([1, 0, 0, 0, 1, 0, 0, 0, 1], [x, 0, 0]) for x in (1.9, 2.1, 5)]
        self.assertEqual(plain(fixed.hits(fixed, apart)), [1, 0, 0])
        self.assertAlmostEqual(field(fixed.gaps(fixed, apart)[2], "gap"), 3, 6)


class Bricks(unittest.TestCase):
    def test_summaries_are_bytes(self):
        pair = hardsphere.Balls([[0, 0, 0], [8, 0, 0]], [5, 5])
        first, second = (pair.boundary.brick_summarise(brick=k, bricks=2, flags=hardsphere.BRICK_KEEP_SHELLS, id=[7, 9],
                                                         owner=[0, 1]) for k in range(2))
        self.assertIsInstance(first, bytes)
        whole = hardsphere.brick_merge(second, first).summary
        totals = hardsphere.brick_get_totals(whole).totals
        self.assertEqual((totals.components, totals.circles, totals.euler), (1, 1, 2))
        self.assertAlmostEqual(totals.volume, 324 * math.pi, 9)
        shells = hardsphere.brick_get_shells(whole).out
        self.assertEqual([field(shell, "component") for shell in shells], [7])
        with self.assertRaises(hardsphere.Error) as missing:
            hardsphere.brick_get_totals(first)
        self.assertEqual(missing.exception.status, hardsphere.E_STATE)
        self.assertEqual(missing.exception.conflict, 1)
        with self.assertRaises(hardsphere.Error) as twice:
            hardsphere.brick_merge(first, first)
        self.assertEqual((twice.exception.status, twice.exception.conflict), (hardsphere.E_ID, 0))
        apart = hardsphere.Balls([[0, 0, 0], [80, 0, 0]], [5, 5]).boundary  # the second ball does not meet the first one
        with self.assertRaises(hardsphere.Error) as lacking:
            hardsphere.brick_merge(first, apart.brick_summarise(brick=1, bricks=2, flags=hardsphere.BRICK_KEEP_SHELLS,
                                                                id=[7, 9], owner=[0, 1]))
        self.assertEqual((lacking.exception.status, lacking.exception.conflict), (hardsphere.E_CONFLICT, 1))
        with self.assertRaises(hardsphere.Error) as damaged:
            hardsphere.brick_merge(first[:-8], second)
        self.assertEqual(damaged.exception.status, hardsphere.E_DAMAGED)


class AsPeopleTypeIt(unittest.TestCase):
    """One call for a question, files, and tables."""

    def test_files(self):
        molecule = hardsphere.read(CRAMBIN)
        self.assertEqual((plain(molecule.centers), plain(molecule.radii)), (CENTERS, RADII))
        self.assertEqual(len(molecule), 327)
        self.assertIn("327 atoms", repr(molecule))
        self.assertEqual((molecule.atom[1], molecule.element[3], molecule.residue[0], molecule.number[326], molecule.chain[5]),
                         ("CA", "O", "THR", 46, "A"))
        self.assertEqual(molecule.balls(1.4).area, said("measure", CRAMBIN, "--probe", "1.4")["area"])
        some = hardsphere.read(CRAMBIN, radii="protor", only="residue:CYS", no_water=True)
        self.assertEqual(set(some.residue), {"CYS"})
        self.assertEqual(some.input["radii"], "protor")
        columns = molecule.table()
        self.assertEqual({len(column) for column in columns.values()}, {327})
        self.assertEqual(plain(columns["z"])[326], CENTERS[326][2])
        for column in columns.values():  # the caller's own, to be changed
            column[0] = 99
        self.assertEqual((plain(molecule.centers), plain(molecule.radii)), (CENTERS, RADII))
        self.assertEqual((molecule.atom[0], molecule.element[0], molecule.residue[0], molecule.number[0], molecule.chain[0],
                          molecule.insertion[0]), ("N", "N", "THR", 1, "A", ""))
        bare = hardsphere.read(f"{SOURCE}/tests/program/inputs/good/one.xyzr")
        self.assertEqual((bare.atom, bare.number, len(plain(bare.centers)[0])), ([""], [None], 3))
        for wrong, why in ((lambda: hardsphere.read("/none.pdb"), "none.pdb"),
                           (lambda: hardsphere.read(b"/none\xe4.pdb"), "none.*No such file"),
                           (lambda: hardsphere.read("-none.pdb"), "-none.pdb.*No such file"),
                           (lambda: hardsphere.read(CRAMBIN, onyl="chain:A"), "onyl"),
                           (lambda: hardsphere.read(CRAMBIN, only="chain:Q"), "no atoms are left")):
            with self.assertRaisesRegex(ValueError, why):
                wrong()

    def test_voids_and_contacts(self):
        found = said("voids", CRAMBIN, "--probe", "0.5")["voids"]
        self.assertEqual([v.volume for v in hardsphere.voids(CENTERS, RADII, 0.5)],
                         sorted((v["volume"] for v in found), reverse=True))
        contacts = hardsphere.contacts(CENTERS, RADII)
        self.assertEqual(len(contacts), len(hardsphere.Balls(CENTERS, RADII).contacts()))
        self.assertEqual(len(hardsphere.contacts(CENTERS, RADII, groups=[i % 2 for i in range(327)])), 1)

    def test_pockets(self):
        for probe in 1.0, 0.6:
            found = said("pores", CRAMBIN, "--probe", str(probe), "--pockets", "3", "--balls")["pocket_list"]
            volumes = sorted((-1 if p["volume"] is None else p["volume"] for p in found), reverse=True)
            pockets = hardsphere.pockets(CENTERS, RADII, probe, 3.0)
            self.assertGreater(len(pockets), 5)
            for pocket, volume in zip(pockets, volumes):
                self.assertAlmostEqual(-1 if pocket.volume is None else pocket.volume, volume, 9)
            lined = {tuple(p["xyz"]): p for p in found}
            for pocket in pockets:
                known = lined[tuple(plain(pocket.center))]
                self.assertEqual((pocket.radius, plain(pocket.balls), pocket.mouths),
                                 (known["radius"], known["balls"], len(known["mouths"])))
                self.assertEqual(pocket.mouth, known["mouth_radius"] if pocket.mouths else 0.0)
        self.assertEqual(hardsphere.pockets([[0, 0, 0]], [1]), [])
        # A mouth of three balls nearly on a line, whose plug is larger than the lattice of the balls has room for.
        centers = [(2.428, 3.786, 0.351), (1.174, 3.4, 0.459), (1.559, 1.337, 2.72), (3.714, 0.699, 2.959),
                   (2.936, 3.343, 2.213), (3.694, 1.451, 1.659), (0.918, 3.118, 1.922), (1.078, 0.679, 2.883),
                   (2.423, 2.843, 1.547)]
        wide_open, = hardsphere.pockets(centers, [0.74, 0.44, 0.94, 0.32, 0.72, 0.98, 0.91, 0.39, 0.51], 0.2, 1.0)
        self.assertEqual((wide_open.volume, wide_open.mouths), (0.0, 4))

    def test_meshes_in_files(self):
        mesh = hardsphere.surface_mesh(CENTERS, RADII, 1.5, probe=1.4, smooth=True)
        with tempfile.TemporaryDirectory() as folder:
            for kind in "ply", "obj":
                mesh.write(f"{folder}/mesh.{kind}")
                with open(f"{folder}/mesh.{kind}") as file:
                    rows = [row.split() for row in file]
                if kind == "ply":
                    at = rows.index(["end_header"])
                    self.assertIn(["element", "vertex", str(len(mesh.vertices))], rows[:at])
                    rows = rows[at + 1:]
                    vertices = [row[:3] for row in rows[:len(mesh.vertices)]]
                    self.assertEqual([int(row[6]) for row in rows[:len(mesh.vertices)]], plain(mesh.balls))
                    faces = [row[1:] for row in rows[len(mesh.vertices):]]
                else:
                    vertices = [row[1:] for row in rows if row[0] == "v"]
                    faces = [[int(corner.split("//")[0]) - 1 for corner in row[1:]] for row in rows if row[0] == "f"]
                self.assertEqual([list(map(int, face)) for face in faces], [list(t) for t in plain(mesh.triangles)])
                volume = 0.0
                for a, b, c in faces:  # of the tetrahedra over the faces
                    (x, y, z), (u, v, w), (p, q, r) = ([float(t) for t in vertices[int(k)]] for k in (a, b, c))
                    volume += (x * (v * r - w * q) + y * (w * p - u * r) + z * (u * q - v * p)) / 6
                exact = hardsphere.Balls(CENTERS, RADII, probe=1.4).surface().totals.volume
                self.assertLess(abs(volume / exact - 1), 0.05)
            with self.assertRaisesRegex(ValueError, "is no .ply or .obj file"):
                mesh.write(f"{folder}/mesh.stl")

    def test_tables(self):
        contacts = hardsphere.contacts(CENTERS, RADII)
        table = hardsphere.table(contacts)
        self.assertEqual(list(table), ["area", "rim", "distance", "ball_0", "ball_1", "chords", "flags"])
        self.assertEqual([(i, j) for i, j in zip(plain(table["ball_0"]), plain(table["ball_1"]))],
                         [tuple(field(contact, "ball")) for contact in contacts])
        self.assertEqual(plain(table["area"]), [field(contact, "area") for contact in contacts])
        voids = hardsphere.voids(CENTERS, RADII, 0.5)
        self.assertEqual(hardsphere.table(voids)["volume"], [v.volume for v in voids])
        self.assertEqual(len(hardsphere.table(voids)["balls"]), len(voids))
        self.assertEqual(hardsphere.table([]), {})


class Interrupted(Exception):
    pass


class Signals(unittest.TestCase):
    """Exceptions that come at any time, as KeyboardInterrupt does, leave nothing running behind."""

    def setUp(self):
        def handler(*_):
            raise Interrupted

        self.addCleanup(signal.signal, signal.SIGUSR1, signal.signal(signal.SIGUSR1, handler))
        self.centers, self.radii = random_balls(1500, 20)
        self.areas = plain(hardsphere.Balls(self.centers, self.radii, probe=0.2).areas)
        self.begun, self.running, self.left = 0, 0, []  # left: tasks that were running when a loop returned
        self.lock = threading.Lock()

    def loops(self, in_task=lambda number: None):
        """All loops count their tasks, which take some time."""
        loop = _calls._LOOP

        def counted(run):
            def counting(context, tasks, task, data):
                def slow(data, k):
                    with self.lock:
                        self.begun, self.running = self.begun + 1, self.running + 1
                        number = self.begun
                    try:
                        in_task(number)
                        time.sleep(0.002)
                        task(data, k)
                    finally:
                        with self.lock:
                            self.running -= 1

                try:
                    return run(context, tasks, slow, data)
                finally:
                    self.left.append(self.running)
                    begun = self.begun
                    time.sleep(0.01)
                    self.left.append(self.begun - begun)

            return loop(counting)

        return mock.patch.object(_calls, "_LOOP", counted)

    def starts(self, start):
        """start(real, *arguments) starts threads."""
        stack = contextlib.ExitStack()
        for of, name in (threading.Thread, "start"), (_calls, "start_new_thread"):
            if hasattr(of, name):
                real = getattr(of, name)
                stack.enter_context(mock.patch.object(of, name, lambda *given, real=real: start(real, *given)))
        return stack

    def test_an_exception_while_threads_are_started(self):
        for last in 1, 2, 3:
            for before in False, True:
                starts = []

                def start(real, *given):
                    starts.append(0)
                    if before and len(starts) == last:
                        raise KeyboardInterrupt
                    result = real(*given)
                    if len(starts) == last:
                        raise KeyboardInterrupt
                    return result

                balls = hardsphere.Balls(self.centers, self.radii, probe=0.2, threads=3)
                with self.loops(), self.starts(start), self.assertRaises(KeyboardInterrupt):
                    balls.areas
                self.assertEqual(set(self.left), {0} if self.left else set())
                self.assertEqual(plain(balls.areas), self.areas)

    def test_an_exception_before_the_library_is_called(self):
        """The handle has the balls of before."""
        model = hardsphere.Model().set(self.centers, self.radii)
        with self.starts(mock.Mock(side_effect=KeyboardInterrupt)), self.assertRaises(KeyboardInterrupt):
            model.set_with(LENS, [1, 1], threads=3)
        self.assertEqual(model.n, 1500)
        self.assertEqual(len(model.query_pairs(0).first), 1501)

    def test_a_signal_in_a_task(self):
        for which in 1, 3:
            def interrupt(number):
                if number == which:
                    os.kill(os.getpid(), signal.SIGUSR1)

            self.begun = 0
            balls = hardsphere.Balls(self.centers, self.radii, probe=0.2, threads=3)
            with self.loops(interrupt), self.assertRaises(Interrupted):
                balls.areas
            self.assertGreaterEqual(self.begun, which)
            self.assertEqual(set(self.left), {0})
            self.assertEqual(plain(balls.areas), self.areas)

    def test_no_thread_can_be_started(self):
        def start(*_):
            raise RuntimeError("can't start new thread")

        for most in 0, 1, 2:
            starts = []

            def some(real, *given):
                starts.append(0)
                return real(*given) if len(starts) <= most else start()

            balls = hardsphere.Balls(self.centers, self.radii, probe=0.2, threads=3)
            with self.loops(), self.starts(some):
                self.assertEqual(plain(balls.areas), self.areas)
            self.assertGreater(self.begun, 1)

    def sinks(self, broken, fault):
        """fault(sink, *arguments) takes the broken one of the pieces of a picture."""
        made = _calls._SINK

        def counted(sink):
            pieces = []

            def take(*given):
                pieces.append(0)
                return fault(sink, *given) if len(pieces) == broken else sink(*given)

            return made(take)

        return mock.patch.object(_calls, "_SINK", counted)

    def test_an_exception_while_a_picture_is_written(self):
        """There is none with a hole."""
        balls = hardsphere.Balls(self.centers, self.radii)
        picture = balls.svg()
        self.assertGreater(len(picture), 10 * 1024)

        class Unreadable:
            def __getitem__(self, _):
                raise MemoryError

        def before(sink, *given):  # the sink is called
            os.kill(os.getpid(), signal.SIGUSR1)
            return sink(*given)

        def inside(sink, context, text, count):
            sink(context, Unreadable(), count)
            return 0

        def lost(*_):
            return 0

        for broken in 1, 5:
            for fault, raised in (before, Interrupted), (inside, MemoryError), (lost, hardsphere.Error):
                with self.subTest(f"{fault.__name__} {broken}"):
                    with self.sinks(broken, fault), self.assertRaises(raised):
                        balls.svg()
                    self.assertEqual(balls.svg(), picture)

        def start(*_):
            raise RuntimeError("can't start new thread")

        with self.starts(start):
            self.assertEqual(balls.svg(), picture)
        view = hardsphere.View().compute(balls.model, towards=[0, 0, 1])
        for kind in hardsphere.FORMAT_EPS, hardsphere.FORMAT_PDF:  # their bytes are counted, too
            self.assertGreater(len(view.picture_write(format=kind, width=400.0)), 10 * 1024)

    def test_other_threads_may_call(self):
        found = []
        with self.loops():
            thread = threading.Thread(target=lambda: found.append(
                plain(hardsphere.Balls(self.centers, self.radii, probe=0.2, threads=3).areas)))
            thread.start()
            thread.join()
        self.assertEqual(found, [self.areas])


class Wrong(unittest.TestCase):
    def test_the_ball_to_blame(self):
        with self.assertRaises(hardsphere.Error) as refused:
            hardsphere.measure([[0, 0, 0], [0, math.nan, 0]], [1, 1])
        self.assertEqual((refused.exception.status, refused.exception.ball), (hardsphere.E_NOT_FINITE, 1))
        with self.assertRaises(hardsphere.Error) as refused:
            hardsphere.Box(LENS, [1, -1], [9, 9, 9])
        self.assertEqual((refused.exception.status, refused.exception.ball), (hardsphere.E_NEGATIVE, 1))
        with self.assertRaises(hardsphere.Error) as refused:
            hardsphere.Balls(LENS, [1, 1]).gradient(sigma=[1, math.inf])
        self.assertEqual((refused.exception.status, refused.exception.ball), (hardsphere.E_NOT_FINITE, 1))

    def test_exceptions_of_other_processes(self):
        """They come pickled: what cannot be read then leaves a pool waiting for ever."""
        for call in (lambda: hardsphere.measure(LENS, [1, -1]), lambda: hardsphere.measure(LENS, [1, 1], probe=-1),
                     lambda: hardsphere.measure(LENS, [1]), lambda: hardsphere.Topology().get_counts()):
            with self.assertRaises(ValueError) as refused:
                call()
            there = pickle.loads(pickle.dumps(refused.exception))
            self.assertEqual((type(there), str(there), vars(there)),
                             (type(refused.exception), str(refused.exception), vars(refused.exception)))

    def test_lengths(self):
        for centers, radii in ((LENS, [1]), ([[0, 0]], [1]), (LENS, [[1, 1], [1, 1]])):
            with self.assertRaises((ValueError, TypeError)):
                hardsphere.measure(centers, radii)
        balls = hardsphere.Balls(LENS, [1, 1])
        for call in (lambda: balls.measure([True]), lambda: balls.gradient(sigma=[1]), lambda: balls.contacts([0] * 3),
                     lambda: balls.svg([0])):
            with self.assertRaises(ValueError):
                call()

    def test_a_set_that_fails_leaves_nothing_to_ask_for(self):
        balls, box = hardsphere.Balls(LENS, [1, 1]), hardsphere.Box(LENS, [1, 1], [9, 9, 9])
        bad = [([[0, 0, 0], [0, math.nan, 0]], [1, 1]), (LENS, [1, -1]), (LENS, [1]), ([[0, 0], [1, 0]], [1, 1]), (7, [1, 1]),
               ([["x", 0, 0], [1, 0, 0]], [1, 1])]
        for of, more in ((balls, [[]]), (box, [[], [[1, 2]], [["x", 1, 1]]])):
            for centers, radii in bad + [(LENS, [1, 1])]:
                for vectors in more[1:] if radii == [1, 1] and centers == LENS else more[:1]:
                    of.set(LENS, [1, 1], *([[9, 9, 9]] if of is box else []))
                    self.assertGreater(of.area, 0)
                    with self.assertRaises((hardsphere.Error, ValueError, TypeError)):
                        of.set(centers, radii, *vectors)
                    for ask in (lambda: of.area, of.measure, of.contacts, of.gradient):
                        with self.assertRaises(hardsphere.Error) as refused:
                            ask()
                        self.assertEqual(refused.exception.status, hardsphere.E_STATE)

    def refused(self, message, call):
        with self.assertRaises(ValueError) as refused:
            call()
        self.assertEqual(str(refused.exception), message)

    def test_shapes(self):
        """By the names that the caller knows."""
        across = [list(row) for row in zip(*CENTERS)]
        n = len(RADII)
        balls, box = hardsphere.Balls(CENTERS, RADII), hardsphere.Box(LENS, [1, 1], [9, 9, 9])
        self.refused(f"centers: shape (3, {n}), expected (n, 3)", lambda: hardsphere.measure(across, RADII))
        self.refused(f"centers: shape (3, {n}), expected (n, 3)", lambda: hardsphere.Balls(LENS, [1, 1]).set(across))
        self.refused(f"xyz: shape (3, {n}), expected (n, 3)", lambda: hardsphere.Model().set(across, RADII))
        self.refused(f"xyz: shape (3, {n}), expected (n, 3)", lambda: hardsphere.areas(across, RADII, 1.4))
        self.refused("radii: shape (1,), expected (2,)", lambda: hardsphere.measure(LENS, [1]))
        self.refused("radii: shape (2, 1), expected (2,)", lambda: hardsphere.Box(LENS, [[1], [1]], [9, 9, 9]))
        self.refused("centers: shape (3, 4), expected (n, 3)", lambda: hardsphere.Box([[0] * 4] * 3, [1] * 4, [9, 9, 9]))
        self.refused("vectors: shape (2,), expected (3,) or (3, 3)", lambda: hardsphere.Box(LENS, [1, 1], [1, 2]))
        self.refused("vectors: shape (9,), expected (3,) or (3, 3)",
                     lambda: hardsphere.Box(LENS, [1, 1], [9, 9, 9]).set(LENS, vectors=[1] * 9))
        self.refused("selected: shape (1,), expected (327,)", lambda: balls.measure([True]))
        self.refused("sigma: shape (1, 327), expected (327,)", lambda: balls.gradient(sigma=[[1] * n]))
        self.refused("groups: shape (3,), expected (327,)", lambda: balls.contacts([0] * 3))
        self.refused("groups: shape (3,), expected (2,)", lambda: box.contacts([0] * 3))
        for bonds in None, [(0, 1)]:
            self.refused("colors: shape (1,), expected (327,)", lambda: balls.svg([0], bonds=bonds))
        self.refused("towards: shape (2,), expected (3,)", lambda: balls.svg(towards=[1, 2]))
        for wrong in 1 << 32, -1, 0.5:  # C would make other integers of them, as 0
            said = f"{wrong} is no whole number of 32 bits from 0 on"
            self.refused(f"groups: {said}", lambda: box.contacts([0, wrong]))
            self.refused(f"colors: {said}", lambda: balls.svg([wrong] * n))
        self.assertEqual(len(hardsphere.contacts(LENS, [1, 1], groups=[0.0, 1.0])), 1)
        self.refused("from_: shape (2,), expected (3,)", lambda: balls.pores().handle.widest([1, 2]))
        self.refused("matrix: shape (8,), expected (9,)", lambda: hardsphere.pose_from_matrix([1] * 8, [0] * 3))

    def test_single_numbers_are_what_they_say(self):
        """ctypes takes the last bits of a larger one: 2^32 would be the ball 0."""
        balls = hardsphere.Balls(LENS, [1, 1])
        pores = balls.pores().handle
        for wrong in 1 << 32, -1:
            said = f"{wrong} is no whole number of 32 bits from 0 on"
            self.refused(f"ball: {said}", lambda: balls.model.query_neighbours(wrong))
            self.refused(f"first: {said}", lambda: pores.get_maxima(wrong, 0))
            self.refused(f"tangency: {said}", lambda: balls.gradient(tangency=wrong))
            self.refused(f"atomic_number: {said}", lambda: hardsphere.radius_of(wrong))
            self.refused(said, lambda: hardsphere.Boundary(vertices=wrong).compute(balls.model))
            self.refused(f"ball: {wrong} does not fit", lambda: balls.svg(bonds=[(wrong, 1)]))
        self.refused("4294967298 is no whole number of 32 bits from 0 on",
                     lambda: hardsphere.measure(LENS, [1, 1], threads=(1 << 32) + 2))
        self.refused("ball: 'float' object cannot be interpreted as an integer", lambda: balls.model.query_neighbours(1.0))
        self.assertEqual(plain(balls.model.query_neighbours(True)), [0])
        if _calls.numpy is not None:  # its integers are numbers of rows, too
            numpy = _calls.numpy
            self.assertEqual(plain(balls.model.query_neighbours(numpy.int64(1))), [0])
            cube = hardsphere.Balls([[x, y, z] for x in (0, 4) for y in (0, 4) for z in (0, 4)], [1.0] * 8)
            self.assertEqual(len(cube.pores().handle.get_maxima(0, numpy.uint32(1))), 1)

    def test_what_is_of_another_type(self):
        balls = hardsphere.Balls(LENS, [1, 1])
        body = hardsphere.Body().set(balls.model)
        pose = hardsphere.pose_from_matrix([1, 0, 0, 0, 1, 0, 0, 0, 1], [1, 0, 0])
        exact = hardsphere.RationalPose((1, 0, 0, 1), (1, 0, 0))
        self.assertEqual(len(body.pairs(body, pose)), len(body.rational_pairs(body, exact)))
        self.refused("pose: RationalPose, expected Pose", lambda: body.pairs(body, exact))
        self.refused("pose: Pose, expected RationalPose", lambda: body.rational_pairs(body, pose))
        self.refused("posed: Balls, expected a handle", lambda: body.hits(balls, [pose]))
        self.refused("model: Balls, expected a handle", lambda: hardsphere.Boundary().compute(balls))
        self.refused("centers: None, expected an array", lambda: hardsphere.measure(None, None))
        self.refused("title: has a zero byte", lambda: balls.svg(title="a\0b"))
        self.refused("title: int, expected str", lambda: balls.svg(title=1))
        self.refused("style: 'sharp', expected flat, headlight or soft", lambda: balls.svg(style="sharp"))
        self.refused("ink: Balls, expected a handle", lambda: balls.svg(ink=balls))
        self.refused("symbol: has a zero byte", lambda: hardsphere.radius_of("C\0l"))
        self.refused("only: one of totals, area, volume_term", lambda: balls.boundary.get_measures(only="aera"))
        if _calls.numpy is None:
            return
        numpy = _calls.numpy
        rows = numpy.frombuffer(bytes(pose), dtype=numpy.dtype(hardsphere.Pose))
        self.assertEqual((plain(body.hits(body, rows)), len(body.pairs(body, rows[0]))), ([1], 4))
        for wrong in numpy.zeros(1, "S56"), rows.astype(rows.dtype.newbyteorder()):
            self.refused(f"pose: {wrong.dtype}, expected {rows.dtype}", lambda: body.hits(body, wrong))
        for groups in 1, numpy.array(1):
            self.refused("groups: shape (1,), expected (2,)", lambda: balls.contacts(groups))
        some = numpy.ma.masked_greater(numpy.array(LENS, dtype=float), 0.5)
        for wrong in some, numpy.array(LENS) + 1j:
            self.refused("centers: masked values, or complex numbers", lambda: hardsphere.measure(wrong, [1, 1]))
        self.assertEqual(hardsphere.measure(numpy.ma.array(LENS), [1, 1]).area, balls.area)

    def test_shapes_that_serve(self):
        area = hardsphere.measure(CENTERS, RADII).area
        flat = [x for row in CENTERS for x in row]
        for centers in tuple(map(tuple, CENTERS)), flat:
            self.assertEqual(hardsphere.measure(centers, tuple(RADII)).area, area)
        if _calls.numpy is None:
            return
        x = _calls.numpy.array(CENTERS)
        wide = _calls.numpy.zeros((len(x), 6))
        wide[:, ::2] = x
        for centers in x, wide[:, ::2], _calls.numpy.asfortranarray(x), x.T.copy().T, x[::-1][::-1], list(x), x.astype(">f8"):
            self.assertEqual(hardsphere.measure(centers, RADII).area, area)
        for wrong in x.T, x.ravel(), x[None], x[:, :2], _calls.numpy.asfortranarray(x.T):
            self.refused(f"centers: shape {wrong.shape}, expected (n, 3)", lambda: hardsphere.measure(wrong, RADII))
        self.refused("pose: shape (1, 2), expected (poses,)", lambda: self.hits_of_rows())
        self.assertEqual(hardsphere.measure(x.astype(int) * 5, RADII).area,
                         hardsphere.measure((x.astype(int) * 5).tolist(), RADII).area)
        self.assertEqual(hardsphere.measure(_calls.numpy.zeros((0, 3)), _calls.numpy.zeros(0)).area, 0)

    def hits_of_rows(self):
        body = hardsphere.Body().set(hardsphere.Balls([[0, 0, 0]], [1]).model)
        poses = [hardsphere.pose_from_matrix([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [x, 0, 0]) for x in (1.9, 5)]
        self.assertEqual(plain(body.hits(body, poses)), [1, 0])
        numpy = _calls.numpy
        return body.hits(body, numpy.frombuffer(b"".join(map(bytes, poses)), dtype=numpy.dtype(type(poses[0])))[None])

    def test_no_library(self):
        """A package without one says so, unless the loader finds another."""
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(f"{SOURCE}/capi/python/hardsphere", f"{folder}/hardsphere")
            run = subprocess.run([sys.executable, "-c", "import hardsphere"], cwd=folder, capture_output=True, text=True,
                                 check=False, env={"PYTHONDONTWRITEBYTECODE": "1"})
        if run.returncode != 0:
            self.assertIn("ImportError: there is no libhardsphere.so.2", run.stderr)

    def test_refused_before_the_library_is_called(self):
        """The handle has the balls of before, and arrays have room for them."""
        centers, radii = random_balls(2000, 30)
        model = hardsphere.Model().set(centers, radii)
        for wrong in {"step": "x"}, {"probe": []}:
            with self.assertRaises(TypeError):
                model.set(LENS, [1, 1], **wrong)
            self.assertEqual(model.n, 2000)
            self.assertEqual(len(model.query_pairs(0).first), 2001)
            self.assertEqual(len(model.arrangement().of_ball), 2000)

    def test_memory_that_runs_out(self):
        """The next call makes the handle, or it is as before."""
        boundary = hardsphere.Boundary().compute(hardsphere.Model().set(LENS, [1, 1]))
        mesh = hardsphere.Mesh()
        with mock.patch.object(_calls.Handle, "_make", side_effect=MemoryError), self.assertRaises(MemoryError):
            mesh.compute(boundary, 0.5)
        triangles = mesh.compute(boundary, 0.5).get_counts().triangles
        self.assertGreater(triangles, 10)
        with mock.patch.object(_calls.Handle, "_make", side_effect=MemoryError), self.assertRaises(MemoryError):
            mesh.compute(boundary, 0.01)
        self.assertEqual(mesh.compute(boundary, 0.5).get_counts().triangles, triangles)
        self.assertGreater(mesh.compute(boundary, 0.01).get_counts().triangles, triangles)

    def test_more_balls_than_there_are_limits_for(self):
        """So many take gigabytes: here the library says it of any number."""
        centers, radii = random_balls(50, 7)
        areas = plain(hardsphere.Box(centers, radii, [9, 9, 9]).areas)
        known = _calls._described("hsp_periodic_limits_init")

        def refuses(limits, size, balls, *more):
            return hardsphere.E_RANGE if balls > 0 else known.function(limits, size, balls, *more)

        with mock.patch.dict(_calls._ready, hsp_periodic_limits_init=known._replace(function=refuses)):
            self.assertEqual(plain(hardsphere.Box(centers, radii, [9, 9, 9]).areas), areas)

    def test_nothing_computed(self):
        with self.assertRaises(hardsphere.Error):
            hardsphere.Boundary().get_counts()
        self.assertEqual(hardsphere.measure([], []).area, 0)


class EveryGetter(unittest.TestCase):
    """What takes no argument, of all handles: a description that is wrong shows as a refusal or a wrong length."""

    def test_handles(self):
        centers, radii = random_balls(50, 7)
        balls = hardsphere.Balls(centers, radii, probe=0.1)
        balls.mesh(0.5), balls.contacts(), balls.topology, balls.surface(), balls.pores(), balls.svg()
        handles = [balls.model, *balls._handles.values(), hardsphere.Cells().compute(balls.model),
                   hardsphere.Map().compute(balls.model, towards=[0, 0, 1]), hardsphere.Box(centers, radii, [9, 9, 9]).handle]
        called = 0
        for handle in handles:
            for name, method in inspect.getmembers(handle, inspect.ismethod):
                parameters = inspect.signature(method).parameters
                needs = [p for p in parameters.values() if p.default is p.empty]
                given = {"boundary": balls.boundary} if "boundary" in parameters else {}
                if not name.startswith("_") and not needs and not name.startswith(("brick", "compute", "set")):
                    with self.subTest(f"{handle.noun}.{name}"):
                        method(**given)
                        called += 1
        self.assertGreater(called, 60)
        self.assertEqual(len(balls.boundary.get_vertices()), balls.counts.vertices)
        self.assertEqual(len(balls.boundary.measure_faces().area), balls.counts.faces)


if __name__ == "__main__":
    unittest.main()
