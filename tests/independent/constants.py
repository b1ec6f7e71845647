#!/usr/bin/env python3
"""Peak constants of cam motion laws, worked out from the formulas alone.

Nothing of the library is imported.  Each law is built here from its formula,
differentiated exactly (term by term, or by Taylor arithmetic for the elliptic
and the parametric laws), and its extremes are found by bisection on the next
exact derivative at 50 digits.  Checks on the way: s(0) = 0, s(1) = 1,
s'(0) = s'(1) = 0 (constant velocity excepted), s and s' continuous at the
joints, derivatives against numerical ones of s, and no value of a dense
sample above the peak found.

Writes constants.csv beside this file:
  B = max|s'|, C_max, C_min of s'', D_inside_max, D_inside_min of s''' over the
  open smooth pieces (a jump of s'' does not count), Cm = max|s' s''|.
"""
import csv
import os
from mpmath import mp, mpf, inf, pi, sin, cos, sqrt, asin, cot, matrix, lu_solve, isinf, nstr

mp.dps = 50
EPS = mpf(10) ** -40
SCAN = 300          # cells scanned for sign changes, per piece
SAMPLE = 4096       # points of the dense check over the stretch


def R(a, b=1):
    return mpf(a) / mpf(b)


# ---------------------------------------------------------------- pieces

class Terms:
    """sum c t^e + sum A sin(w t + p), t = x - x0, on [x0, x1]."""

    def __init__(self, x0, x1, powers, sines=()):
        self.lo, self.hi, self.x0 = mpf(x0), mpf(x1), mpf(x0)
        self.P, self.S = [], []
        pw = [(mpf(c), mpf(e)) for c, e in powers if c != 0]
        sn = [(mpf(A), mpf(w), mpf(p)) for A, w, p in sines if A != 0]
        for k in range(5):
            self.P.append(pw)
            self.S.append(sn)
            pw = [(c * e, e - 1) for c, e in pw if e != 0]
            sn = [(A * w, w, p + pi / 2) for A, w, p in sn]

    def x(self, c):
        return c

    def d(self, k, x):
        t = x - self.x0
        r = mpf(0)
        for c, e in self.P[k]:
            if e == 0:
                r += c
            elif e == int(e):
                r += c * t ** int(e)
            else:
                r += c * t ** e
        for A, w, p in self.S[k]:
            r += A * sin(w * t + p)
        return r

    def zero(self, k):
        return not self.P[k] and not self.S[k]


class Affine:
    """base piece g: s = off + m g(y), y = al x + be (al > 0)."""

    def __init__(self, g, off, m, al, be):
        self.g, self.off, self.m, self.al, self.be = g, off, m, al, be
        self.lo, self.hi = (g.lo - be) / al, (g.hi - be) / al

    def x(self, c):
        return c

    def d(self, k, x):
        r = self.m * self.al ** k * self.g.d(k, self.al * x + self.be)
        return r + self.off if k == 0 else r

    def zero(self, k):
        return self.g.zero(k)


class Clip(Affine):
    def __init__(self, g, off, m, al, be, lo, hi):
        super().__init__(g, off, m, al, be)
        self.lo, self.hi = max(self.lo, lo), min(self.hi, hi)


# Taylor arithmetic: lists of coefficients of dt^0..dt^5
N = 6


def tmul(a, b):
    return [sum(a[j] * b[i - j] for j in range(i + 1)) for i in range(N)]


def tdiv(a, b):
    q = []
    for i in range(N):
        q.append((a[i] - sum(q[j] * b[i - j] for j in range(i))) / b[0])
    return q


def tpow(a, r):
    q = [a[0] ** r]
    for i in range(1, N):
        q.append(sum((r * j - (i - j)) * a[j] * q[i - j] for j in range(1, i + 1)) / (i * a[0]))
    return q


def tsin(w, t, ph=0):
    r, f = [], mpf(1)
    for i in range(N):
        r.append(sin(w * t + ph + i * pi / 2) * w ** i / f)
        f *= i + 1
    return r


