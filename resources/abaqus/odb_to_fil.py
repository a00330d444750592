"""Writes what Rubble needs of an Abaqus output database (.odb) as a results file (.fil) and an input deck (.inp).

For those who have an Abaqus licence; run it with Abaqus' own Python:

    abaqus python odb_to_fil.py JOB.odb [OUT]

It writes OUT.fil (default: JOB-rubble.fil): nodes, elements, a set for each section, and for every frame the displacement U, the velocity V
where there is one, and STATUS (1 active, 0 deleted); and OUT.inp: those sets with their sections, thicknesses, areas and densities.
Then open OUT.fil in Rubble.

STATUS must have been asked for in the analysis (*ELEMENT OUTPUT, STATUS in a *OUTPUT, FIELD request). Numbers of an assembly of several
instances are made unique: every instance after the first starts at the next full million. Times are total times: the start of the
step plus the time in it; a first frame that repeats the end of the step before is left out.
"""

from __future__ import print_function

import math
import sys

LINE = 80
OFFSET = 1000000


def integer(value):
    digits = str(int(value))
    return "I%2d%s" % (len(digits), digits)


def real(value):
    return "D" + ("%22.15E" % float(value)).replace("E", "D")


def text(value):
    return "A" + "%-8.8s" % value


class ResultsFile(object):
    """Records of an ASCII results file, in lines of 80 columns."""

    def __init__(self, path):
        self.file = open(path, "w")
        self.rest = ""

    def record(self, key, items):
        self.rest += "*" + integer(len(items) + 2) + integer(key) + "".join(items)
        while len(self.rest) >= LINE:
            self.file.write(self.rest[:LINE] + "\n")
            self.rest = self.rest[LINE:]

    def fill_line(self):
        if self.rest:
            self.file.write(self.rest.ljust(LINE) + "\n")
            self.rest = ""

    def close(self):
        self.fill_line()
        self.file.close()


