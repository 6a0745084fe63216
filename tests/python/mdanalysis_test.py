"""Areas of MDAnalysis's selections over a trajectory, against the module itself and against the program."""
import json
import os
import shutil
import subprocess
import tempfile
import unittest
import warnings

from program import CRAMBIN, SOURCE, run_block_of_page

warnings.simplefilter("ignore")

import MDAnalysis
import numpy
from MDAnalysis.transformations import set_dimensions

import hardsphere
from hardsphere.mdanalysis import SASA, Pockets

FOLDER = tempfile.TemporaryDirectory()  # MDAnalysis writes beside a trajectory
RUN = shutil.copy(f"{SOURCE}/tests/program/inputs/crambin.xtc", FOLDER.name)


class Trajectory(unittest.TestCase):
    def setUp(self):
        self.universe = MDAnalysis.Universe(CRAMBIN, RUN)

    def test_areas_are_those_of_the_frames(self):
        run = SASA(self.universe.atoms).run()
        self.assertGreater(len(run.results.area), 1)
        radii = [hardsphere.radius_of(e.capitalize()) for e in self.universe.atoms.elements]
        for frame, areas in zip(self.universe.trajectory, run.results.areas):
            own = hardsphere.measure(self.universe.atoms.positions, radii, probe=1.4)
            self.assertTrue((areas == own.areas).all())
        self.assertTrue(numpy.allclose(run.results.area, run.results.areas.sum(axis=1), rtol=1e-14))
        self.assertEqual(run.results.residue_areas.shape, (len(run.results.area), 46))
        self.assertTrue(numpy.allclose(run.results.residue_areas.sum(axis=1), run.results.area, rtol=1e-12))

    def test_the_program_says_the_same_up_to_floats(self):
        rows = subprocess.run([os.environ["HSP_PROGRAM"], "measure", CRAMBIN, "--trajectory", RUN, "--probe",
                               "1.4", "--json"], capture_output=True, text=True, check=True).stdout.splitlines()
        said = [json.loads(row)["area"] for row in rows]
        self.assertTrue(numpy.allclose(SASA(self.universe.atoms).run().results.area, said, atol=5e-3, rtol=0))

    def test_what_is_around_blocks(self):
        atoms = self.universe.select_atoms("resid 1-10")
        alone, among = SASA(atoms).run(), SASA(atoms, environment=self.universe.atoms, cavities=True).run()
        self.assertTrue((among.results.area < alone.results.area).all())
        self.assertEqual(len(among.results.cavities), len(among.results.area))
        whole = SASA(self.universe.atoms).run().results.areas[:, :len(atoms)]
        self.assertTrue((among.results.areas == whole).all())
        with self.assertRaises(ValueError):
            SASA(self.universe.atoms, environment=atoms)

    def test_an_atom_that_is_there_twice(self):
        """As in a sum of selections: it blocks once, and has its area."""
        atoms, others = self.universe.select_atoms("resid 1-10"), self.universe.select_atoms("resid 5-20")
        once = SASA(atoms, environment=atoms | others).run().results.areas
        for environment in atoms + others, others + atoms:
            self.assertTrue((SASA(atoms, environment=environment).run().results.areas == once).all())
        with self.assertRaisesRegex(ValueError, "twice"):
            SASA(atoms + others)

    def test_pockets_are_those_of_the_frames(self):
        run = Pockets(self.universe.atoms, narrow=0.8, wide=3.0, least=1.0).run()
        radii = [hardsphere.radius_of(e.capitalize()) for e in self.universe.atoms.elements]
        self.assertEqual(len(run.results.pockets), len(self.universe.trajectory))
        for frame, found, volume in zip(self.universe.trajectory, run.results.pockets, run.results.volume):
            own = [p for p in hardsphere.pockets(self.universe.atoms.positions, radii, 0.8, 3.0) if (p.volume or 0) >= 1]
            self.assertEqual([p.volume for p in found], [p.volume for p in own])
            self.assertTrue(0 < len(found) and volume == sum(p.volume for p in own))
        # From a file with the digits of this frame, the program says the same.
        with tempfile.TemporaryDirectory() as folder:
            self.universe.trajectory[0]
            with open(f"{folder}/frame.xyzr", "w") as file:
                for at, radius in zip(self.universe.atoms.positions.astype(float), radii):
                    file.write(f"{at[0]!r} {at[1]!r} {at[2]!r} {radius!r}\n")
            listed = json.loads(subprocess.run([os.environ["HSP_PROGRAM"], "pores", file.name, "--probe", "0.8", "--pockets", "3",
                                                "--json"], capture_output=True, text=True, check=True).stdout)
        volumes = sorted((p["volume"] for p in listed["pocket_list"] if (p["volume"] or 0) >= 1), reverse=True)
        self.assertTrue(numpy.allclose([p.volume for p in run.results.pockets[0]], volumes, rtol=1e-9))

    def test_radii_of_the_caller_are_copied(self):
        """They may change before a run; those that Balls refuses are refused."""
        atoms, kept = self.universe.atoms, numpy.linspace(1.4, 1.9, len(self.universe.atoms))
        for kind, result, more in (SASA, "area", {}), (Pockets, "volume", {"narrow": 0.8}):
            expected = kind(atoms, radii=kept, **more).run(stop=2).results[result]
            self.assertTrue((expected > 0).all())
            for made in list, numpy.array:
                radii = made(kept)
                analysis = kind(atoms, radii=radii, **more)
                radii[:] = made([3.0] * len(atoms))
                self.assertTrue((analysis.run(stop=2).results[result] == expected).all(), (kind, made))
            for wrong in numpy.ma.array(kept, mask=kept < 1.5), kept + 1j:
                with self.assertRaisesRegex(ValueError, "radii: masked values, or complex numbers"):
                    kind(atoms, radii=wrong).run(stop=1)

    def test_a_box(self):
        def area(side, box):
            universe = MDAnalysis.Universe(CRAMBIN, RUN)
            universe.trajectory.add_transformations(set_dimensions([side, side, side, 90, 90, 90]))
            return SASA(universe.atoms, box=box).run(stop=2).results.area
        self.assertTrue(numpy.allclose(area(90, True), area(90, False), rtol=1e-9))
        self.assertTrue((area(30, True) < area(30, False) - 1).all())

    def test_a_frame_without_a_box_is_not_in_that_of_the_frame_before(self):
        def without_the_second(frame):
            frame.dimensions = [30, 30, 30, 90, 90, 90] if frame.frame == 0 else None
            return frame
        self.universe.trajectory.add_transformations(without_the_second)
        self.assertGreater(SASA(self.universe.atoms, box=True).run(stop=1).results.area[0], 0)
        with self.assertRaisesRegex(ValueError, "frame 1 has no box"):
            SASA(self.universe.atoms, box=True).run(stop=2)

    def test_atoms_that_change_from_frame_to_frame_are_refused(self):
        atoms = self.universe.select_atoms("prop x > 8", updating=True)
        for call in (lambda: SASA(atoms), lambda: SASA(self.universe.atoms[:9], environment=atoms), lambda: Pockets(atoms),
                     lambda: SASA(atoms, environment=self.universe.atoms)):
            with self.assertRaisesRegex(ValueError, "a selection that updates"):
                call()

    def test_the_lines_of_the_guide(self):
        run = run_block_of_page("MDAnalysis")["run"]
        self.assertAlmostEqual(run.results.area[0], SASA(self.universe.atoms).run(stop=1).results.area[0], 2)


if __name__ == "__main__":
    unittest.main()
