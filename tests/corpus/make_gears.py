#!/usr/bin/env python3
"""Writes gears.txt: reference values for pairs of involute gears, independent of the C++ code.

  make_gears.py > gears.txt

No involute function is used. A flank is what the straight edge of the generating rack leaves: the rack is rolled on
the reference circle, and its edge touches the wheel where its normal passes through the pitch point. Thicknesses are
read off such flanks; the centre distance of shifted wheels is the one at which tooth and tooth fill the pitch. Where
contact begins and ends follows from the triangle of wheel centre, pitch point and contact. Least numbers of teeth are
found by counting up. Tips that collide are looked for by turning the pair on in small steps. Slidings are the ratio of the arcs that two contact points near each other leave on the flanks.
"""
from fractions import Fraction

from mpmath import atan2, cos, diff, findroot, mp, mpf, nstr, pi, sin, sqrt, tan

mp.dps = 60

STATED = dict(kind="external", z1="20", z2="40", m="10", alpha="22", x1="0", x2="0", ha="1", hf="5/4", k="0", rho="1/4",
              j="0", n1="150")
CASES = [
    ("stated", "the exercise as it is stated", {}),
    ("shifted", "both wheels shifted outwards", dict(x1="1/2", x2="1/5")),
    ("shifted_inwards", "the sum of the shifts negative", dict(x1="1/10", x2="-3/5")),
    ("long_addendum", "opposite shifts: the centre distance is kept", dict(x1="2/5", x2="-2/5")),
    ("tip_on_pitch_circle", "opposite shifts of 1: no path of approach at all", dict(x1="1", x2="-1")),
    ("play", "shifted, with backlash", dict(x1="3/10", x2="1/10", j="1/5")),
    ("shortened", "shifted, the tips shortened", dict(x1="3/5", x2="2/5", k="3/20")),
    ("twenty", "20 degrees, module 2, many teeth", dict(z1="17", z2="101", m="2", alpha="20")),
    ("at_the_limit", "8 teeth at 30 degrees: undercut begins exactly here", dict(z1="8", alpha="30", rho="1/2")),
    ("equal", "equal wheels at 45 degrees with low teeth", dict(z1="12", z2="12", alpha="45", ha="1/2", hf="5/8")),
    ("three", "3 teeth against a million", dict(z1="3", z2="1000000")),
    ("million", "two wheels of a million teeth, shifted", dict(z1="999999", z2="1000000", x1="1/4", x2="1/8")),
    ("reducing", "wheel 1 the larger", dict(z1="45", z2="23", x2="1/3")),
    ("watch", "module of a tenth of a millimetre, 14.5 degrees", dict(z1="30", z2="120", m="1/10", alpha="29/2")),
    ("ring", "a ring", dict(kind="internal", z2="60")),
    ("ring_shifted", "a ring, both shifted", dict(kind="internal", z1="18", z2="61", x1="3/10", x2="1/2", alpha="20")),
    ("ring_closer", "a ring, shifted inwards less than the wheel", dict(kind="internal", z2="70", x1="1/2", x2="1/5",
                                                                       j="1/10")),
    ("ring_tight", "a ring two teeth too small: the tips collide", dict(kind="internal", z1="40", z2="45", alpha="20")),
    ("ring_just_tight", "a ring one tooth too small", dict(kind="internal", z1="40", z2="48", alpha="20")),
    ("ring_just_wide", "the smallest ring for these teeth", dict(kind="internal", z1="40", z2="49", alpha="20")),
    ("ring_low_teeth", "low teeth at 30 degrees leave room for a ring with four more", dict(
        kind="internal", z1="40", z2="44", alpha="30", ha="4/5", hf="1")),
    ("ring_low_teeth_tight", "with three more they do not", dict(kind="internal", z1="40", z2="43", alpha="30", ha="4/5",
                                                                hf="1")),
    ("rack", "a rack", dict(kind="rack")),
    ("rack_shifted", "a wheel of 10 teeth shifted on a rack", dict(kind="rack", z1="10", x1="1/2", k="1/10", j="1/20")),
    ("odd", "no round number anywhere", dict(z1="29", z2="37", m="7/3", alpha="157/8", x1="2/7", x2="3/11", ha="12/13",
                                             hf="17/14", k="1/17", j="1/19", n1="1000/7")),
]


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


