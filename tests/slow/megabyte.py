"""Files of about a megabyte of every kind that epure reads, made to be as much work as such a file may be."""

import os
import random

SIZE = 1_000_000
SCENE = 64 << 10  # more is refused


def file(name, text):
    with open(name, "w", encoding="utf-8") as out:
        out.write(text[:SIZE] if len(text) > SIZE else text)
    assert os.path.getsize(name) <= SIZE
    return name


def filled(before, line, after="", most=SIZE):
    """As many lines as there is room for; `line` is asked for each by its number."""
    text, size, n = [before], len(before) + len(after), 0
    while size + len(line(n)) <= most:
        text.append(line(n))
        size += len(text[-1])
        n += 1
    return "".join(text) + after


HEAD = "epure: 1\nid: m\n"
LETTERS = [a + b for a in "CDEFGHIJKLM" for b in ("", "1x", "2x", "3x", "4x", "5x", "6x", "7x", "8x")]
MANY = 78  # of a list's 80


def four_bar(points="", frame="", before="", after="", length="0.35"):
    return (HEAD + before + f"links:\n  1: {{O: [0, 0], Q: [0.4, 0]{frame}}}\n  2: {{O A: 0.1}}\n"
            f"  3: {{A: [0, 0], B: [{length}, 0]{points}}}\n  4: {{Q B: 0.28}}\n"
            f"drive: {{link: 2, angle: 60 deg, speed: 10 rpm}}\nassembly: {{B: left of A Q}}\n{after}")


def chain(links):
    """Four-bars one after the other, as many as these links make."""
    bars = links // 2
    frame = ", ".join(f"O{i}: [{i}, 0]" for i in range(bars))
    text = HEAD + f"links:\n  1: {{{frame}}}\n  2: {{O0 A0: 0.2}}\n"
    sides = []
    for i in range(1, bars):
        text += f"  {2 * i + 1}: {{A{i - 1} B{i}: 0.95}}\n"
        text += f"  {2 * i + 2}: {{O{i}: [0, 0], B{i}: [0.6, 0], A{i}: [0.2, 0.02]}}\n"
        sides.append(f"B{i}: left of A{i - 1} O{i}")
    return text + f"drive: {{link: 2, angle: 60 deg, speed: 10 rpm}}\nassembly: {{{', '.join(sides)}}}\n"


def scenes_let_in():
    """Within the limits, and as much as these allow."""
    points = "".join(f", {name}: [0.{n % 9}5, {n // 9 + 1}e-2]" for n, name in enumerate(LETTERS[:MANY]))
    names = LETTERS[:MANY]
    yield "points", four_bar(points)
    yield "points-of-the-frame", four_bar(frame=points)
    yield "paths", four_bar(points, after=f"paths: [{', '.join(names[:24])}]\n")
    yield "charts", four_bar(points, after=f"charts: [{', '.join('v_' + name for name in names[:24])}]\n")
    yield "charts-of-accelerations", four_bar(points, after=f"charts: [{', '.join('a_' + name for name in names[:24])}]\n")
    yield "loads", four_bar(points, after="loads:\n" + "".join(
        f"  - {{at: {name}, on: 3, force: [{n + 1} N, 1 N]}}\n" for n, name in enumerate(names)))
    yield "givens", four_bar(before="givens:\n" + "".join(f"  g{n}: {n + 1} mm\n" for n in range(MANY)))
    yield "where-doubled", four_bar(before="givens: {w0: 1}\nwhere:\n" + "".join(
        f"  w{n + 1}: w{n} + w{n}\n" for n in range(MANY)))
    yield "where-squared", four_bar(before="givens: {w0: 7}\nwhere:\n" + "".join(
        f"  w{n + 1}: w{n}*w{n}\n" for n in range(MANY)))
    yield "formulas", four_bar(before="where:\n" + "".join(f"  w{n}: 1{' + 1/3' * 680}\n" for n in range(14)))
    yield "products", four_bar(before="where:\n" + "".join(f"  w{n}: {'*'.join(['9' * 40] * 98)}\n" for n in range(14)))
    yield "brackets", four_bar(before="where:\n" + "".join(
        f"  w{n}: {'(' * 2000}1{')' * 2000}\n" for n in range(14)))
    yield "digits", four_bar(length="0.35" + "1" * 4000)
    yield "a-length-of-nothing", four_bar(length="1e-399")
    yield "comments", filled(four_bar(), lambda n: "# a comment\n", most=SCENE)
    yield "a-long-chain", chain(24)