def tder(a):
    return [a[i + 1] * (i + 1) for i in range(N - 1)] + [mpf(0)]


class Jet:
    """A piece whose derivatives come from Taylor arithmetic, cached by point."""
    lo, hi = mpf(0), mpf(1)

    def __init__(self):
        self.cache = (None, None)

    def zero(self, k):
        return False

    def d(self, k, c):
        if self.cache[0] is None or self.cache[0] != c:
            self.cache = (c, self.derivs(c))
        return self.cache[1][k]


class Elliptic(Jet):
    def __init__(self, n):
        super().__init__()
        self.k = (n * n - 1) / (n * n)

    def x(self, c):
        return c

    def derivs(self, x):
        S, Cc = tsin(pi, x), tsin(pi, x, pi / 2)
        den = [-self.k * z for z in tmul(S, S)]
        den[0] += 1
        f = tmul(Cc, tpow(den, mpf(-1) / 2))
        s = [-z / 2 for z in f]
        s[0] += mpf(1) / 2
        out, fac = [], mpf(1)
        for i in range(5):
            out.append(s[i] * fac)
            fac *= i + 1
        return out


class Inclined(Jet):
    """x = t - ct sin(2 pi t)/(2 pi), s = t - sin(2 pi t)/(2 pi); coordinate t."""

    def __init__(self, ct):
        super().__init__()
        self.ct = ct

    def x(self, t):
        return t - self.ct * sin(2 * pi * t) / (2 * pi)

    def derivs(self, t):
        sn = tsin(2 * pi, t)
        s = [-z / (2 * pi) for z in sn]
        xx = [-self.ct * z / (2 * pi) for z in sn]
        for q in (s, xx):
            q[0] += t
            q[1] += 1
        xt = tder(xx)
        out, f = [s[0]], s
        for _ in range(4):      # the tail coefficients lost by tder are never used in [0]
            f = tdiv(tder(f), xt)
            out.append(f[0])
        return out


class HalfEllipseV:
    """s' = (4/pi) sqrt(1 - u^2), u = 2x - 1."""
    lo, hi = mpf(0), mpf(1)
    # one-sided limits at the ends: v, a, j, v*a
    ends = {0: (mpf(0), inf, -inf, 32 / pi ** 2), 1: (mpf(0), -inf, -inf, -32 / pi ** 2)}

    def x(self, c):
        return c

    def zero(self, k):
        return False

    def d(self, k, x):
        u = 2 * x - 1
        if k == 0:
            return (u * sqrt(1 - u * u) + asin(u) + pi / 2) / pi
        w = 1 - u * u
        if k == 1:
            return 4 / pi * sqrt(w)
        if k == 2:
            return -8 / pi * u / sqrt(w)
        if k == 3:
            return -16 / pi * w ** (mpf(-3) / 2)
        return -96 / pi * u * w ** (mpf(-5) / 2)


class HalfEllipseA:
    """s'' = (16/pi) sqrt(1 - w^2), w = 4x - 1, on [0, 1/2]; mirrored beyond."""

    def __init__(self, second):
        self.second = second
        self.lo, self.hi = (mpf(1) / 2, mpf(1)) if second else (mpf(0), mpf(1) / 2)
        if second:
            self.ends = {0: (mpf(2), mpf(0), -inf, mpf(0)), 1: (mpf(0), mpf(0), inf, mpf(0))}
        else:
            self.ends = {0: (mpf(0), mpf(0), inf, mpf(0)), 1: (mpf(2), mpf(0), -inf, mpf(0))}

    def x(self, c):
        return c

    def zero(self, k):
        return False

    def d(self, k, x):
        if self.second:
            r = self.half(k, 1 - x)
            return (1 - r) if k == 0 else (r if k % 2 else -r)
        return self.half(k, x)

    def half(self, k, x):
        w = 4 * x - 1
        q = 1 - w * w
        if k == 0:
            return (-q * sqrt(q) / 6 + (w * asin(w) + sqrt(q)) / 2 + pi * w / 4) / pi
        if k == 1:
            return 4 / pi * ((w * sqrt(q) + asin(w)) / 2 + pi / 4)
        if k == 2:
            return 16 / pi * sqrt(q)
        if k == 3:
            return -64 / pi * w / sqrt(q)
        return -256 / pi * q ** (mpf(-3) / 2)


