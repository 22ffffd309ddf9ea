#!/usr/bin/env python3
"""The numbers of common/elementary.cpp, from their definitions.

    elementary_coefficients.py           prints them
    elementary_coefficients.py --check   says which of them common/elementary.cpp has otherwise

Each polynomial meets its function at the Chebyshev points of its interval, worked out with 60 digits: that is within a
factor of two or so of the best polynomial of its degree, and one degree more than needed pays for it. Needs mpmath
(python3-mpmath, or pip install mpmath).
"""
import sys
from pathlib import Path

try:
    from mpmath import atan, cos, exp, floor, frexp, ldexp, log, lu_solve, matrix, mp, mpf, pi, sin, sqrt
except ImportError:
    sys.exit('mpmath is missing: apt install python3-mpmath, or pip install mpmath')
mp.dps = 60


def through_chebyshev_points(function, low, high, degree):
    """The coefficients, the constant first."""
    count = degree + 1
    points = [(low + high) / 2 + (high - low) / 2 * cos((2 * i + 1) * pi / (2 * count)) for i in range(count)]
    powers = matrix(count, count)
    for i, point in enumerate(points):
        for j in range(count):
            powers[i, j] = point ** j
    return list(lu_solve(powers, matrix([function(point) for point in points])))


def polynomial(name, function, low, high, degree):
    """Written with the highest power first, as Horner's rule takes them."""
    return name, [repr(float(c)) for c in reversed(through_chebyshev_points(function, mpf(low), mpf(high), degree))]


def cut(x, bits):
    """The first bits of x, the others dropped."""
    _, exponent = frexp(x)
    return ldexp(floor(ldexp(x, bits - exponent)), exponent - bits)


def parts(x, *widths):
    """Numbers whose sum is x: each of so many bits, the last one rounded."""
    out = []
    for bits in widths:
        out.append(cut(x, bits))
        x -= out[-1]
    return [repr(float(one)) for one in out + [x]]


def pair(name, x):
    high = float(x)
    return name, [repr(high), repr(float(x - mpf(high)))]


def tables():
    r2 = lambda z: sqrt(z)  # noqa: E731
    most = (pi / 4 * mpf('1.0001')) ** 2
    yield polynomial('sine', lambda z: (sin(r2(z)) - r2(z)) / r2(z) ** 3, 0, most, 5)
    yield polynomial('cosine', lambda z: (cos(r2(z)) - 1 + z / 2) / z ** 2, 0, most, 5)
    yield polynomial('rough_angle', lambda z: atan(r2(z)) / r2(z), 0, 1, 5)
    half = log(2) / 2 * mpf('1.0001')
    yield polynomial('power', lambda r: (exp(r) - 1 - r - r * r / 2) / r ** 3, -half, half, 9)
    s = (sqrt(2) - 1) / (sqrt(2) + 1) * mpf('1.0001')
    yield polynomial('logarithm', lambda z: (log((1 + r2(z)) / (1 - r2(z))) - 2 * r2(z) - 2 * r2(z) ** 3 / 3) / r2(z) ** 5,
                     0, s * s, 7)
    yield 'half_pi_parts', parts(pi / 2, 33, 33, 33)
    yield pair('half_pi', pi / 2)
    yield pair('whole_pi', pi)
    yield 'ln2', parts(log(2), 42)
    yield pair('per_ln2', 1 / log(2))
    yield pair('per_ln10', 1 / log(10))
    yield pair('two_thirds', mpf(2) / 3)
    mp.dps = 400
    bits = int(floor(ldexp(2 / pi, 32 * 38)))
    yield 'two_over_pi', ['0', '0'] + [f'0x{bits >> 32 * (37 - i) & 0xffffffff:08x}' for i in range(38)]


source = Path(__file__).resolve().parents[2] / 'common' / 'elementary.cpp'
text = source.read_text() if source.exists() else ''
wrong = 0
for name, numbers in tables():
    if '--check' not in sys.argv:
        print(f'{name} {{{", ".join(numbers)}}}')
        continue
    for number in numbers:
        if number not in text:
            wrong += 1
            print(f'{source.name} lacks {number} of {name}')
sys.exit(1 if wrong else 0)