def text(x):
    return "0" if abs(x) < mpf(10) ** -48 else nstr(x, 40, strip_zeros=True, min_fixed=-30, max_fixed=30)


class Rolled:
    """A wheel in the rack that generates it: centre in the origin, pitch point (0, r), the rack's reference line at
    r + x m; the middle of a tooth points along +y when the rack is in the middle of its travel."""

    def __init__(self, z, m, alpha, x):
        self.z, self.m, self.alpha, self.x = z, m, alpha, x
        self.r = m * z / 2
        self.base = self.r * cos(alpha)  # checked below against the envelope

    def point(self, phi):
        """Where the right edge of the rack's space touches the tooth when the wheel has turned clockwise by phi."""
        a, xm = self.alpha, self.x * self.m
        # edge: ((pi m/4 - v tan a) + r phi, r + x m + v); its normal (cos a, sin a) passes through (0, r)
        v = (pi * self.m / 4 + self.r * phi - xm / tan(a)) / (1 / tan(a) + tan(a))
        return pi * self.m / 4 - v * tan(a) + self.r * phi, self.r + xm + v

    def roll_to(self, radius):
        """The rolling angle at which the point of the flank at this radius is generated: a quadratic, as the contact
        moves straight along the rack's line of action."""
        (x0, y0), (x1, y1) = self.point(mpf(0)), self.point(mpf(1))
        dx, dy = x1 - x0, y1 - y0
        A, B, C = dx * dx + dy * dy, x0 * dx + y0 * dy, x0 * x0 + y0 * y0 - radius**2
        root = B * B - A * C
        return None if root < -mpf(10) ** -50 * B * B else (-B + sqrt(max(root, mpf(0)))) / A

    def half_angle(self, radius):
        """From the middle of the tooth to its right flank; None inside the base circle."""
        phi = self.roll_to(radius)
        if phi is None:
            return None
        x, y = self.point(phi)
        return atan2(x, y) - phi

    def thickness(self, radius):
        half = self.half_angle(radius)
        return None if half is None else 2 * radius * half


