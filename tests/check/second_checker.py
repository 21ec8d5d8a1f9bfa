#!/usr/bin/env python3
"""A second checker of certificates, written from docs/certificate_file.md and check/format.md alone: second_checker.py FILE …

It shares nothing with ringwatch-check, neither source nor arithmetic: every number of the file is taken as the rational that it
is, and what follows is an interval between two rationals with the denominator 2**BITS, rounded outwards. Slow, and simple.
"""
import math
import re
import struct
import sys
from fractions import Fraction

BITS = 320
ONE = 1 << BITS
# A factor is that of a matrix less this part of its diagonal, far above what intervals are wide.
SHIFT = ONE >> 110


class NotACertificate(Exception):
    pass


class NotProven(Exception):
    pass


class Interval:
    """[low, high] / 2**BITS."""

    __slots__ = ("low", "high")

    def __init__(self, low, high):
        self.low, self.high = low, high

    def __add__(self, other):
        return Interval(self.low + other.low, self.high + other.high)

    def __sub__(self, other):
        return Interval(self.low - other.high, self.high - other.low)

    def __mul__(self, other):
        a, b, c, d = self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high
        return Interval(min(a, b, c, d) >> BITS, -(-max(a, b, c, d) >> BITS))

    def divided(self, power):
        """By a power of two."""
        return Interval(self.low >> power, -(-self.high >> power)) if power >= 0 else Interval(self.low << -power, self.high << -power)

    def inverse(self):
        if self.low <= 0 <= self.high:
            raise NotProven("a divisor may be zero")
        return Interval(ONE * ONE // self.high, -(-ONE * ONE // self.low))


def exact(value):
    """The interval about a rational."""
    scaled = Fraction(value) * ONE
    return Interval(math.floor(scaled), math.ceil(scaled))


ZERO = Interval(0, 0)


def total(terms):
    result = ZERO
    for term in terms:
        result = result + term
    return result


def root(a):
    if a.low < 0:
        raise NotProven("the root of a negative number")
    return Interval(math.isqrt(a.low << BITS), math.isqrt(a.high << BITS) + 1)


def logarithm(a):
    """ln a of a > 0, brought to [1, 2) first."""
    halvings, two = 0, exact(2)
    while a.low >= 2 * ONE:
        a, halvings = a * exact(Fraction(1, 2)), halvings + 1
    while 0 < a.low < ONE:
        a, halvings = a * two, halvings - 1
    return logarithm_series(a) + exact(halvings) * logarithm_series(two)


def logarithm_series(a):
    """ln a = 2 artanh((a - 1)/(a + 1)) of 1 <= a <= 2, its end by a geometric series."""
    t = (a - exact(1)) * (a + exact(1)).inverse()
    square, power, result = t * t, t, ZERO
    for k in range(1, 2 * BITS, 2):
        result = result + power * exact(Fraction(1, k))
        power = power * square
    end = max(abs(power.low), abs(power.high)) * 2 + 1  # 1/(1 - t**2) is below 2
    return Interval(result.low - end, result.high + end) * exact(2)


# Matrices are lists of rows.
def product(A, B):
    return [[total(a * b[j] for a, b in zip(row, B)) for j in range(len(B[0]))] for row in A]


def transposed(A):
    return [list(row) for row in zip(*A)]


def combined(*terms):
    """The sum of numbers times matrices."""
    return [[total(c * A[i][j] for c, A in terms) for j in range(3)] for i in range(3)]


def inner(A, B):
    return total(a * b for row, other in zip(A, B) for a, b in zip(row, other))


def trace(A):
    return A[0][0] + A[1][1] + A[2][2]


def cofactor(A):
    return [[A[(i + 1) % 3][(j + 1) % 3] * A[(i + 2) % 3][(j + 2) % 3] - A[(i + 1) % 3][(j + 2) % 3] * A[(i + 2) % 3][(j + 1) % 3]
             for j in range(3)] for i in range(3)]


def inverse_transposed(A):
    """And the determinant, which must be positive."""
    C = cofactor(A)
    determinant = total(a * c for a, c in zip(A[0], C[0]))
    if determinant.low <= 0:
        raise NotProven("a determinant is not positive")
    scale = determinant.inverse()
    return [[c * scale for c in row] for row in C], determinant


IDENTITY = [[exact(i == j) for j in range(3)] for i in range(3)]


def positive_definite(A):
    """Whether it is: with a factor L of numbers L L^T is positive semidefinite, and the rest has a dominant diagonal."""
    n = len(A)
    if any(A[i][i].low <= 0 for i in range(n)):
        return False
    # Scaled by powers of two, so that the diagonal is near 1.
    powers = [(A[i][i].high.bit_length() - BITS) // 2 for i in range(n)]
    A = [[A[i][j].divided(powers[i] + powers[j]) for j in range(n)] for i in range(n)]
    L = [[0] * n for _ in range(n)]
    for i in range(n):
        for j in range(i + 1):
            middle = (A[i][j].low + A[i][j].high) // 2 - (sum(a * b for a, b in zip(L[i][:j], L[j][:j])) >> BITS)
            if i > j:
                L[i][j] = (middle << BITS) // L[j][j]
            elif middle <= SHIFT:
                return False
            else:
                L[i][i] = math.isqrt((middle - SHIFT) << BITS)
                if L[i][i] == 0:
                    return False
    rest = [[None] * n for _ in range(n)]
    for i in range(n):
        for j in range(i + 1):
            squares = sum(a * b for a, b in zip(L[i][: j + 1], L[j][: j + 1]))
            rest[i][j] = rest[j][i] = A[i][j] - Interval(squares >> BITS, -(-squares >> BITS))
    return all(rest[i][i].low > sum(max(abs(b.low), abs(b.high)) for j, b in enumerate(rest[i]) if j != i) for i in range(n))


# Elements: the natural coordinates of their nodes, and shape functions at numbers or at dual numbers.
class Dual:
    def __init__(self, value, slope):
        self.value, self.slope = value, slope

    def __add__(self, other):
        other = other if isinstance(other, Dual) else Dual(other, 0)
        return Dual(self.value + other.value, self.slope + other.slope)

    def __mul__(self, other):
        other = other if isinstance(other, Dual) else Dual(other, 0)
        return Dual(self.value * other.value, self.slope * other.value + self.value * other.slope)

    __radd__, __rmul__ = __add__, __mul__

    def __sub__(self, other):
        return self + other * -1 if isinstance(other, Dual) else self + -other

    def __rsub__(self, other):
        return self * -1 + other

    def inverse(self):
        return Dual(1 / self.value, -self.slope / self.value**2)


CUBE = [(x, y, z) for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
CUBE_EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
TET_EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]


def tet4(x, y, z):
    return [1 - x - y - z, x, y, z]


def tet10(x, y, z):
    L = tet4(x, y, z)
    return [a * (2 * a - 1) for a in L] + [4 * L[a] * L[b] for a, b in TET_EDGES]


def hex8(x, y, z):
    return [Fraction(1, 8) * (1 + a * x) * (1 + b * y) * (1 + c * z) for a, b, c in CUBE]


def hex20(x, y, z):
    corners = [Fraction(1, 8) * (1 + a * x) * (1 + b * y) * (1 + c * z) * (a * x + b * y + c * z - 2) for a, b, c in CUBE]
    middles = []
    for first, second in CUBE_EDGES:
        N = Fraction(1, 4)
        for r, a, b in zip((x, y, z), CUBE[first], CUBE[second]):
            N = N * (1 + a * r if a == b else 1 - r * r)
        middles.append(N)
    return corners + middles


def wedge6(x, y, z):
    return [L * Fraction(1, 2) * (1 + c * z) for c in (-1, 1) for L in (1 - x - y, x, y)]


def pyramid5(x, y, z):
    w = 1 - z
    return [Fraction(1, 4) * (w + a * x) * (w + b * y) * w.inverse() for a, b, _ in CUBE[:4]] + [z]


ELEMENTS = {"tet4": (tet4, 4), "tet10": (tet10, 10), "hex8": (hex8, 8), "hex20": (hex20, 20), "wedge6": (wedge6, 6), "pyramid5": (pyramid5, 5)}


def natural_gradients(element, point):
    """dN_a/dxi_j, rationals."""
    columns = [ELEMENTS[element][0](*[Dual(Fraction(r), Fraction(i == j)) for i, r in enumerate(point)]) for j in range(3)]
    return [[exact(column[a].slope) for column in columns] for a in range(ELEMENTS[element][1])]


# Laws: F, lambda, mu, and then dP of dF.
def linear(F, lam, mu):
    return lambda dF: combined((lam * trace(dF), IDENTITY), (mu, dF), (mu, transposed(dF)))


def stvk(F, lam, mu):
    half, Ft = exact(Fraction(1, 2)), transposed(F)

    def stress(E):
        return combined((lam * trace(E), IDENTITY), (mu + mu, E))

    S = stress(combined((half, product(Ft, F)), (exact(0) - half, IDENTITY)))

    def differential(dF):
        A = product(Ft, dF)
        dS = stress(combined((half, A), (half, transposed(A))))
        return combined((exact(1), product(dF, S)), (exact(1), product(F, dS)))

    return differential


def neo_hookean(F, lam, mu):
    H, J = inverse_transposed(F)
    a = mu - lam * logarithm(J)
    return lambda dF: combined((mu, dF), (a, product(product(H, transposed(dF)), H)), (lam * inner(H, dF), H))


def stable_neo_hookean(F, lam, mu):
    m, l = exact(Fraction(4, 3)) * mu, lam + exact(Fraction(5, 6)) * mu
    square, C = inner(F, F), cofactor(F)
    J = total(a * c for a, c in zip(F[0], C[0]))
    scale = (square + exact(1)).inverse()
    a, b, c = m * square * scale, (m + m) * scale * scale, l * (J - exact(1)) - mu

    def differential(dF):
        # cof is quadratic: its differential is what is mixed of cof(F + dF).
        both = cofactor(combined((exact(1), F), (exact(1), dF)))
        mixed = combined((exact(1), both), (exact(-1), C), (exact(-1), cofactor(dF)))
        return combined((a, dF), (b * inner(F, dF), F), (l * inner(C, dF), C), (c, mixed))

    return differential


def stretch_of(F):
    """U of F = R U, det F > 0. Of a symmetric V > 0 near to it, (U - V) U + V (U - V) = F^T F - V V, so that
    |U - V| <= |F^T F - V V| / lambda_min(V), and lambda_min(V) >= det V / (tr V)**2."""
    C = product(transposed(F), F)
    R, half = F, exact(Fraction(1, 2))
    middle = lambda a: Interval((a.low + a.high) // 2, (a.low + a.high) // 2)  # noqa: E731
    for _ in range(40):  # Newton's iteration for the rotation
        R = [[middle(a) for a in row] for row in combined((half, R), (half, inverse_transposed(R)[0]))]
        if any(abs(a.low) > ONE * ONE for row in R for a in row):  # where F is flat to rounding it grows and grows
            raise NotProven("a stretch is not found")
    V = product(transposed(R), F)
    V = [[middle(half * (V[i][j] + V[j][i])) for j in range(3)] for i in range(3)]
    off = combined((exact(1), C), (exact(-1), product(V, V)))
    if not positive_definite(V):
        raise NotProven("a stretch is not found")
    square = inner(off, off)
    error = (root(Interval(max(0, square.low), square.high)) * trace(V) * trace(V) * inverse_transposed(V)[1].inverse()).high
    return [[a + Interval(-error, error) for a in row] for row in V]


def corotational(F, lam, mu):
    if inverse_transposed(F)[1].low <= 0:
        raise NotProven("an element is inverted")
    U = stretch_of(F)
    R = product(F, transposed(inverse_transposed(U)[0]))
    spin = inverse_transposed(combined((trace(U), IDENTITY), (exact(-1), U)))[0]  # it is symmetric
    t = lam * (trace(U) - exact(3)) - (mu + mu)

    def differential(dF):
        A = product(transposed(R), dF)
        k = [[A[2][1] - A[1][2]], [A[0][2] - A[2][0]], [A[1][0] - A[0][1]]]
        (x,), (y,), (z,) = product(spin, k)
        dR = product(R, [[ZERO, ZERO - z, y], [z, ZERO, ZERO - x], [ZERO - y, x, ZERO]])
        return combined((mu + mu, dF), (lam * inner(R, dF), R), (t, dR))

    return differential


LAWS = {"linear": linear, "stvk": stvk, "corotational": corotational, "neo-hookean": neo_hookean, "stable-neo-hookean": stable_neo_hookean}


def add_stiffness(K, weight, law, g):
    """weight B^T (dP/dF) B of shape gradients g."""
    n = len(g)
    moduli = [[law([[exact((i, j) == (k, l)) for j in range(3)] for i in range(3)]) for l in range(3)] for k in range(3)]
    for a in range(n):
        half = [[[weight * total(moduli[k][l][i][j] * g[a][j] for j in range(3)) for l in range(3)] for k in range(3)] for i in range(3)]
        for b in range(a + 1):
            for i in range(3):
                for k in range(3):
                    entry = total(half[i][k][l] * g[b][l] for l in range(3))
                    K[3 * a + i][3 * b + k] = K[3 * a + i][3 * b + k] + entry


def element_tangent(kind, X, x):
    n = len(X)
    K = [[ZERO] * (3 * n) for _ in range(3 * n)]
    constants = [exact(value) for value in kind["constants"]]
    lam, mu, point_lam, point_mu, mean_lam, mean_mu = constants
    law = LAWS[kind["law"]]
    volume, mean = ZERO, [[ZERO] * 3 for _ in range(n)]

    def gradient(g):
        return [[total(x[a][i] * g[a][j] for a in range(n)) for j in range(3)] for i in range(3)]

    for dN, weight in kind["points"]:
        jacobian = [[total(X[a][i] * dN[a][j] for a in range(n)) for j in range(3)] for i in range(3)]
        back, determinant = inverse_transposed(jacobian)
        g = [[total(back[i][j] * dN[a][j] for j in range(3)) for i in range(3)] for a in range(n)]
        w = exact(weight) * determinant
        volume = volume + w
        mean = [[m + w * c for m, c in zip(row, other)] for row, other in zip(mean, g)]
        if kind["constants"][2:4] != (0, 0):
            add_stiffness(K, w, law(gradient(g), lam * point_lam, mu * point_mu), g)
    if kind["constants"][4:] != (0, 0):
        scale = volume.inverse()
        mean = [[m * scale for m in row] for row in mean]
        add_stiffness(K, volume, law(gradient(mean), lam * mean_lam, mu * mean_mu), mean)
    return [[K[max(i, j)][min(i, j)] for j in range(3 * n)] for i in range(3 * n)]


# The file.
def number(word):
    """As %a prints it, and in no other way."""
    try:
        value = finite(float.fromhex(word.decode("latin-1")))
    except (ValueError, OverflowError) as fault:
        raise NotACertificate(f"{word!r} is no number") from fault
    if re.sub(r"\.?0*p", "p", value.hex()).encode() != word or word == b"-0x0p+0":
        raise NotACertificate(f"{word!r} is not how {value} is written")
    return value


def finite(value):
    if not math.isfinite(value):
        raise NotACertificate("a number is not finite")
    return value


def count(word):
    if not re.fullmatch(rb"[1-9][0-9]{0,9}", word):
        raise NotACertificate(f"{word!r} is no number of things")
    return int(word)


class Reader:
    def __init__(self, data):
        self.data, self.at = data, 0

    def line(self, key, words):
        end = self.data.find(b"\n", self.at)
        parts = self.data[self.at : end].split(b" ") if end >= 0 else []
        if len(parts) - 1 not in words or parts[0] != key:
            raise NotACertificate(f"there is no line '{key.decode()}'")
        self.at = end + 1
        return parts[1:]

    def numbers(self, form):
        size = struct.calcsize("<" + form)
        if self.at + size > len(self.data):
            raise NotACertificate("it is cut short")
        self.at += size
        return struct.unpack_from("<" + form, self.data, self.at - size)


def hashed(data):
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return value


def read(data):
    if len(data) < 8 or hashed(data[:-8]) != struct.unpack("<Q", data[-8:])[0]:
        raise NotACertificate("the checksum is another one")
    reader = Reader(data[:-8])
    if reader.line(b"ringwatch-certificate", [1]) != [b"2"]:
        raise NotACertificate("another version")
    proof = reader.line(b"proof", [1, 2])
    result = {"proof": proof[0].decode("latin-1"), "unit": number(proof[1]) if len(proof) == 2 else None}
    if result["proof"] not in ("nodal-bound", "factorisation", "exchange-bound") or (len(proof) == 2) != (proof[0] == b"exchange-bound"):
        raise NotACertificate("an unknown proof")
    nodes = count(reader.line(b"nodes", [1])[0])
    result["sigma"], result["lower"] = (number(reader.line(key, [1])[0]) for key in (b"sigma", b"lower"))
    if result["sigma"] < 0 or result["lower"] < 0 or (result["unit"] or 1) <= 0:
        raise NotACertificate("a bound is negative")
    kinds = []
    for _ in range(count(reader.line(b"kinds", [1])[0])):
        element, law, *words = (word.decode("latin-1") for word in reader.line(b"kind", [10]))
        if element not in ELEMENTS or law not in LAWS:
            raise NotACertificate(f"no certificates of {element} of {law}")
        kind = {"element": element, "law": law, "count": count(words[0].encode()), "points": [],
                "constants": tuple(number(word.encode()) for word in words[1:7])}
        for _ in range(count(words[7].encode())):
            *point, weight = (number(word) for word in reader.line(b"point", [4]))
            try:
                kind["points"].append((natural_gradients(element, point), weight))
            except ZeroDivisionError as fault:
                raise NotACertificate("a point is at the apex") from fault
        kinds.append(kind)
    reader.line(b"end", [0])
    result["nodes"] = []
    for _ in range(nodes):
        *values, held = reader.numbers("10dB")
        unused = [i for i in range(3) if held >> i & 1 or result["lower"] == 0]
        if values[6] <= 0 or not all(map(math.isfinite, values)) or held > 7 or any(struct.pack("<d", values[7 + i]) != bytes(8) for i in unused):
            raise NotACertificate("a node is none")
        result["nodes"].append({"X": [exact(v) for v in values[:3]], "x": [exact(v) for v in values[3:6]], "mass": exact(values[6]),
                                "u": [exact(v) for v in values[7:]], "free": [i for i in range(3) if not held >> i & 1]})
    result["elements"] = []
    for kind in kinds:
        n = ELEMENTS[kind["element"]][1]
        for _ in range(kind["count"]):
            entry = {"kind": kind, "nodes": reader.numbers(f"{n}i")}
            if len(set(entry["nodes"])) < n or not all(0 <= node < nodes for node in entry["nodes"]):
                raise NotACertificate("an element has nodes that are none")
            if result["proof"] == "nodal-bound":
                entry["allowance"], *entry["weights"] = reader.numbers(f"d{6 * n}h")
                finite(entry["allowance"])
                finite(entry["allowance"])
                rows = [(i, 0, 1, 2, 2, 2, 1) for i in entry["nodes"]]
                for (i, *of_factor), *L in zip(rows, *[iter(entry["weights"])] * 6):
                    if min(L[:3]) < 0 or any(w for w, row in zip(L, of_factor) if row not in result["nodes"][i]["free"]):
                        raise NotACertificate("a weight is negative, or is of a component that is held")
            elif result["proof"] == "exchange-bound":
                entry["shares"] = reader.numbers(f"{3 * n * (3 * n + 1) // 2}i")
                free = [c in result["nodes"][i]["free"] for i in entry["nodes"] for c in range(3)]
                if any(g for g, (i, j) in zip(entry["shares"], ((i, j) for i in range(3 * n) for j in range(i + 1))) if not (free[i] and free[j])):
                    raise NotACertificate("a share is of a component that is held")
            result["elements"].append(entry)
    if reader.at != len(reader.data):
        raise NotACertificate("something is behind its end")
    return result


def require(holds, what):
    if not holds:
        raise NotProven(what)


def block(A, rows):
    return [[A[i][j] for j in rows] for i in rows]


def prove(certificate):
    """Raises NotProven where it is not."""
    nodes, elements, proof = certificate["nodes"], certificate["elements"], certificate["proof"]
    sigma, lower = exact(certificate["sigma"]), exact(certificate["lower"])
    own = [[[ZERO] * 3 for _ in range(3)] for _ in nodes]  # what elements have of a node's block
    pairs, dofs = {}, {(i, c): k for k, (i, c) in enumerate((i, c) for i, node in enumerate(nodes) for c in node["free"])}
    whole = [[ZERO] * len(dofs) for _ in dofs] if proof == "factorisation" and certificate["sigma"] > 0 else None
    uKu = ZERO
    for index, entry in enumerate(elements):
        at = entry["nodes"]
        K = element_tangent(entry["kind"], [nodes[i]["X"] for i in at], [nodes[i]["x"] for i in at])
        u = [c for i in at for c in nodes[i]["u"]]
        uKu = uKu + total(u[i] * K[i][j] * u[j] for i in range(len(u)) for j in range(len(u)))
        free = [3 * a + c for a, i in enumerate(at) for c in nodes[i]["free"]]
        if proof == "nodal-bound":
            bound = [[ZERO] * len(u) for _ in u]
            for a, i in enumerate(at):
                r = [Fraction(k * abs(k), 32767**2) for k in entry["weights"][6 * a : 6 * a + 6]]
                L = [[exact(v) for v in row] for row in ([r[0], 0, 0], [r[5], r[1], 0], [r[4], r[3], r[2]])]
                D = product(L, transposed(L))
                for j in range(3):
                    for k in range(3):
                        bound[3 * a + j][3 * a + k] = exact(entry["allowance"]) * D[j][k]
                        own[i][j][k] = own[i][j][k] + bound[3 * a + j][3 * a + k]
        elif proof == "exchange-bound":
            # All is divided by the roots of the masses, which need not matter where a component is held.
            scale = [root(nodes[i]["mass"]).inverse() if c in nodes[i]["free"] else ZERO for i in at for c in range(3)]
            K = [[scale[i] * K[i][j] * scale[j] for j in range(len(u))] for i in range(len(u))]
            share = {}
            for k, (i, j) in enumerate((i, j) for i in range(len(u)) for j in range(i + 1)):
                share[i, j] = share[j, i] = entry["shares"][k]
            bound = [[exact(Fraction(certificate["unit"]) * share[i, j] / 2**30) for j in range(len(u))] for i in range(len(u))]
            for i in free:
                for j in free:
                    if i // 3 == j // 3:
                        own[at[i // 3]][i % 3][j % 3] = own[at[i // 3]][i % 3][j % 3] + bound[i][j]
                    else:
                        key = (at[i // 3], i % 3, at[j // 3], j % 3)
                        pairs[key] = pairs.get(key, 0) + share[i, j]
        elif whole:
            places = [dofs.get((i, c)) for i in at for c in range(3)]
            for i in free:
                for j in free:
                    whole[places[i]][places[j]] = whole[places[i]][places[j]] + K[i][j]
        if proof != "factorisation":
            require(positive_definite(block([[b - k for b, k in zip(row, other)] for row, other in zip(bound, K)], free)), f"element {index}")
    require(not any(pairs.values()), "what elements exchange does not add up to zero")
    for i, node in enumerate(nodes):
        most = sigma if proof == "exchange-bound" else sigma * node["mass"]
        rest = [[(most if j == k else ZERO) - own[i][j][k] for k in range(3)] for j in range(3)]
        require(whole or proof == "factorisation" or positive_definite(block(rest, node["free"])), f"node {i}")
        if whole:
            for c in node["free"]:
                whole[dofs[i, c]][dofs[i, c]] = whole[dofs[i, c]][dofs[i, c]] - most
    require(not whole or positive_definite([[ZERO - a for a in row] for row in whole]), "the factorisation")
    if certificate["lower"] > 0:
        uMu = total(node["mass"] * c * c for node in nodes for c in node["u"])
        require((uKu - lower * uMu).low > 0, "the lower side")


def status(data):
    """0: proven, 1: not proven, 2: not a certificate; and the reason."""
    try:
        prove(read(data))
    except NotACertificate as fault:
        return 2, str(fault)
    except NotProven as fault:
        return 1, str(fault)
    return 0, "proven"


if __name__ == "__main__":
    worst = 0
    for name in sys.argv[1:]:
        with open(name, "rb") as file:
            result, why = status(file.read())
        print(f"{name}: {why}")
        worst = max(worst, result)
    sys.exit(worst)