# ---------------------------------------------------------------- builders

def poly(powers, lo=0, hi=1):
    """powers: {exponent: coefficient}"""
    return [Terms(lo, hi, [(c, e) for e, c in powers.items()])]


def pmul(a, b):
    r = [mpf(0)] * (len(a) + len(b) - 1)
    for i, p in enumerate(a):
        for j, q in enumerate(b):
            r[i + j] += p * q
    return r


def padd(a, b, m=1):
    n = max(len(a), len(b))
    g = lambda z, i: z[i] if i < len(z) else mpf(0)
    return [g(a, i) + m * g(b, i) for i in range(n)]


def pint(a):
    return [mpf(0)] + [c / (i + 1) for i, c in enumerate(a)]


def from_velocity(cq):
    """s' = sum cq[i] q^i, q = x(1-x)"""
    q, p, tot = [mpf(0), mpf(1), mpf(-1)], [mpf(1)], [mpf(0)]
    for c in cq:
        tot = padd(tot, [c * z for z in p])
        p = pmul(p, q)
    return poly(dict(enumerate(pint(tot))))


def legendre(coefs):
    """s'' = sum c P_n(u), u = 1 - 2x; coefs {n: c}"""
    u = [mpf(1), mpf(-2)]
    P = [[mpf(1)], u]
    for n in range(1, max(coefs)):
        P.append([z / (n + 1) for z in padd([(2 * n + 1) * z for z in pmul(u, P[n])],
                                            P[n - 1], -n)])
    a = [mpf(0)]
    for n, c in coefs.items():
        a = padd(a, [c * z for z in P[n]])
    return poly(dict(enumerate(pint(pint(a)))))


def stoddart(exps):
    exps = [mpf(e) for e in exps]
    n = len(exps)
    M, b = matrix(n, n), matrix(n, 1)
    b[0] = 1
    for j, e in enumerate(exps):
        f = mpf(1)
        for i in range(n):
            M[i, j] = f
            f *= e - i
    c = lu_solve(M, b)
    for j, e in enumerate(exps):      # the product rule of the notes agrees
        f = mpf(1)
        for g in exps:
            if g != e:
                f *= g / (g - e)
        assert abs(f - c[j]) < EPS * 10 ** 4 * (1 + abs(f))
    return poly({e: c[j] for j, e in enumerate(exps)})


def harmonic_sum(pw, sines):
    return [Terms(0, 1, pw, sines)]


def segments(segs):
    """segs: (duration, kind, a0, a1): 'lin' from a0 to a1; 'qsin' a0 sin(pi t/2T);
    'qcos' a0 cos(pi t/2T); 'hsin' a0 sin(pi t/T).  Starts at s = v = 0."""
    out, s, v, x = [], mpf(0), mpf(0), mpf(0)
    for i, (T, kind, a0, a1) in enumerate(segs):
        T = mpf(T)
        if T == 0:
            continue
        if kind == 'lin':
            sl = (a1 - a0) / T
            pw, sn = [(s, 0), (v, 1), (a0 / 2, 2), (sl / 6, 3)], []
        else:
            w = pi / T if kind == 'hsin' else pi / (2 * T)
            p = pi / 2 if kind == 'qcos' else mpf(0)
            # s'' = a0 sin(w t + p)
            A = -a0 / w ** 2
            pw = [(s - A * sin(p), 0), (v - A * w * cos(p), 1)]
            sn = [(A, w, p)]
        pc = Terms(x, x + T, pw, sn)
        s, v, x = pc.d(0, x + T), pc.d(1, x + T), x + T
        out.append(pc)
    assert abs(x - 1) < EPS
    return out


