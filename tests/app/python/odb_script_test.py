"""The script for output databases of Abaqus: what it writes of one that stands in for a database opens as what that one holds."""

import importlib.util
import os
import tempfile
import unittest
from types import SimpleNamespace as Made

import numpy as np

import rubble

SCRIPT = os.path.join(os.environ["RUBBLE_SOURCE_DIR"], "resources/abaqus/odb_to_fil.py")
DENSITY = {"STONE": 2400.0, "STEEL": 7850.0}


class HomogeneousSolidSection(Made):
    pass


class HomogeneousShellSection(Made):
    pass


class TrussSection(Made):
    pass


class BeamSection(Made):
    pass


class RectangularProfile(Made):
    pass


def instance(name, nodes, elements, section):
    made = Made(name=name)
    made.nodes = [Made(label=k + 1, coordinates=place) for k, place in enumerate(nodes)]
    made.elements = [Made(label=k + 1, type=kind, connectivity=corners) for k, (kind, corners) in enumerate(elements)]
    groups = {}
    for element, name_of in zip(made.elements, section):
        groups.setdefault(name_of, []).append(element)
    made.sectionAssignments = [Made(sectionName=k, region=Made(elements=v)) for k, v in groups.items()]
    return made


def database():
    """A wall of two bricks, a roof of a shell, a truss and a beam; the second brick dies in the second step, the shell after it."""
    wall = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1, 2)]
    bricks = [("C3D8R", (1, 2, 5, 4, 7, 8, 11, 10)), ("C3D8R", (2, 3, 6, 5, 8, 9, 12, 11))]
    roof = [(10, 0, 3), (12, 0, 3), (12, 2, 3), (10, 2, 3)]
    members = [("S4R", (1, 2, 3, 4)), ("T3D2", (1, 3)), ("B31", (2, 4))]
    instances = [instance("WALL-1", wall, bricks, ["masonry", "masonry"]),
                 instance("ROOF-1", roof, members, ["slab", "tie", "beam"])]
    labels = [(one, [n.label for n in one.nodes], [e.label for e in one.elements]) for one in instances]
    dead = {("WALL-1", 2): 2, ("ROOF-1", 1): 3}  # first frame without the element, counted over both steps

    def frame(count, value):
        shift = [Made(instance=one, nodeLabels=nodes, data=np.array([[0.5 * count, 0.0, -0.25 * count]] * len(nodes)))
                 for one, nodes, _ in labels]
        status = [Made(instance=one, elementLabels=elements, integrationPoints=None,
                       data=[[0.0 if count >= dead.get((one.name, e), 99) else 1.0] for e in elements]) for one, _, elements in labels]
        return Made(frameValue=value, incrementNumber=count,
                    fieldOutputs={"U": Made(bulkDataBlocks=shift), "STATUS": Made(bulkDataBlocks=status)})

    steps = {"gravity": Made(totalTime=0.0, frames=[frame(0, 0.0), frame(1, 0.1)]),
             "collapse": Made(totalTime=0.1, frames=[frame(1, 0.0), frame(2, 0.1), frame(3, 0.2)])}
    sections = {"masonry": HomogeneousSolidSection(material="STONE"), "slab": HomogeneousShellSection(material="STONE", thickness=0.3),
                "tie": TrussSection(material="STEEL", area=0.01), "beam": BeamSection(material="STEEL", profile="bar")}
    return Made(name="made.odb", rootAssembly=Made(instances={one.name: one for one in instances}), steps=steps, sections=sections,
                profiles={"bar": RectangularProfile(a=0.1, b=0.2)},
                materials={name: Made(density=Made(table=[(value,)])) for name, value in DENSITY.items()})


class OutputDatabase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        spec = importlib.util.spec_from_file_location("odb_to_fil", SCRIPT)
        script = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(script)
        out = os.path.join(tempfile.mkdtemp(), "made-rubble")
        script.convert(database(), out)
        cls.collapse = rubble.open(out + ".fil")
        cls.fe = cls.collapse.fe

    def test_steps_make_one_history(self):
        np.testing.assert_allclose(self.fe.times, [0.0, 0.1, 0.2, 0.3], rtol=1e-12)

    def test_instances_keep_numbers_of_their_own(self):
        self.assertEqual(list(self.fe.element_ids), [1, 2, 1000001, 1000002, 1000003])
        self.assertEqual(len(self.fe.nodes), 16)
        self.assertEqual(list(self.fe.node_ids[-4:]), [1000001, 1000002, 1000003, 1000004])

    def test_deaths_are_those_of_the_status(self):
        alive = np.array([self.fe.active(k) for k in range(4)])
        np.testing.assert_array_equal(alive[:, 1], [True, True, False, False])
        np.testing.assert_array_equal(alive[:, 2], [True, True, True, False])
        self.assertTrue(alive[:, [0, 3, 4]].all())

    def test_nodes_are_where_the_displacement_brings_them(self):
        np.testing.assert_allclose(self.fe.state(3).positions - self.fe.nodes, np.tile([1.5, 0.0, -0.75], (16, 1)), atol=1e-12)

    def test_sections_give_parts_and_densities(self):
        names = [self.fe.parts[p] for p in self.fe.part]
        self.assertEqual([name.lower() for name in names], ["masonry", "masonry", "slab", "tie", "beam"])
        np.testing.assert_allclose(self.fe.density, [2400, 2400, 2400, 7850, 7850])

    def test_masses_are_volume_times_density(self):
        fragments = self.collapse.fragments()
        np.testing.assert_allclose(sorted(fragments.mass), [2400.0, 2400.0 * 4 * 0.3], rtol=1e-12)

    def test_areas_of_trusses_and_beams(self):
        with open(self.fe.path[:-4] + ".inp") as deck:
            lines = deck.read().split("\n")
        sizes = {line.split("ELSET=")[1].split(",")[0]: lines[k + 1] for k, line in enumerate(lines) if " SECTION" in line}
        self.assertEqual(sizes, {"masonry": ",", "slab": "0.3,", "tie": "0.01,", "beam": "0.02,"})


if __name__ == "__main__":
    unittest.main()
