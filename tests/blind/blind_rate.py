#!/usr/bin/env python3
"""Blind rate of rubble-cli compare: how often it names the cause of collapses that are known to this program alone.

Each collapse has one of the causes, in turn, and friction, births and a seed that are drawn and that no member has. A survey is
taken of its debris, with noise and with patches that nobody surveyed; the comparison finds the level of detection by itself.
With --time a witness says when debris first lay at a place, to half a second; of a place that none reached nobody says anything.
Causes are then compared twice: all of them, and without the true one. Tells a table and, with --json, every collapse.

    tests/blind/blind_rate.py RUBBLE_CLI CAUSE CAUSE... [--collapses N] [--members N] [--noise M] [--time X,Y[,RADIUS]]
                              [--set KEY=VALUE] [--cache FOLDER]

Right, wrong and undecided are counted where no cause was refused; a collapse is missed where all causes are.
"""

import argparse
import csv
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

CELL = 1.0     # m
MARGIN = 10.0  # m, of the survey around the debris
PATCHES = 4    # that were not surveyed
PATCH = 4      # cells, side of one
ACCURACY = 0.5  # s, of a time that a witness gives
VARIED = ["--vary", "friction=uniform:0.4:0.8", "--vary", "birth_shift=uniform:0:0.1"]


def told(words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}\n{done.stderr}")
    return done.stdout


def settings_of(options):
    return [word for each in options.set for word in ("--set", each)]


def hidden(options, cause, number, folder):
    """What was drawn for a collapse, its heights of debris and fallen structure by cells, m, and its times at the places, s."""
    table = folder / "heights.csv"
    reached = [word for each in options.time for word in ("--reached", each)]
    made = json.loads(told([options.cli, "ensemble", cause, "--members", 1, "--seed", 1000 + number, *VARIED, *settings_of(options),
                            *reached, "--cell", CELL, "--cache", options.cache, "--out", table, "--json"]))
    heights = {}
    with open(table, newline="", encoding="utf-8") as rows:
        for row in csv.DictReader(rows):
            heights[float(row["x_m"]), float(row["y_m"])] = float(row["height_p50_m"] or 0)
    return made["list"][0]["drawn"], heights, [place["members_s"][0] for place in made["reached"]]


def write_survey(options, heights, chance, path):
    """An ESRI grid with noise."""
    (x0, x1), (y0, y1) = [(min(c) - MARGIN, max(c) + MARGIN) for c in zip(*heights)]
    columns, rows = round((x1 - x0) / CELL) + 1, round((y1 - y0) / CELL) + 1
    holes = [(chance.randrange(columns), chance.randrange(rows)) for _ in range(PATCHES)]
    with open(path, "w", encoding="ascii") as out:
        out.write(f"ncols {columns}\nnrows {rows}\nxllcorner {x0 - CELL / 2}\nyllcorner {y0 - CELL / 2}\n"
                  f"cellsize {CELL}\nNODATA_value -9999\n")
        for j in range(rows - 1, -1, -1):
            line = []
            for i in range(columns):
                height = heights.get((x0 + i * CELL, y0 + j * CELL), 0.0) + chance.gauss(0.0, options.noise)
                hidden = any(0 <= i - a < PATCH and 0 <= j - b < PATCH for a, b in holes)
                line.append("-9999" if hidden else f"{height:.3f}")
            out.write(" ".join(line) + "\n")


def compared(options, causes, evidence):
    return json.loads(told([
        options.cli, "compare", *causes, "--members", options.members, *VARIED, *settings_of(options), "--cell", CELL,
        "--cache", options.cache, *[word for each in evidence for word in ("--against", each)], "--json"]))


def blind(options, number, folder):
    chance = random.Random(1000 + number)
    truth = options.causes[number % len(options.causes)]
    drawn, heights, times = hidden(options, truth, number, folder)
    survey = folder / "survey.asc"
    write_survey(options, heights, chance, survey)
    evidence = [f"height={survey}"]
    for place, time in zip(options.time, times):
        if time is not None:
            x, y, radius = (place.split(",") + ["5"])[:3]
            said = max(0.0, time + chance.uniform(-ACCURACY, ACCURACY))
            evidence.append(f"time={said:.2f},{x},{y},{radius},{ACCURACY}")
    found = compared(options, options.causes, evidence)
    none = compared(options, [each for each in options.causes if each != truth], evidence)
    answer = "missed" if found["unexplained"] else "undecided"
    if found["told_apart"] and not found["unexplained"]:
        answer = "right" if found["closest"] == truth.stem else "wrong"
    return {"truth": truth.stem, **drawn, "times": times, "answer": answer, "closest": found["closest"], "fit": found["fit"],
            "noticed": none["unexplained"], "fit_without": none["fit"], "named_without": none["told_apart"] and not none["unexplained"]}


def share(part, whole):
    """With the score interval of Wilson (1927), 95 %."""
    if whole == 0:
        return "-"
    z, p = 1.959964, part / whole
    middle = (p + z * z / (2 * whole)) / (1 + z * z / whole)
    half = z / (1 + z * z / whole) * math.sqrt(p * (1 - p) / whole + z * z / (4 * whole * whole))
    return f"{100 * p:.0f} % ({100 * (middle - half):.0f} to {100 * (middle + half):.0f})"


def tell(collapses):
    print("| cause | collapses | right | wrong | undecided | missed | noticed if left out |\n|---|---|---|---|---|---|---|")
    names = list(dict.fromkeys(each["truth"] for each in collapses))
    for name in [*names, "all"]:
        own = [each for each in collapses if name in (each["truth"], "all")]
        counts = [sum(each["answer"] == answer for each in own) for answer in ("right", "wrong", "undecided", "missed")]
        print(f"| {name} | {len(own)} | {' | '.join(map(str, counts))} | {sum(each['noticed'] for each in own)} |")
    answered = [each for each in collapses if each["answer"] in ("right", "wrong")]
    print(f"\nRight when it answers: {share(sum(e['answer'] == 'right' for e in answered), len(answered))}")
    print(f"Sure and wrong: {share(sum(e['answer'] == 'wrong' for e in collapses), len(collapses))}")
    print(f"None of these, where the true cause was left out: {share(sum(e['noticed'] for e in collapses), len(collapses))}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cli", type=pathlib.Path, metavar="RUBBLE_CLI")
    parser.add_argument("causes", type=pathlib.Path, nargs="+", metavar="CAUSE")
    parser.add_argument("--collapses", type=int, default=40)
    parser.add_argument("--members", type=int, default=10)
    parser.add_argument("--noise", type=float, default=0.1, help="standard deviation of a surveyed height, m")
    parser.add_argument("--time", action="append", default=[], metavar="X,Y[,RADIUS]", help="a witness tells when debris came there")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    parser.add_argument("--cache", type=pathlib.Path, default=pathlib.Path("blind-cache"))
    parser.add_argument("--json", type=pathlib.Path)
    options = parser.parse_args()
    if len(options.causes) < 3:
        parser.error("with one cause left out two are to be compared: name three or more")
    collapses = []
    with tempfile.TemporaryDirectory() as folder:
        for number in range(options.collapses):
            collapses.append(blind(options, number, pathlib.Path(folder)))
            print(number + 1, collapses[-1], file=sys.stderr, flush=True)
            if options.json:
                options.json.write_text(json.dumps(collapses, indent=1), encoding="utf-8")
    tell(collapses)


if __name__ == "__main__":
    main()