def end(segs):
    p = segments(segs)[-1]
    return p.d(0, p.hi), p.d(1, p.hi)


def scaled(make):
    """make(Aa) symmetric rest-to-rest law: one amplitude, from s(1) = 1."""
    s, v = end(make(mpf(1)))
    assert abs(v) < EPS
    return segments(make(1 / s))


def scca(a, b, c):
    a, b, c = mpf(a), mpf(b), mpf(c)
    d = 1 - a - b - c
    if abs(d) < EPS:
        d = mpf(0)
    z = mpf(0)

    def make(A):
        half = [(a / 2, 'qsin', A, 0), (b / 2, 'lin', A, A), (c / 2, 'qcos', A, 0)]
        return half + [(d, 'lin', z, z), (c / 2, 'qsin', -A, 0), (b / 2, 'lin', -A, -A),
                       (a / 2, 'qcos', -A, 0)]
    return scaled(make)


def universal(d):
    d = [mpf(z) for z in d]
    z = mpf(0)

    def make(Aa, Ad):
        return [(d[0], 'qsin', Aa, 0), (d[1], 'lin', Aa, Aa), (d[2], 'qcos', Aa, 0),
                (d[3], 'lin', z, z), (d[4], 'qsin', -Ad, 0), (d[5], 'lin', -Ad, -Ad),
                (d[6], 'qcos', -Ad, 0)]
    e10, e01 = end(make(mpf(1), z)), end(make(z, mpf(1)))
    A = lu_solve(matrix([[e10[0], e01[0]], [e10[1], e01[1]]]), matrix([1, 0]))
    return segments(make(A[0], A[1]))


def trapezoidal_velocity(t1, t2):
    v = 1 / (1 - (t1 + t2) / 2)
    z = mpf(0)
    return segments([(t1, 'lin', v / t1, v / t1), (1 - t1 - t2, 'lin', z, z),
                     (t2, 'lin', -v / t2, -v / t2)])


def trapezoidal_acceleration(r, c):
    z, m = mpf(0), 1 - 4 * r - 2 * c
    if abs(m) < EPS:
        m = z
    return scaled(lambda A: [(r, 'lin', z, A), (c, 'lin', A, A), (r, 'lin', A, z), (m, 'lin', z, z),
                             (r, 'lin', z, -A), (c, 'lin', -A, -A), (r, 'lin', -A, z)])


def s_curve(B, C):
    D = C / (1 - 1 / B - B / C)
    tj = C / D
    tc = B / C - tj
    p = trapezoidal_acceleration(tj, tc)
    assert abs(p[0].d(3, 0) - D) < EPS * 10 ** 5
    return p


def two_half(f, c):
    out = []
    h = mpf(1) / 2
    for g in f:
        if g.lo < h:
            out.append(Clip(g, mpf(0), 2 * c, 1 / (2 * c), mpf(0), mpf(0), c))
    e = 1 - c
    for g in f:
        if g.hi > h:      # 1 - (1-x)/(2e)
            out.append(Clip(g, 1 - 2 * e, 2 * e, 1 / (2 * e), 1 - 1 / (2 * e), c, mpf(1)))
    return out


def triple(h, rescale):
    h = [mpf(z) if not isinstance(z, mpf) else z for z in h]
    tot = sum(z / (2 * pi * (n + 1)) for n, z in enumerate(h))
    if rescale:
        h = [z / tot for z in h]
        tot = mpf(1)
    assert abs(tot - 1) < EPS
    return harmonic_sum([(tot, 1)], [(-z / (2 * pi * (n + 1)) ** 2, 2 * pi * (n + 1), 0)
                                     for n, z in enumerate(h)])


def fourier(a):      # {n: a_n}
    return harmonic_sum([(1, 1)], [(-mpf(z) / (2 * pi * n), 2 * pi * n, 0) for n, z in a.items()])


def poly5(alpha):
    return from_velocity([0, 6 + R(6, 10) * alpha, -3 * alpha])