class Numbering(object):
    """Numbers that are unique over all instances."""

    def __init__(self, instances):
        largest = max([OFFSET - 1] + [max([n.label for n in i.nodes] + [e.label for e in i.elements]) for i in instances])
        self.step = (largest // OFFSET + 1) * OFFSET
        self.first = dict((instance.name, k * self.step) for k, instance in enumerate(instances))

    def number(self, instance, label):
        return self.first[instance] + label


def write_model(out, instances, numbering):
    nodes = sum(len(i.nodes) for i in instances)
    elements = sum(len(i.elements) for i in instances)
    out.record(1921, [text("odb"), text(""), text(""), text(""), integer(elements), integer(nodes), real(1.0)])
    for instance in instances:
        for element in instance.elements:
            numbers = [integer(numbering.number(instance.name, n)) for n in element.connectivity]
            head = [integer(numbering.number(instance.name, element.label)), text(element.type)]
            out.record(1900, head + numbers[:14])
            for start in range(14, len(numbers), 14):
                out.record(1990, numbers[start:start + 14])
    for instance in instances:
        for node in instance.nodes:
            out.record(1901, [integer(numbering.number(instance.name, node.label))] + [real(x) for x in node.coordinates])


def section_sets(instances, numbering):
    """Element numbers by section name, in the order in which sections are met."""
    order, members = [], {}
    for instance in instances:
        for assignment in instance.sectionAssignments:
            name = assignment.sectionName
            if name not in members:
                order.append(name)
                members[name] = set()
            members[name].update(numbering.number(instance.name, e.label) for e in assignment.region.elements)
    return [(name, sorted(members[name])) for name in order]


def write_sets(out, sets):
    for k, (name, members) in enumerate(sets):
        for start in range(0, len(members), 15):
            items = [integer(n) for n in members[start:start + 15]]
            out.record(1933 if start == 0 else 1934, ([integer(k + 1)] if start == 0 else []) + items)
    for k, (name, members) in enumerate(sets):
        label = name.upper()
        out.record(1940, [integer(k + 1)] + [text(label[i:i + 8]) for i in range(0, len(label), 8)])


def area_of(odb, section):
    """Area of a truss or of a beam whose profile says it; None for solids and for other profiles."""
    area = getattr(section, "area", None)
    if area is not None or getattr(section, "profile", None) is None:
        return area
    profile = odb.profiles[section.profile]
    kind = type(profile).__name__
    if kind == "RectangularProfile":
        return profile.a * profile.b
    if kind == "CircularProfile":
        return math.pi * profile.r ** 2
    if kind == "PipeProfile":
        return math.pi * (profile.r ** 2 - (profile.r - profile.t) ** 2)
    if kind == "IProfile":
        return profile.b1 * profile.t1 + profile.b2 * profile.t2 + (profile.h - profile.t1 - profile.t2) * profile.t3
    return getattr(profile, "area", None)


def write_deck(path, odb, sets):
    with open(path, "w") as deck:
        deck.write("** Sections and densities of %s\n" % odb.name)
        used = []
        for name, members in sets:
            deck.write("*ELSET, ELSET=%s\n" % name)
            for start in range(0, len(members), 12):
                deck.write(", ".join(str(n) for n in members[start:start + 12]) + "\n")
            section = odb.sections[name]
            material = getattr(section, "material", "")
            shell = "Shell" in type(section).__name__
            size = getattr(section, "thickness", None) if shell else area_of(odb, section)
            deck.write("*%s SECTION, ELSET=%s, MATERIAL=%s\n" % ("SHELL" if shell else "SOLID", name, material))
            deck.write("%.9g,\n" % size if size else ",\n")
            if material and material not in used:
                used.append(material)
        for material in used:
            density = getattr(odb.materials[material], "density", None)
            if density is not None:
                deck.write("*MATERIAL, NAME=%s\n*DENSITY\n%.9g,\n" % (material, density.table[0][0]))


def write_nodal(out, field, key, numbering):
    for block in field.bulkDataBlocks:
        for label, values in zip(block.nodeLabels, block.data):
            out.record(key, [integer(numbering.number(block.instance.name, label))] + [real(x) for x in values])


def write_status(out, field, numbering):
    for block in field.bulkDataBlocks:
        points = block.integrationPoints if block.integrationPoints is not None else [1] * len(block.elementLabels)
        for label, point, values in zip(block.elementLabels, points, block.data):
            number = numbering.number(block.instance.name, label)
            out.record(1, [integer(number), integer(point), integer(1), integer(0), text(""), integer(3), integer(3), integer(3), integer(0)])
            out.record(61, [real(values[0])])


def write_frame(out, frame, time, step, increment, numbering):
    head = [real(time), real(frame.frameValue), real(0.0), real(0.0), integer(17), integer(step), integer(increment), integer(0), real(0.0),
            real(0.0), real(0.0)]
    out.fill_line()
    out.record(2000, head + [text("")] * 10)
    fields = frame.fieldOutputs
    if "STATUS" in fields.keys():
        write_status(out, fields["STATUS"], numbering)
    for name, key in (("U", 101), ("V", 102)):
        if name in fields.keys():
            write_nodal(out, fields[name], key, numbering)
    out.record(2001, [])
    out.fill_line()


def convert(odb, out_name):
    instances = [i for i in odb.rootAssembly.instances.values() if len(i.elements) > 0]
    numbering = Numbering(instances)
    sets = section_sets(instances, numbering)
    out = ResultsFile(out_name + ".fil")
    write_model(out, instances, numbering)
    write_sets(out, sets)
    last, without = None, 0
    for number, step in enumerate(odb.steps.values()):
        for frame in step.frames:
            time = step.totalTime + frame.frameValue
            if last is not None and time <= last:
                continue
            last = time
            without += 0 if "STATUS" in frame.fieldOutputs.keys() else 1
            write_frame(out, frame, time, number + 1, frame.incrementNumber, numbering)
    out.close()
    write_deck(out_name + ".inp", odb, sets)
    if without:
        print("%d frames have no STATUS: their elements count as they were at the frame before" % without)


def main():
    if len(sys.argv) < 2:
        print(__doc__)
        return 2
    from odbAccess import openOdb
    odb = openOdb(sys.argv[1], readOnly=True)
    base = sys.argv[1][:-4] if sys.argv[1].endswith(".odb") else sys.argv[1]
    convert(odb, sys.argv[2] if len(sys.argv) > 2 else base + "-rubble")
    odb.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
