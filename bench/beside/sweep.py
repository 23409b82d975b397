#!/usr/bin/python3
"""A million positions of the slider-crank's v_B in Python, beside `epure sweep`: what it costs, what is known.

    epure sweep slider-crank-velocity --over phi=0deg..360deg/1000001 --quantity v_B > v_B.csv
    python3 bench/beside/sweep.py v_B.csv chart.png

Needs python3-numpy and python3-matplotlib. v_B = |ω r (sin φ + cos φ · r sin φ / c)|, c² = l² - r² sin² φ, with
r = 0.2 m, l = 0.5 m, n = 360 rpm, as the exercise states them. The intervals are rounded outwards by a neighbouring double after
each operation, which holds for + - * / and roots; of sine, cosine and the angle it only trusts numpy to be within four
units in the last place: nobody proves that.
"""
import csv
import math
import sys
import time

import numpy as np

COUNT = 1_000_001
R, L, OMEGA = 0.2, 0.5, 2 * math.pi * 6


def by_loop():
    """Doubles, one after the other."""
    values = []
    for i in range(COUNT):
        phi = 2 * math.pi * i / (COUNT - 1)
        s, c = R * math.sin(phi), math.cos(phi)
        values.append(abs(OMEGA * (s + R * c * s / math.sqrt(L * L - s * s))))
    return np.array(values)


def by_numpy():
    """Doubles, all at once."""
    phi = np.linspace(0, 2 * math.pi, COUNT)
    s, c = R * np.sin(phi), np.cos(phi)
    return np.abs(OMEGA * (s + R * c * s / np.sqrt(L * L - s * s)))


class Interval:
    def __init__(self, low, high):
        self.low, self.high = low, high

    @staticmethod
    def around(values, units=1):
        for_each = units * np.spacing(np.abs(values))
        return Interval(values - for_each, values + for_each)

    @staticmethod
    def outwards(low, high):
        return Interval(np.nextafter(low, -np.inf), np.nextafter(high, np.inf))

    def __add__(self, other):
        return Interval.outwards(self.low + other.low, self.high + other.high)

    def __sub__(self, other):
        return Interval.outwards(self.low - other.high, self.high - other.low)

    def __mul__(self, other):
        all_four = [a * b for a in (self.low, self.high) for b in (other.low, other.high)]
        return Interval.outwards(np.minimum.reduce(all_four), np.maximum.reduce(all_four))

    def __truediv__(self, other):  # by what is positive
        all_four = [a / b for a in (self.low, self.high) for b in (other.low, other.high)]
        return Interval.outwards(np.minimum.reduce(all_four), np.maximum.reduce(all_four))

    def root(self):
        return Interval.outwards(np.sqrt(self.low), np.sqrt(self.high))

    def magnitude(self):
        low, high = np.abs(self.low), np.abs(self.high)
        passes_zero = (self.low <= 0) & (self.high >= 0)
        return Interval(np.where(passes_zero, 0, np.minimum(low, high)), np.maximum(low, high))


def by_intervals():
    phi = np.linspace(0, 2 * math.pi, COUNT)
    # An angle wrong by four units moves sine and cosine by as much.
    far = 4 * np.spacing(phi)
    sine, cosine = np.sin(phi), np.cos(phi)
    sine, cosine = (
        Interval.outwards(value - far - 4 * np.spacing(np.abs(value)), value + far + 4 * np.spacing(np.abs(value)))
        for value in (sine, cosine)
    )
    r, l, omega = Interval.around(R), Interval.around(L), Interval.around(OMEGA, 4)
    s = r * sine
    return (omega * (s + r * cosine * s / (l * l - s * s).root())).magnitude()


def timed(name, work):
    wall, processor = time.perf_counter(), time.process_time()
    result = work()
    print(f"{name}: {time.process_time() - processor:.2f} s of processor time, {time.perf_counter() - wall:.2f} s")
    return result


def main():
    timed("plain Python, doubles", by_loop)
    doubles = timed("numpy, doubles", by_numpy)
    bounds = timed("numpy, intervals", by_intervals)
    if len(sys.argv) > 1:
        with open(sys.argv[1], newline="") as file:
            rows = csv.reader(file)
            next(rows)
            proved = np.array([[float(x) for x in row[1:4]] for row in rows])
        value, lower, upper = proved.T
        unit = np.spacing(np.where(value > 0, value, 1))
        away = np.abs(doubles - value)
        print(f"numpy's doubles are the nearest ones in {np.mean(doubles == value):.1%}; "
              f"off by {np.max(away):.2g} m/s at most")
        print(f"its intervals hold epure's bounds in {np.mean((bounds.low <= lower) & (upper <= bounds.high)):.1%}; "
              f"the median one is {np.median((bounds.high - bounds.low) / unit):.0f} units wide, epure's "
              f"{np.median((upper - lower) / unit):.0f}")
    if len(sys.argv) > 2:
        import matplotlib

        matplotlib.use("Agg")
        from matplotlib import pyplot

        pyplot.plot(np.linspace(0, 360, COUNT), doubles)
        pyplot.xlabel("φ (deg)")
        pyplot.ylabel("v_B (m/s)")
        timed("matplotlib, a chart of them", lambda: pyplot.savefig(sys.argv[2]))


main()
