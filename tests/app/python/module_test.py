"""The module against what it stands on: views without copies, errors in words, Ctrl-C, the same bits as the command line."""

import gc
import json
import os
import re
import signal
import subprocess
import tempfile
import threading
import unittest

import numpy as np

import rubble


def blocks(count=6, height=5.0, states=6):
    """A row of cubes of 1 m, 1.5 m apart, that fall freely; cube e dies at state 1 + e % 3."""
    corner = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)
    start = np.concatenate([corner + [1.5 * e, 0, height] for e in range(count)])
    times = 0.1 * np.arange(states)
    positions = start[None] - np.array([0, 0, 0.5 * 9.80665]) * times[:, None, None] ** 2
    elements = np.arange(8 * count).reshape(count, 8)
    active = np.arange(states)[:, None] < 1 + np.arange(count)[None] % 3
    return times, positions, elements, active


def collapse(**more):
    made = rubble.from_arrays(*blocks(), density=2000.0, **more)
    made.set("settle_time", 0.5)
    return made


def endless():
    """A collapse that takes longer than any test waits."""
    made = rubble.from_arrays(*blocks(400, 5000.0), density=2000.0)
    made.set("settle_time", 10000)
    made.set("step_rate", 1000)
    return made


class Views(unittest.TestCase):
    def test_fragments_have_the_mass_and_speed_of_the_blocks(self):
        fragments = collapse().fragments()
        self.assertEqual(len(fragments), 6)
        np.testing.assert_allclose(fragments.mass, 2000.0, rtol=1e-12)
        np.testing.assert_allclose(fragments.velocity[:, :2], 0.0, atol=1e-9)
        np.testing.assert_allclose(fragments.inertia[0], np.eye(3) * 2000.0 / 6, rtol=1e-9, atol=1e-6)

    def test_arrays_are_views_that_keep_their_owner(self):
        fragments = collapse().fragments()
        first, again = fragments.mass, fragments.mass
        self.assertFalse(first.flags.owndata)
        self.assertFalse(first.flags.writeable)
        self.assertEqual(first.__array_interface__["data"], again.__array_interface__["data"])
        self.assertGreater(first.strides[0], 8)
        with self.assertRaises(ValueError):
            first[0] = 1.0
        centres = fragments.centre
        kept = centres.copy()
        del fragments, first, again
        gc.collect()
        rubble.from_arrays(*blocks(200)).fragments()
        np.testing.assert_array_equal(centres, kept)

    def test_states_are_what_was_given(self):
        times, positions, elements, active = blocks()
        fe = collapse().fe
        np.testing.assert_array_equal(fe.times, times)
        np.testing.assert_array_equal(fe.state(3).positions, positions[3])
        np.testing.assert_array_equal(fe.active(2), active[2])
        np.testing.assert_array_equal(fe.corners.reshape(-1, 8), elements)
        self.assertEqual(len(fe), 6)

    def test_units_are_converted_once(self):
        times, positions, elements, active = blocks()
        in_mm = rubble.from_arrays(times, positions * 1000.0, elements, active, density=2e-9, units="t-mm-s")
        np.testing.assert_allclose(in_mm.fragments().mass, 2000.0, rtol=1e-9)