class Pair:
    def __init__(self, given):
        self.kind = given["kind"]
        value = {k: number(v) for k, v in given.items() if k != "kind"}
        self.z1, self.z2 = value["z1"], value["z2"]
        self.m, self.j = value["m"] / 1000, value["j"] / 1000
        self.alpha = value["alpha"] * pi / 180
        self.x1, self.x2, self.ha, self.hf, self.k = (value[n] for n in ("x1", "x2", "ha", "hf", "k"))
        self.n1 = value["n1"]
        self.place()

    def place(self):
        m = self.m
        self.out = -1 if self.kind == "internal" else 1
        self.w1 = Rolled(self.z1, m, self.alpha, self.x1)
        self.r1 = self.w1.r
        self.tip1, self.root1 = self.r1 + m * (self.ha + self.x1 - self.k), self.r1 - m * (self.hf - self.x1)
        if self.kind == "rack":
            self.rw1, self.alpha_w, self.a = self.r1, self.alpha, self.r1
            return
        self.w2 = Rolled(self.z2, m, self.alpha, self.x2)
        self.r2 = self.w2.r
        self.tip2 = self.r2 + m * self.x2 + self.out * m * (self.ha - self.k)
        self.root2 = self.r2 + m * self.x2 - self.out * m * self.hf
        ratio = self.z2 / self.z1

        def overfull(rw1):  # teeth on the working circles, less the pitch
            s2 = self.plain_thickness(2, rw1 * ratio)
            return self.w1.thickness(rw1) + s2 - 2 * pi * rw1 / self.z1

        self.rw1 = self.r1
        if self.x1 + self.out * self.x2 != 0:
            # rw1 = rb1/cos(alpha_w): searched over the angle, where rw1 stays outside the base circle
            angle = findroot(lambda t: overfull(self.w1.base / cos(t)) / m,
                             (self.guess(), self.guess() * (1 + mpf(10) ** -6)), tol=mpf(10) ** -100, maxsteps=200)
            self.rw1 = self.w1.base / cos(angle)
        self.rw2 = self.rw1 * ratio
        self.alpha_w = atan2(sqrt(self.rw1**2 - self.w1.base**2), self.w1.base)
        self.a = self.rw2 + self.out * self.rw1

    def guess(self):
        """Sixty halvings in the working angle; the secant then finishes."""
        def full(t):
            rw1 = self.w1.base / cos(t)
            return self.w1.thickness(rw1) + self.plain_thickness(2, rw1 * self.z2 / self.z1) - 2 * pi * rw1 / self.z1
        low, high = mpf(1) / 100, mpf(14) / 10
        for _ in range(60):
            middle = (low + high) / 2
            if full(middle) > 0:
                low = middle
            else:
                high = middle
        return low

    def plain_thickness(self, wheel, radius):
        """Without backlash; a ring's tooth is the space of a wheel."""
        w = self.w1 if wheel == 1 else self.w2
        s = w.thickness(radius)
        if s is None:
            return None
        return 2 * pi * radius / w.z - s if wheel == 2 and self.kind == "internal" else s

    def thickness(self, wheel, radius):
        s = self.plain_thickness(wheel, radius)
        return None if s is None else s - radius * self.j / (2 * (self.rw1 if wheel == 1 else self.rw2))

    def rack_thickness(self, h):
        return pi * self.m / 2 - 2 * h * tan(self.alpha) - self.j / 2

    # Positions on the line of action from the pitch point; sides of the triangle O, P0, contact by the cosine rule,
    # where the angle at P0 is 90 degrees plus or minus alpha_w.
    def A(self):
        s = sin(self.alpha_w)
        if self.kind == "rack":
            return -(self.ha - self.k - self.x1) * self.m / s
        root = self.tip2**2 - self.rw2**2 * cos(self.alpha_w) ** 2
        if root < 0:
            return None
        return -(sqrt(root) - self.rw2 * s) if self.kind == "external" else sqrt(root) - self.rw2 * s

    def E(self):
        root = self.tip1**2 - self.rw1**2 * cos(self.alpha_w) ** 2
        return None if root < 0 else sqrt(root) - self.rw1 * sin(self.alpha_w)

    def distance(self, wheel, xi):
        """From the wheel's centre to the point of the line of action."""
        c, s = cos(self.alpha_w), sin(self.alpha_w)
        x, y = -xi * c, xi * s
        oy = -self.rw1 if wheel == 1 else self.out * self.rw2
        return sqrt(x * x + (y - oy) ** 2)

    def foot(self, wheel):
        """T1, T2 on the line of action."""
        return (-self.rw1 if wheel == 1 else self.out * self.rw2) * sin(self.alpha_w)

    def flank_arc(self, wheel, xi):
        """Length of the flank from its start to the point that touches at xi: the involute's, t²/(2 r_b), in terms of
        the distance t from T; of a rack the straight edge."""
        if wheel == 2 and self.kind == "rack":
            # The contact rises with xi sin alpha while the rack moves on.
            return xi * tan(self.alpha)
        base = self.w1.base if wheel == 1 else self.w2.base
        return (xi - self.foot(wheel)) ** 2 / (2 * base)

    def specific(self, wheel, xi):
        # Both towards tip 1: the arc of an external wheel 2 grows the other way.
        mine, other = (diff(lambda u: self.flank_arc(w, u), xi) * (-1 if w == 2 and self.kind == "external" else 1)
                       for w in (wheel, 3 - wheel))
        return None if mine == 0 else (mine - other) / mine


def tips_collide(p):
    """Turns the pair on from the last contact, and looks whether the tip corner of the driving flank comes into the
    ring's tooth that it drove: beyond the flank where the ring has one. Angles counter-clockwise from +y."""
    step, start = mpf(1) / 1000, p.E() / p.w1.base
    corner = p.w1.half_angle(p.tip1) - p.w1.half_angle(p.rw1)
    for i in range(1, 4000):
        phi = start + i * step
        x, y = -p.tip1 * sin(phi + corner), p.tip1 * cos(phi + corner) + p.a  # from the ring's centre
        radius = sqrt(x * x + y * y)
        if radius < p.tip2:
            return False
        flank = phi * p.z1 / p.z2 + p.w2.half_angle(radius) - p.w2.half_angle(p.rw2)
        if atan2(-x, y) > flank:
            return True
    raise ValueError("the corner never leaves")