def scenes_refused():
    yield "too-long-a-chain", chain(26)
    yield "chain-of-thousands", chain(14_000)
    yield "deep", HEAD + "links: " + "[" * (SCENE - 30)
    yield "deep-maps", HEAD + "links: " + "{a: " * ((SCENE - 30) // 4)
    yield "entries", filled(HEAD + "links: [", lambda n: "a, ", "]\n", SCENE)
    yield "keys", filled(HEAD + "givens:\n", lambda n: f"  g{n}: 1\n", four_bar()[len(HEAD):], SCENE)
    yield "a-long-text", HEAD + "title: " + "word " * (SCENE // 6) + "\n"
    yield "anchors", HEAD + "a: &a [1]\nb: " + "[*a, *a]\n"
    yield "a-large-exponent", four_bar(length="1e999999999")
    yield "no-letters", "\x00" * SIZE
    yield "one-line", "a" * SIZE


def trusses():
    head = HEAD + "truss:\n  joints: {"
    yield "truss-joints", filled(head, lambda n: f"J{n}: [{n}, 1], ", "}\n", SCENE)
    for panels in (6, 9, 20, 12_000):
        joints = ", ".join(f"J{n}: [{n // 2} m, {n % 2} m]" for n in range(2 * panels))
        bars = [f"J{n} J{n + 1}" for n in range(2 * panels - 1)] + [f"J{n} J{n + 2}" for n in range(2 * panels - 2)]
        yield f"truss-of-{panels}", (head + joints + "}\n  bars: [" + ", ".join(bars) +
                                     f"]\n  supports: {{J0: hinge, J{2 * panels - 2}: roller}}\n"
                                     "  loads:\n    J3: [0, -1 kN]\n")


def commands():
    random.seed(1)
    for name, text in [*scenes_let_in(), *scenes_refused(), *trusses()]:
        yield ["check", file(name + ".yaml", text)]
    for name, _ in scenes_let_in():
        yield ["draw", name + ".yaml", "--format", "svg", "--out", "o"]
    for verb, option in (("class", "--students"), ("mark", "--answers"), ("draw", "--givens")):
        tail = ["--out", "o"] if verb != "mark" else []
        where = "slider-crank-velocity/poles" if verb != "mark" else "slider-crank-velocity"
        more = ["--vary", "r=0.18..0.22/0.01"] if verb == "class" else []
        for name, text in {
                "one-cell": "number,name\n1," + "x" * (SIZE - 20),
                "quotes": 'number,name\n1,"' + '""' * (SIZE // 2 - 20) + '"',
                "columns": "number" + ",r" * ((SIZE - 20) // 2),
                "columns-apart": filled("number", lambda n: f",c{n}", "\n1\n"),
                "empty-rows": "number,v_B\n" + "\n" * (SIZE - 20),
                "rows-twice": "number,v_B\n" + "1,1\n" * (SIZE // 4 - 20),
                "not-closed": 'number,v_B\n"' + "1,1\n" * (SIZE // 4 - 20)}.items():
            yield [verb, where, option, file(f"{verb}-{name}.csv", text)] + more + tail
    yield ["mark", "slider-crank-velocity", "--answers", file("answers.csv", filled(
        "number,v_B,omega_3,P0B\n", lambda n: f"{n},{random.random():.4f},1,2\n"))]
    yield ["mark", "slider-crank-velocity", "--answers", file("givens.csv", filled(
        "number,r,v_B\n", lambda n: f"{n},0.{2000 + n % 7},5.2\n"))]
    yield ["draw", "slider-crank-velocity/poles", "--givens", file("many-digits.ini", "r = 0.2" + "1" * 990_000), "-o",
           "o.svg"]
    yield ["import", file("deep.txt", "M[" * (SIZE // 2))]
    yield ["import", file("joints.txt", filled("M[", lambda n: f"J[R, P[{n}, 0], L[ground, L1]], ", "]"))]
    yield ["import", file("few-joints.txt", "M[" + ", ".join(
        f"J[R, P[{n}, {n * n % 17}], L[L{n}, L{n + 1}]]" for n in range(255)) + ", J[R, P[0, 0], L[ground, L0]]]")]