class Runs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()

    def path(self, name):
        return os.path.join(self.folder, name)

    def test_a_run_is_read_back_as_it_was_recorded(self):
        made = collapse()
        run = made.run(self.path("a.run.h5"))
        self.assertTrue(run.complete)
        again = rubble.open_run(self.path("a.run.h5"))
        self.assertEqual(run.trajectory_hash, again.trajectory_hash)
        self.assertEqual(run.trajectory_hash, collapse().run(self.path("b.run.h5")).trajectory_hash)
        frame = again.frame(-1)
        self.assertEqual(frame.positions.dtype, np.float32)
        self.assertEqual(frame.positions.shape, (len(frame), 3))
        np.testing.assert_allclose(np.linalg.norm(frame.orientations, axis=1), 1.0, atol=1e-5)
        final = again.final_positions
        np.testing.assert_allclose(again.places(again.times[-1]), final, atol=1e-3)
        self.assertTrue(np.all(final[:, 2] < 6.0))
        self.assertTrue(np.isnan(again.places(0.0)).all(), "nothing is born yet")
        debris = run.debris_map(cell=0.5)
        # Frames hold places in single precision.
        total = np.nansum(debris.raster("mass")) * debris.cell**2
        self.assertAlmostEqual(total, 12000.0, places=3)
        self.assertAlmostEqual(np.nansum(debris.values("mass")) * 0.25, total, places=6)
        self.assertEqual(debris.raster("mass").shape[1], round((debris.bounds[2] - debris.bounds[0]) / 0.5))
        for kind, name in (("fragments", "f.csv"), ("gltf", "f.glb"), ("bodies", "f.xdmf"), ("series", "s.pvd"), ("vtkhdf", "s.vtkhdf")):
            run.export(kind, self.path(name))
            self.assertGreater(os.path.getsize(self.path(name)), 100)
        debris.save(self.path("m.tif"))

    def test_the_command_line_and_python_agree_bit_by_bit(self):
        sample = os.path.join(os.environ["RUBBLE_SOURCE_DIR"], "resources/samples/rc-arch.exo")
        words = ["size", sample, "--json", "--set", "fps_target=30"]
        told = json.loads(subprocess.run([os.environ["RUBBLE_CLI"], *words], capture_output=True, check=True).stdout)
        opened = rubble.open(sample, settings={"fps_target": 30})
        sizing = opened.size()
        self.assertEqual(sizing.clusters, told["clusters"])
        self.assertEqual(list(sizing.grid), [told["grid"][axis] for axis in "lwh"])
        beside = [row for row in told["warnings"] if row["id"] == "sizing.loose_beside"]
        self.assertEqual(len(beside), 1, "the bodies allowed are fragments alone")
        self.assertIn(beside[0], opened.findings)
        opened.set("loose_structure", "fe")
        opened.size()
        self.assertNotIn(beside[0], opened.findings)
        opened.set("loose_structure", "at_once")
        self.assertEqual(opened.inspect()["dead"], len(opened.fragments()))
        self.assertEqual(len(opened.cluster().of), told["fragments"])

    def write_case(self, fe_input="fe-1"):
        """A case whose debris falls on a house that stands on a level terrain."""
        samples = os.path.join(os.environ["RUBBLE_SOURCE_DIR"], "resources/samples")
        with open(self.path("level.asc"), "w") as file:
            file.write("ncols 160\nnrows 160\nxllcorner -80\nyllcorner -80\ncellsize 1\n")
            file.write((" ".join(["-1.5"] * 160) + "\n") * 160)
        with open(self.path("house.obj"), "w") as file:
            file.write("v -40 -40 1\nv 60 -40 1\nv 60 40 1\nv -40 40 1\nf 1 2 3\nf 1 3 4\n")
        with open(os.path.join(samples, "river-arch.rubble")) as file:
            case = json.load(file)
        case["inputs"] = [
            {"id": "fe-1", "role": "fe", "path": os.path.join(samples, "rc-arch.exo"), "sha256": ""},
            {"id": "terrain-1", "role": "terrain", "path": "level.asc", "sha256": ""},
            {"id": "surroundings-1", "role": "surroundings", "path": "house.obj", "sha256": ""},
        ]
        plain = case["scenarios"][0]
        plain["fe_input"] = fe_input
        plain["settings"] = {"multiple": 8, "settle_time": 0}
        case["scenarios"].append(dict(plain, id="scenario-2", name="low ground", settings=dict(plain["settings"], ground_height=-3.0)))
        case["site"] = {"control_points": [], "height_shift_m": 0.0, "collide_with_surroundings": True}
        with open(self.path("arch.rubble"), "w") as file:
            json.dump(case, file)
        return self.path("arch.rubble")

    def command_line(self, *words):
        told = subprocess.run([os.environ["RUBBLE_CLI"], *words, "--json"], capture_output=True, check=False)
        self.assertEqual(told.returncode, 0, told.stderr)
        return json.loads(told.stdout)

    def test_debris_falls_on_the_same_surroundings_as_from_the_command_line(self):
        case = self.write_case()
        with open(self.path("lower.asc"), "w") as file:
            file.write("ncols 160\nnrows 160\nxllcorner -80\nyllcorner -80\ncellsize 1\n")
            file.write((" ".join(["-2.5"] * 160) + "\n") * 160)
        for terrain in (None, self.path("lower.asc")):
            words = [] if terrain is None else ["--terrain", terrain]
            told = self.command_line("run", case, "--out", self.path("told.run.h5"), *words)
            there = rubble.open_run(self.path("told.run.h5"))
            run = rubble.open(case, terrain=terrain).run(self.path("made.run.h5"))
            self.assertEqual(run.fingerprint, there.fingerprint)
            self.assertEqual(run.trajectory_hash, told["trajectory_hash"])

    def test_a_scenario_is_named_by_id_or_name_and_needs_no_fe_input(self):
        case = self.write_case(fe_input="")
        for wanted, ground in ((None, 0.0), ("scenario-2", -3.0), ("low ground", -3.0)):
            opened = rubble.open(case, scenario=wanted)
            self.assertEqual(opened.get("ground_height"), ground)
            self.assertEqual(os.path.basename(opened.fe.path), "rc-arch.exo")
        with self.assertRaises(rubble.UsageError) as caught:
            rubble.open(case, scenario="none of these")
        self.assertEqual(caught.exception.id, "case.no_scenario")
        self.assertIn("scenario-2 (low ground)", caught.exception.remedy)

    def test_progress_is_told_and_false_cancels(self):
        told = []
        with self.assertRaises(rubble.Cancelled):
            endless().run(self.path("c.run.h5"), progress=lambda stage, share: told.append((stage, share)) or False)
        self.assertTrue(told)
        self.assertTrue(all(isinstance(stage, str) and 0.0 <= share <= 1.0 for stage, share in told))

    def test_what_the_callback_raises_comes_out(self):
        def fail(stage, share):
            raise KeyError("mine")

        with self.assertRaises(KeyError):
            endless().run(self.path("d.run.h5"), progress=fail)

    def test_ctrl_c_stops_a_run_and_keeps_what_there_is(self):
        timer = threading.Timer(1.5, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            endless().run(self.path("e.run.h5"))
        timer.join()
        self.assertFalse(rubble.open_run(self.path("e.run.h5")).complete)

    def test_an_incomplete_run_says_so(self):
        with self.assertRaises(rubble.Cancelled):
            endless().run(self.path("f.run.h5"), progress=lambda stage, share: not stage.lower().startswith("simul"))
        with self.assertRaises(rubble.UsageError) as caught:
            rubble.open_run(self.path("f.run.h5")).final_positions
        self.assertEqual(caught.exception.id, "python.not_complete")


class Drops(unittest.TestCase):
    def table(self, folder, rows):
        path = os.path.join(folder, "bodies.csv")
        with open(path, "w") as file:
            file.write("id,mass_kg,side_x_m,side_y_m,side_z_m,x_m,y_m,z_m,material\n" + rows)
        return path

    def test_bodies_come_to_rest_as_by_the_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = self.table(folder, "a,480,1,1,0.2,0,0,2.1,stone\nb,480,1,1,0.2,0,9,5.1,stone\n")
            made = rubble.drop(path, settings={"friction": 0.5})
            self.assertEqual(made.ids, ["a", "b"])
            self.assertEqual(made.endings, [["rest", "rest"]])
            self.assertEqual(made.final_positions.shape, (1, 2, 3))
            np.testing.assert_allclose(made.start_positions[0, :, 2], [2.1, 5.1])
            np.testing.assert_allclose(made.figure("fall_m")[0], [2.0, 5.0], atol=0.01)
            np.testing.assert_allclose(np.linalg.norm(made.final_orientations, axis=-1), 1.0, rtol=1e-9)
            self.assertEqual(len(made.cautions), 1, "it is a single run")
            out = subprocess.run([os.environ["RUBBLE_CLI"], "drop", path, "--set", "friction=0.5", "--json"], capture_output=True)
            told = json.loads(out.stdout)
            self.assertAlmostEqual(told["figures"]["fall_m"]["mean"], float(np.mean(made.figure("fall_m"))), places=12)

    def test_repeats_draw_anew(self):
        with tempfile.TemporaryDirectory() as folder:
            path = self.table(folder, "a,480,1,0.5,0.2,0,0,3,stone\n")
            made = rubble.drop(path, turn=True, repeats=3, vary={"restitution_level": "uniform:0:1"})
            self.assertEqual(made.figure("run_out_m").shape, (3, 1))
            self.assertEqual(len({drawn["restitution_level"] for drawn in made.drawn}), 3)
            self.assertEqual(made.cautions, [])
            again = rubble.drop(path, turn=True, repeats=3, vary={"restitution_level": "uniform:0:1"})
            np.testing.assert_array_equal(made.final_positions, again.final_positions)

    def test_what_cannot_be_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            path = self.table(folder, "a,480,1,1,0.2,0,0,-1,stone\n")
            with self.assertRaisesRegex(rubble.ParseError, "below the surface"):
                rubble.drop(path)
            with self.assertRaises(rubble.UsageError):
                rubble.drop(self.table(folder, "a,480,1,1,0.2,0,0,1,stone\n"), repeats=0)
            with self.assertRaisesRegex(rubble.UsageError, "no figure"):
                rubble.drop(self.table(folder, "a,480,1,1,0.2,0,0,1,stone\n")).figure("height")


class Refusals(unittest.TestCase):
    def refused(self, identity, *words, call):
        with self.assertRaises(rubble.UsageError) as caught:
            call()
        self.assertEqual(caught.exception.id, identity)
        self.assertTrue(caught.exception.remedy)
        for word in words:
            self.assertIn(word, str(caught.exception))
        self.assertIsInstance(caught.exception, ValueError)
        self.assertIsInstance(caught.exception, rubble.Error)

    def test_wrong_arrays(self):
        times, positions, elements, active = blocks()
        make = rubble.from_arrays
        self.refused("python.shape", "positions", "(6, any, 3)", call=lambda: make(times, positions[:, :, :2], elements, active))
        self.refused("python.shape", "active", call=lambda: make(times, positions, elements, active[:-1]))
        self.refused("python.dtype", "active", "bool", call=lambda: make(times, positions, elements, active.astype(int)))
        self.refused("python.dtype", "elements", call=lambda: make(times, positions, elements.astype(float), active))
        self.refused("python.dtype", "positions", call=lambda: make(times, positions.astype(complex), elements, active))
        self.refused("python.dtype", "times", call=lambda: make("now", positions, elements, active))
        self.refused("python.shape", "7", call=lambda: make(times, positions, elements[:, :7], active))
        self.refused("python.value", "node 99", call=lambda: make(times, positions, np.full((6, 8), 99), active))
        self.refused("python.value", "times", call=lambda: make(times[::-1].copy(), positions, elements, active))
        self.refused("python.value", "units", "t-mm-s", call=lambda: make(times, positions, elements, active, units="feet"))
        self.refused("python.value", "density", call=lambda: make(times, positions, elements, active, density=-1.0))
        self.refused("python.value", "density", "units", call=lambda: make(times, positions, elements, active, density=2e12))
        self.refused("python.shape", "density", call=lambda: make(times, positions, elements, active, density=np.ones(5)))
        hole = positions.copy()
        hole[0, 3] = np.nan
        self.refused("python.value", "node 3", call=lambda: make(times, hole, elements, active))

    def test_wrong_settings(self):
        made = collapse()
        before = made.get("ground_height")
        self.refused("parameter.unit", "ft", "m", call=lambda: made.set("ground_height", "2 ft"))
        self.refused("python.setting", call=lambda: made.set("ground_height", np.zeros(3)))
        self.refused("python.import_setting", call=lambda: made.set("units", "t-mm-s"))
        with self.assertRaises(rubble.UsageError):
            made.set("no_such_parameter", 1)
        with self.assertRaises(rubble.UsageError):
            made.set("friction", -1)
        self.assertEqual(made.get("ground_height"), before)
        made.set("ground_height", "2 m")
        self.assertEqual(made.get("ground_height"), 2.0)

    def test_wrong_files(self):
        with self.assertRaises(rubble.WorldError) as caught:
            rubble.open("/no/such/file.exo")
        self.assertIn("/no/such/file.exo", str(caught.exception))
        path = os.path.join(tempfile.mkdtemp(), "text.run.h5")
        with open(path, "w") as file:
            file.write("no run")
        with self.assertRaises(rubble.ParseError):
            rubble.open_run(path)
        sample = os.path.join(os.environ["RUBBLE_SOURCE_DIR"], "resources/samples/rc-arch.exo")
        self.refused("case.no_case", "rc-arch.exo", call=lambda: rubble.open(sample, scenario="a"))
        self.refused("python.out_not_a_run", call=lambda: collapse().run(path))

    def test_wrong_places_in_a_run(self):
        run = collapse().run(os.path.join(tempfile.mkdtemp(), "a.run.h5"))
        with self.assertRaises(IndexError):
            run.frame(len(run))
        self.refused("python.time", call=lambda: run.at(float("nan")))
        self.refused("python.kind", "gltf", call=lambda: run.export("obj", "x.obj"))
        self.refused("python.layer", "mass", call=lambda: run.debris_map(cell=1.0).raster("gold"))
        self.refused("python.state", call=lambda: collapse().fe.active(6))


class Documentation(unittest.TestCase):
    def test_everything_has_a_docstring(self):
        for name in rubble.__all__:
            thing = getattr(rubble, name)
            self.assertTrue(thing.__doc__, name)
            if isinstance(thing, type):
                for member, value in vars(thing).items():
                    if not member.startswith("_") and member not in ("id", "what", "remedy"):
                        self.assertTrue(value.__doc__, f"{name}.{member}")
                        self.assertTrue(re.search(r"[a-z]", value.__doc__))

    def test_parameters_are_those_of_the_table(self):
        rows = {row["key"]: row for row in rubble.parameters()}
        self.assertGreater(len(rows), 30)
        self.assertEqual(rows["gravity"]["unit"], "m/s2")
        self.assertEqual(collapse().get("gravity"), rows["gravity"]["default"])


if __name__ == "__main__":
    unittest.main()