def poly7(A):
    return from_velocity([0, 0, mpf(A), 140 - R(14 * A, 3)])


def cosine():
    return harmonic_sum([(R(1, 2), 0)], [(-R(1, 2), pi, pi / 2)])


def laws():
    L = {}
    p2 = 2 * pi
    L['parabolic'] = segments([(R(1, 2), 'lin', mpf(4), mpf(4)), (R(1, 2), 'lin', mpf(-4), mpf(-4))])
    L['cosine'] = cosine()
    L['cycloidal'] = harmonic_sum([(1, 1)], [(-1 / p2, p2, 0)])
    L['double-harmonic'] = harmonic_sum([(R(1, 2) - R(1, 8), 0)],
                                        [(-R(1, 2), pi, pi / 2), (R(1, 8), p2, pi / 2)])
    L['cubic'] = poly({2: 3, 3: -2})
    L['poly-3-4-5'] = poly({3: 10, 4: -15, 5: 6})
    L['poly-4-5-6-7'] = poly({4: 35, 5: -84, 6: 70, 7: -20})
    L['poly-5-6-7-8-9'] = poly({5: 126, 6: -420, 7: 540, 8: -315, 9: 70})
    L['poly-3-5-7'] = stoddart([3, 5, 7])
    L['poly-4-6-8-10'] = stoddart([4, 6, 8, 10])
    L['rothbart-8'] = poly({3: mpf('6.09755'), 5: mpf('-20.78040'), 6: mpf('26.73155'),
                            7: mpf('-13.60965'), 8: mpf('2.56095')})
    L['quick-return'] = poly({4: 10, 5: -14, 6: 5})
    L['modified-trapezoid'] = scca(R(1, 4), R(1, 2), R(1, 4))
    L['modified-sine'] = scca(R(1, 4), 0, R(3, 4))
    L['modified-sine-cv20'] = scca(R(2, 10), 0, R(6, 10))
    L['modified-sine-cv33'] = scca(R(1, 6), 0, R(1, 2))
    L['modified-sine-cv50'] = scca(R(1, 8), 0, R(3, 8))
    L['lazy-modified-trapezoid'] = scca(R(1, 3), R(1, 3), R(1, 3))
    z = mpf(0)
    L['cycloidal-cv50'] = scaled(lambda A: [(R(1, 4), 'hsin', A, 0), (R(1, 2), 'lin', z, z),
                                            (R(1, 4), 'hsin', -A, 0)])
    L['trapezoidal-acceleration'] = trapezoidal_acceleration(R(1, 8), R(1, 4))
    L['trapezoidal-velocity'] = trapezoidal_velocity(R(1, 3), R(1, 3))
    L['freudenstein-1-3'] = harmonic_sum([(1, 1)], [(-R(27, 28) / p2, p2, 0),
                                                    (-R(1, 84) / p2, 3 * p2, 0)])
    m = R(1125, 1192)
    L['freudenstein-1-3-5'] = harmonic_sum([(1, 1)], [(-m / p2, p2, 0), (-m / 54 / p2, 3 * p2, 0),
                                                      (-m / 1250 / p2, 5 * p2, 0)])
    L['gutman-1-3'] = harmonic_sum([(1, 1)], [(-15 / (32 * pi), p2, 0), (-1 / (96 * pi), 3 * p2, 0)])
    L['half-ellipse-velocity'] = [HalfEllipseV()]
    L['half-ellipse-acceleration'] = [HalfEllipseA(False), HalfEllipseA(True)]
    L['polynomial-5 alpha=-3'] = poly5(-3)
    L['polynomial-5 alpha=-5'] = poly5(-5)
    L['polynomial-7 A=48'] = poly7(48)
    L['polynomial-7 A=6'] = poly7(6)
    # beyond motion_laws.csv
    L['constant-velocity'] = poly({1: 1})
    L['harmonic'] = cosine()
    L['polynomial-5 alpha=-8'] = poly5(-8)
    L['polynomial-5 alpha=-1'] = poly5(-1)
    L['legendre c=0.5,-0.3'] = legendre({1: mpf(6), 3: R(1, 2), 5: -R(3, 10)})
    L['stoddart exponents=4,8,12,16'] = stoddart([4, 8, 12, 16])
    L['stoddart exponents=3,4.5,6'] = stoddart([3, R(9, 2), 6])
    L['scca a=0.3 b=0.2 c=0.3'] = scca(R(3, 10), R(2, 10), R(3, 10))
    L['universal d1=0.1 d2=0.1 d3=0.15 d4=0.05 d5=0.2 d6=0.2 d7=0.2'] = universal(
        [R(1, 10), R(1, 10), R(15, 100), R(5, 100), R(1, 5), R(1, 5), R(1, 5)])
    L['trapezoidal-velocity t1=0.2 t2=0.4'] = trapezoidal_velocity(R(1, 5), R(2, 5))
    L['trapezoidal-acceleration ramp=0.1 constant=0.15'] = trapezoidal_acceleration(R(1, 10), R(15, 100))
    L['s-curve B=1.6 C=5.8'] = s_curve(R(16, 10), R(58, 10))
    L['fourier a=0.1,-0.05'] = fourier({1: R(95, 100), 2: R(1, 10), 3: -R(5, 100)})
    L['triple-harmonic h1=5.1968 h2=1.769 h3=0.6057'] = triple(['5.1968', '1.769', '0.6057'], True)
    L['triple-harmonic zero-jerk'] = triple([9 * pi / 4, mpf(0), -3 * pi / 4], False)
    L['elliptic n=1.3'] = [Elliptic(R(13, 10))]
    L['elliptic n=0.8'] = [Elliptic(R(8, 10))]
    L['inclined-sinusoid angle=82deg'] = [Inclined(cot(82 * pi / 180))]
    L['inclined-sinusoid angle=90deg'] = [Inclined(mpf(0))]
    L['poly-3-4-5 crossover=0.4'] = two_half(L['poly-3-4-5'], R(4, 10))
    L['modified-sine crossover=0.35'] = two_half(L['modified-sine'], R(35, 100))
    return L