def undercut(p, z):
    """The corner of the rack's edge at the depth ha lies beyond the foot of the perpendicular from the centre on the
    line of action, in units of m."""
    r = z / 2
    along = r * sin(p.alpha)              # pitch point to the foot
    corner = (p.ha - p.x1) / sin(p.alpha)  # pitch point to the corner when it lies on the line of action
    return corner > along * (1 + mpf(10) ** -45)


def interferes(p, z):
    q = Pair.__new__(Pair)
    q.__dict__.update(p.__dict__)
    q.z1, q.z2 = mpf(z), p.z2 / p.z1 * z
    try:
        q.place()
    except (ValueError, ZeroDivisionError, TypeError):
        return True  # no working angle
    A = q.A()
    if A is None:
        return q.kind == "internal"
    return A < q.foot(1) - mpf(10) ** -45 * q.m


def least(bad, p):
    z = 1
    while bad(p, z):
        z += 1
    return mpf(z)


def real_limit(p):
    """Where a wheel with a continuous number of teeth begins to interfere; shifts that cancel only."""
    h = p.ha - p.k + (0 if p.kind == "rack" else p.out * p.x2) - (p.x1 if p.kind == "rack" else 0)
    if h <= 0:
        return mpf(0)
    s = sin(p.alpha)
    u = p.z2 / p.z1

    def room(z):  # distance of A from T1 over m, wheel 2's tip a circle about its centre
        if p.kind == "rack":
            return z / 2 * s - h / s
        r2 = u * z / 2
        if p.out * h + r2 < r2 * cos(p.alpha):
            return mpf(-1)  # tip 2 inside its base circle
        t2 = sqrt((r2 + p.out * h) ** 2 - (r2 * cos(p.alpha)) ** 2)
        return z / 2 * s - p.out * (t2 - r2 * s)

    low, high = mpf(0), least(interferes, p)
    for _ in range(230):
        middle = (low + high) / 2
        low, high = (low, middle) if room(middle) >= 0 else (middle, high)
    return high


