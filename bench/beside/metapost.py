#!/usr/bin/python3
"""As many lines and labels as a sheet has, by MetaPost beside `epure draw`: the processor time of each.

    python3 bench/beside/metapost.py velocity-centre/velocities [build/bin/epure]

Needs texlive-metapost. Every path of the sheet's SVG becomes a `draw` or a `fill` of MetaPost with the same points, and
every text a label in cmr10 without TeX, which is MetaPost's cheapest: it places no label, computes no
point, and writes EPS alone; epure solves the mechanism, places its labels and writes PDF and SVG, with its fonts in them.
"""
import re
import resource
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as tree
from pathlib import Path

SVG = "{http://www.w3.org/2000/svg}"
RUNS = 20


def pair(x, y):
    return f"({x / 726:.3f},{-y / 726:.3f})"  # 725.67 units of the file are a millimetre; here about a point


def paths_of(d):
    """The path's pieces in MetaPost's words. The sheets' paths have M, and relative c, h, l, v, z."""
    x = y = 0.0
    pieces, now = [], ""
    for letter, numbers in re.findall(r"([MChlvcz])([^MChlvcz]*)", d):
        values = [float(n) for n in re.findall(r"-?\d*\.?\d+", numbers)]
        if letter == "M":
            if now:
                pieces.append(now)
            x, y = values[0], values[1]
            now = pair(x, y)
            values = values[2:]
        elif letter == "z":
            now += "--cycle"
        elif letter in "hv":
            for value in values:
                x, y = (x + value, y) if letter == "h" else (x, y + value)
                now += "--" + pair(x, y)
        elif letter == "c":
            for i in range(0, len(values) - 5, 6):
                dx = values[i : i + 6]
                now += f"..controls {pair(x + dx[0], y + dx[1])} and {pair(x + dx[2], y + dx[3])}.."
                x, y = x + dx[4], y + dx[5]
                now += pair(x, y)
        if letter in "lM":
            for i in range(0, len(values) - 1, 2):
                x, y = x + values[i], y + values[i + 1]
                now += "--" + pair(x, y)
    return pieces + [now]


def metapost(svg):
    """The picture in MetaPost, the count of its paths and of its labels."""
    lines, paths, labels = ['outputtemplate := "%j.eps";', "beginfig(1);", 'defaultfont := "cmr10";'], 0, 0
    root = tree.parse(svg).getroot()
    parents = {child: parent for parent in root.iter() for child in parent}
    definitions = set(root.find(f"{SVG}defs").iter())

    def inherited(element, attribute):
        while element is not None:
            if attribute in element.attrib:
                return element.get(attribute)
            element = parents.get(element)
        return "none"

    for element in root.iter():
        if element in definitions:
            continue
        if element.tag == f"{SVG}path":
            for piece in paths_of(element.get("d")):
                fills = inherited(element, "fill") != "none" and piece.endswith("cycle")
                lines.append(("fill " if fills else "draw ") + piece + ";")
                paths += 1
        elif element.tag == f"{SVG}text":
            text = "".join(element.itertext()).encode("ascii", "replace").decode().replace('"', "'")
            lines.append(f'label("{text}", ({labels % 10 * 60},{-(labels // 10) * 20}));')
            labels += 1
    return "\n".join(lines + ["endfig;", "end"]) + "\n", paths, labels


def processor_time(command, folder):
    """Seconds of one run, the mean of RUNS after one that warms the disk."""
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    for _ in range(RUNS):
        subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime) / RUNS


def main():
    sheet = sys.argv[1]
    epure = Path(sys.argv[2] if len(sys.argv) > 2 else "build/bin/epure").resolve()
    with tempfile.TemporaryDirectory() as folder:
        draw = [str(epure), "draw", sheet, "--out", folder]
        subprocess.run(draw, check=True, stdout=subprocess.DEVNULL)
        text, paths, labels = metapost(next(Path(folder).glob("*.svg")))
        (Path(folder) / "sheet.mp").write_text(text)
        ours = processor_time(draw, folder)
        theirs = processor_time(["mpost", "-interaction=batchmode", "sheet.mp"], folder)
        eps = (Path(folder) / "sheet.eps").stat().st_size
    print(f"{sheet}: {paths} paths, {labels} labels")
    print(f"epure, PDF and SVG: {1000 * ours:.1f} ms; MetaPost, EPS of {eps} bytes: {1000 * theirs:.1f} ms")


if __name__ == "__main__":
    main()