# ---------------------------------------------------------------- peaks

# quantity -> (function of piece and coordinate, its derivative up to a positive factor, index)
QUANT = {
    'v': (lambda p, x: p.d(1, x), lambda p, x: p.d(2, x)),
    'a': (lambda p, x: p.d(2, x), lambda p, x: p.d(3, x)),
    'j': (lambda p, x: p.d(3, x), lambda p, x: p.d(4, x)),
    'm': (lambda p, x: p.d(1, x) * p.d(2, x), lambda p, x: p.d(2, x) ** 2 + p.d(1, x) * p.d(3, x)),
}


def bisect(f, a, b, fa):
    for _ in range(175):
        c = (a + b) / 2
        fc = f(c)
        if fc == 0:
            return c
        if (fc > 0) == (fa > 0):
            a = c
        else:
            b = c
    return (a + b) / 2


def extremes(p, which):
    """(max, min) of the quantity over the closed piece (one-sided at its ends)."""
    val, der = QUANT[which]
    idx = 'vajm'.index(which)
    ends = getattr(p, 'ends', None)
    cand = [e[idx] for e in ends.values()] if ends else [val(p, p.lo), val(p, p.hi)]
    if not (which != 'm' and p.zero('vaj'.index(which) + 2)):
        n = SCAN
        xs = [p.lo + (p.hi - p.lo) * mpf(i) / n for i in range(n + 1)]
        if ends:      # keep off the singular ends, closing in on them
            w = (p.hi - p.lo) / n
            near = [w * mpf(10) ** -i for i in range(12, 0, -1)]
            xs = [p.lo + z for z in near] + xs[1:-1] + [p.hi - z for z in reversed(near)]
        px, pf = xs[0], der(p, xs[0])
        for x in xs[1:]:
            fx = der(p, x)
            if fx == 0:
                cand.append(val(p, x))
            elif pf != 0 and (fx > 0) != (pf > 0):
                cand.append(val(p, bisect(lambda c: der(p, c), px, x, pf)))
            px, pf = x, fx
    return max(cand), min(cand)