def values(given):
    p = Pair(given)
    m, external = p.m, p.kind == "external"
    rack = p.kind == "rack"
    degree = pi / 180
    found = {}

    def put(name, value):
        found[name] = "infinite" if value is None else text(value)

    def circle(wheel, name, value):
        put(name, None if rack and wheel == 2 else value())

    for w in (1, 2):
        r = (lambda: p.r1) if w == 1 else (lambda: p.r2)
        circle(w, f"r{w}", r)
        circle(w, f"r_tip_{w}", lambda: p.tip1 if w == 1 else p.tip2)
        circle(w, f"r_root_{w}", lambda: p.root1 if w == 1 else p.root2)
        base = (lambda: p.r1 * cos(p.alpha)) if w == 1 else (lambda: p.r2 * cos(p.alpha))
        circle(w, f"r_base_{w}", base)
        circle(w, f"r_w_{w}", lambda: p.rw1 if w == 1 else p.rw2)
        circle(w, f"z{w}", lambda: p.z1 if w == 1 else p.z2)
        if rack and w == 2:
            put("tooth_thickness_pitch_2", p.rack_thickness(mpf(0)))
            put("tooth_thickness_working_2", p.rack_thickness(p.x1 * m))
            put("tooth_thickness_base_2", None)
            put("tooth_thickness_tip_2", p.rack_thickness((p.ha - p.k) * m))
            put("tip_pressure_angle_2_deg", p.alpha / degree)
            continue
        tip, rw = (p.tip1, p.rw1) if w == 1 else (p.tip2, p.rw2)
        put(f"tooth_thickness_pitch_{w}", p.thickness(w, r()))
        put(f"tooth_thickness_working_{w}", p.thickness(w, rw))
        put(f"tooth_thickness_base_{w}", p.thickness(w, base()))
        put(f"tooth_thickness_tip_{w}", p.thickness(w, tip))
        put(f"tip_pressure_angle_{w}_deg", None if tip < base() else atan2(sqrt(tip**2 - base() ** 2), base()) / degree)
    put("centre_distance", p.a)
    put("working_pressure_angle_deg", p.alpha_w / degree)
    put("addendum", p.tip1 - p.r1)
    put("dedendum", p.r1 - p.root1)
    put("addendum_2", (p.ha - p.k) * m if rack else p.out * (p.tip2 - p.r2))
    put("dedendum_2", p.hf * m if rack else p.out * (p.r2 - p.root2))
    put("tooth_height", p.tip1 - p.root1)
    put("clearance", (p.hf - p.ha + p.k) * m if rack else p.a - p.tip1 - p.root2 if external else p.root2 - p.a - p.tip1)
    put("clearance_2", (p.hf - p.ha + p.k) * m if rack else p.a - p.tip2 - p.root1 if external else p.tip2 - p.a - p.root1)
    put("circular_pitch", pi * m)
    put("base_pitch", 2 * pi * p.r1 * cos(p.alpha) / p.z1)
    A, E = p.A(), p.E()
    both = None if A is None or E is None else E - A
    put("path_of_approach", None if A is None else -A)
    put("path_of_recess", E)
    put("path_of_contact", both)
    working = cos(p.alpha_w)
    put("arc_of_approach", None if A is None else -A / working)
    put("arc_of_recess", None if E is None else E / working)
    put("arc_of_action", None if both is None else both / working)
    put("contact_ratio", None if both is None else both / working / (2 * pi * p.rw1 / p.z1))
    put("start_of_active_profile_radius_1", None if A is None else p.distance(1, A))
    put("start_of_active_profile_radius_2", None if E is None or rack else p.distance(2, E))
    omega1 = 2 * pi * p.n1 / 60
    omega2 = mpf(0) if rack else -p.out * omega1 * p.z1 / p.z2
    put("omega_1", omega1)
    put("omega_2", omega2)
    put("omega_relative", abs(omega1 - omega2))
    for where, xi in (("approach", A), ("recess", E)):
        put(f"sliding_velocity_{where}", None if xi is None else abs(omega1 - omega2) * abs(xi))
        for w in (1, 2):
            put(f"specific_sliding_{w}_{where}", None if xi is None else p.specific(w, xi))
    put("interference_limit_approach", -p.foot(1))
    put("interference_limit_recess", p.foot(2) if external else None)
    put("max_tip_radius_2_without_interference", None if rack else p.distance(2, p.foot(1)))
    put("max_tip_radius_1_without_interference", p.distance(1, p.foot(2)) if external else None)
    put("undercut_limit_addendum_1", p.r1 * sin(p.alpha) ** 2 + p.x1 * m)
    put("undercut_limit_teeth", 2 * (p.ha - p.x1) / sin(p.alpha) ** 2)
    put("minimum_teeth_no_undercut_rack", least(undercut, p))
    shifted = not rack and p.x1 + p.out * p.x2 != 0
    put("interference_limit_teeth", None if shifted else real_limit(p))
    put("minimum_teeth_pinion_for_this_ratio", least(interferes, p))
    if p.kind == "internal":
        found["tips_collide"] = str(int(tips_collide(p)))
    return found


print(__doc__.split("\n\n")[2].replace("\n", "\n# ").join(["# Reference values of involute gears, 40 digits. Written by "
      "make_gears.py with mpmath,\n# 60 working digits; do not edit by hand.\n# ", ""]).rstrip())
print("# Givens as --set takes them, in its units; values in SI units, angles in degrees. `infinite`: there is none.")
for name, why, changes in CASES:
    given = dict(STATED, **changes)
    print(f"\ncase {name}\nwhy {why}\nchoice kind {given['kind']}")
    for symbol, value in given.items():
        if symbol != "kind" and not (given["kind"] == "rack" and symbol == "x2"):
            print(f"given {symbol} {value}")
    for quantity, value in values(given).items():
        print(quantity, value)