def clean(z):
    return mpf(0) if not isinf(z) and abs(z) < mpf(10) ** -35 else z


def constants(pieces):
    e = {k: [extremes(p, k) for p in pieces] for k in QUANT}
    hi = {k: clean(max(x[0] for x in e[k])) for k in QUANT}
    lo = {k: clean(min(x[1] for x in e[k])) for k in QUANT}
    return {'B': max(hi['v'], -lo['v']), 'C_max': hi['a'], 'C_min': lo['a'],
            'D_inside_max': hi['j'], 'D_inside_min': lo['j'], 'Cm': max(hi['m'], -lo['m'])}


def check(name, pieces, K):
    tol = mpf(10) ** -38
    a, b = pieces[0], pieces[-1]
    assert abs(a.lo) < tol and abs(b.hi - 1) < tol, name
    assert abs(a.d(0, a.lo)) < tol, name
    assert abs(b.d(0, b.hi) - 1) < tol, (name, b.d(0, b.hi))
    if name == 'constant-velocity':
        assert b.d(1, b.hi) == 1
    else:
        assert abs(a.d(1, a.lo)) < tol, name
        assert abs(b.d(1, b.hi)) < tol, (name, b.d(1, b.hi))
    for p, q in zip(pieces, pieces[1:]):
        assert abs(p.hi - q.lo) < tol, name
        for k in (0, 1):
            assert abs(p.d(k, p.hi) - q.d(k, q.lo)) < tol, (name, k)
    # exact derivatives against numerical ones of s (chain rule for the parametric law)
    for p in pieces:
        for f in (R(2, 7), R(5, 8)):
            c = p.lo + f * (p.hi - p.lo)
            xt = mp.diff(p.x, c)
            for k in range(4):
                nd = mp.diff(lambda t: p.d(k, t), c) / xt
                assert abs(nd - p.d(k + 1, c)) < mpf(10) ** -15 * (1 + abs(nd)), (name, k, c)
    # no sample above the peak
    slack = mpf(10) ** -30
    total = 0
    near = {k: mpf(0) for k in K}
    for p in pieces:
        n = max(300, int(SAMPLE * (p.hi - p.lo)) + 1)
        total += n
        for i in range(n):
            c = p.lo + (p.hi - p.lo) * (mpf(i) + R(1, 2)) / n
            v, acc, j = p.d(1, c), p.d(2, c), p.d(3, c)
            assert abs(v) <= K['B'] + slack, (name, 'B', c)
            assert K['C_min'] - slack <= acc <= K['C_max'] + slack, (name, 'C', c)
            assert K['D_inside_min'] - slack <= j <= K['D_inside_max'] + slack, (name, 'D', c)
            assert abs(v * acc) <= K['Cm'] + slack, (name, 'Cm', c)
            near['B'] = max(near['B'], abs(v))
            near['Cm'] = max(near['Cm'], abs(v * acc))
    assert total >= 4000
    for k in ('B', 'Cm'):
        assert near[k] >= K[k] * R(99, 100), (name, k)


def show(z):
    if isinf(z):
        return 'inf' if z > 0 else '-inf'
    return '0' if z == 0 else nstr(z, 20, strip_zeros=False, min_fixed=-5, max_fixed=30)


COLS = ['B', 'C_max', 'C_min', 'D_inside_max', 'D_inside_min', 'Cm']


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    rows = []
    for name, pieces in laws().items():
        K = constants(pieces)
        with mp.workdps(50):
            check(name, pieces, K)
        rows.append([name] + [show(K[c]) for c in COLS])
    with open(os.path.join(here, 'constants.csv'), 'w', newline='', encoding='utf-8') as f:
        w = csv.writer(f, lineterminator='\n')
        w.writerow(['law'] + COLS)
        w.writerows(rows)
    print(len(rows), 'laws written')


if __name__ == '__main__':
    main()
