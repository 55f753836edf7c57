#!/usr/bin/env python3
# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Computes chiang.csv and marschner.csv, the reference values of the scattering tests, with 40 digits.

    tests/bsdf/reference/oracle.py chiang|marschner ROWS SEED > FILE      (needs python3-mpmath)

Written from the papers with angles and inverse functions, sharing no step with the headers: Bessel functions are
mpmath's, the roots of phi(p, h) come from scanning the width for changes of sign and bisecting. The tables in the
tree are 200 rows of seed 1.
"""
import math
import random
import struct
import sys

from mpmath import asin, atan2, besseli, cos, exp, floor, mp, mpf, pi, sin, sinh, sqrt, tanh

mp.dps = 40


def f32(x):
    return struct.unpack("f", struct.pack("f", float(x)))[0]


def wrapped(x):
    return x - 2 * pi * floor((x + pi) / (2 * pi))


def chiang(h, eta, sigma, beta_m, beta_n, alpha_deg, wo, wi):
    """f for three channels and the density; the fits' constants are the nearest floats."""
    wide = lambda text: mpf(f32(text))
    alpha = alpha_deg * pi / 180
    so, si = wo[0], wi[0]
    co, ci = sqrt(1 - so**2), sqrt(1 - si**2)
    theta_o = asin(so)
    phi = atan2(wi[2], wi[1]) - atan2(wo[2], wo[1])
    gamma_o, gamma_t = asin(h), asin(h * co / sqrt(eta**2 - so**2))
    cos_t = sqrt(1 - (so / eta) ** 2)
    c = co * sqrt(1 - h**2)
    g = sqrt(eta**2 - 1 + c**2)
    fresnel = (((c - g) / (c + g)) ** 2 + ((eta**2 * c - g) / (eta**2 * c + g)) ** 2) / 2
    v = (wide(0.726) * beta_m + wide(0.812) * beta_m**2 + wide(3.7) * beta_m**20) ** 2
    variances = [v, v / 4, 4 * v, 4 * v]
    s = wide(sqrt(pi / 8)) * (wide(0.265) * beta_n + wide(1.194) * beta_n**2 + wide(5.372) * beta_n**22)
    paths = []
    for k in range(3):
        t = exp(-sigma[k] * 2 * cos(gamma_t) / cos_t)
        one = (1 - fresnel) ** 2 * t
        two = one * t * fresnel
        rest = 1 - t * fresnel
        paths.append([fresnel, one, two, two * fresnel * t / rest if rest != 0 else mpf(0)])
    weights = [sum(path[p] for path in paths) for p in range(4)]
    value, density = [mpf(0)] * 3, mpf(0)
    for p, tilt in enumerate([-2 * alpha, alpha, 4 * alpha, mpf(0)]):
        sp, cp, v = sin(theta_o + tilt), abs(cos(theta_o + tilt)), variances[p]
        m = exp(-si * sp / v) * besseli(0, ci * cp / v) / (2 * v * sinh(1 / v))
        n = 1 / (2 * pi)
        if p < 3:
            x = wrapped(phi - (2 * p * gamma_t - 2 * gamma_o + p * pi))
            e = exp(-abs(x) / s)
            n = e / (s * (1 + e) ** 2) / tanh(pi / (2 * s))
        for k in range(3):
            value[k] += m * n * paths[k][p] / abs(wi[2])
        density += m * n * weights[p] / sum(weights)
    return value + [density]


def direction(draw):
    z, phi = draw.uniform(-1, 1), draw.uniform(-math.pi, math.pi)
    r = math.sqrt(1 - z * z)
    return [f32(z), f32(r * math.cos(phi)), f32(r * math.sin(phi))]


def chiang_rows(count, draw):
    print("h,eta,sigma_a0,sigma_a1,sigma_a2,beta_m,beta_n,alpha_deg,wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,f0,f1,f2,pdf")
    for row in range(count):
        h = f32(draw.choice([draw.uniform(-1, 1), draw.choice([-1, 1]) * (1 - 10 ** draw.uniform(-7, -1))]))
        eta = f32(draw.choice([1.55, draw.uniform(1.3, 1.8)]))
        sigma = [f32(draw.choice([0, 10 ** draw.uniform(-3, 0.7)])) for _ in range(3)]
        rough = [f32(draw.choice([draw.uniform(0.07, 1), draw.uniform(0.07, 0.2)])) for _ in range(2)]
        tilt = f32(draw.choice([2, draw.uniform(-10, 10)]))
        wo, wi = direction(draw), direction(draw)
        if row % 5 == 0:  # grazing
            x = f32(draw.choice([-1, 1]) * (1 - 10 ** draw.uniform(-5, -2)))
            wo = [x] + [f32(c * math.sqrt((1 - x * x) / (wo[1] ** 2 + wo[2] ** 2))) for c in wo[1:]]
        if row % 2 == 0:  # by the mirror cone, where the light is
            x = max(-0.9999, min(0.9999, -wo[0] + draw.gauss(0, rough[0] / 2)))
            scale = math.sqrt((1 - x * x) / (wi[1] ** 2 + wi[2] ** 2))
            wi = [f32(x), f32(wi[1] * scale), f32(wi[2] * scale)]
        exact = lambda values: [mpf(x) for x in values]
        out = chiang(mpf(h), mpf(eta), exact(sigma), mpf(rough[0]), mpf(rough[1]), mpf(tilt), exact(wo), exact(wi))
        inputs = [h, eta] + sigma + rough + [tilt] + wo + wi
        print(",".join(["%.9g" % x for x in inputs] + ["%.17g" % float(x) for x in out]))


def roots(path, phi, eta):
    """All h with phi(path, h) = phi mod 2 pi, by a scan of sin-spaced offsets and bisection."""
    def residual(gamma, exact=True):
        if exact:
            return 2 * path * asin(sin(gamma) / eta) - 2 * gamma + path * pi - phi
        return 2 * path * math.asin(math.sin(gamma) / float(eta)) - 2 * gamma + path * math.pi - float(phi)
    found = []
    steps = 4000
    grid = [-math.pi / 2 + math.pi * k / steps for k in range(steps + 1)]
    coarse = [residual(g, False) for g in grid]
    for turn in range(-3, 4):
        for k in range(steps):
            a, b = coarse[k] - 2 * math.pi * turn, coarse[k + 1] - 2 * math.pi * turn
            if a * b > 0 and min(abs(a), abs(b)) > 1e-9:
                continue
            low, high = mpf(grid[k]), mpf(grid[k + 1])
            low, high = max(low, -pi / 2), min(high, pi / 2)
            fl, fh = residual(low) - 2 * pi * turn, residual(high) - 2 * pi * turn
            if fl * fh >= 0:
                continue
            for _ in range(110):
                middle = (low + high) / 2
                fm = residual(middle) - 2 * pi * turn
                low, high, fl = (middle, high, fm) if fl * fm > 0 else (low, middle, fl)
            found.append(low)
    return found


def marschner(theta_i, theta_r, phi, eta, sigma, alpha, beta):
    theta_h, theta_d = (theta_i + theta_r) / 2, (theta_r - theta_i) / 2
    m = []
    for shift, width in [(alpha, beta), (-alpha / 2, beta / 2), (-3 * alpha / 2, 2 * beta)]:
        m.append(exp(-((theta_h - shift) / width) ** 2 / 2) / (width * sqrt(2 * pi)))
    bent = sqrt(eta**2 - sin(theta_d) ** 2)
    eta_s, eta_p = bent / cos(theta_d), eta**2 * cos(theta_d) / bent
    sigma_path = sigma / sqrt(1 - (sin(theta_d) / eta) ** 2)
    n, trt = [], []
    for path in range(3):
        total = mpf(0)
        for gamma in roots(path, phi, eta_s):
            h, ci = sin(gamma), cos(gamma)
            ct = sqrt(1 - (h / eta_s) ** 2)
            r_s, r_p = (ci - eta_s * ct) / (ci + eta_s * ct), (eta_p * ci - ct) / (eta_p * ci + ct)
            fresnel = (r_s**2 + r_p**2) / 2
            t = exp(-2 * sigma_path * ct)
            a = fresnel if path == 0 else (1 - fresnel) ** 2 * fresnel ** (path - 1) * t**path
            slope = 2 * path / (eta_s * ct) - 2 / ci
            total += a / abs(2 * slope)
            if path == 2:
                trt.append(abs(slope))
        n.append(total)
    s = sum(a * b for a, b in zip(m, n)) / cos(theta_d) ** 2
    return m + n + [s], trt


def marschner_rows(count, draw):
    print("theta_i,theta_r,phi,eta,sigma_a,alpha_R,beta_R,M_R,M_TT,M_TRT,N_R,N_TT,N_TRT,S,"
          "roots_TRT,min_abs_dphi_dh_TRT,caustic_flag")
    for _ in range(count):
        theta_i = draw.uniform(-1.4, 1.4)
        theta_r = draw.choice([draw.uniform(-1.4, 1.4), max(-1.4, min(1.4, -theta_i + draw.gauss(0, 0.2)))])
        phi = draw.choice([draw.uniform(-math.pi, math.pi), draw.uniform(-0.5, 0.5), draw.uniform(-0.02, 0.02)])
        eta = draw.choice([1.55, draw.uniform(1.3, 1.9), draw.uniform(1.1, 1.4)])
        sigma = draw.choice([0, 0.2, 0.8, 2, 10 ** draw.uniform(-3, 0.5)])
        alpha, beta = math.radians(draw.uniform(-10, -5)), math.radians(draw.uniform(5, 10))
        inputs = [theta_i, theta_r, phi, eta, sigma, alpha, beta]
        out, slopes = marschner(*[mpf(x) for x in inputs])
        least = min(slopes, default=mpf(-1))
        flag = int(0 <= least < 0.2)
        cells = ["%.17g" % x for x in inputs] + ["-1" if flag else "%.17g" % float(x) for x in out]
        print(",".join(cells + [str(len(slopes)), "%.9g" % float(least), str(flag)]))


if __name__ == "__main__":
    model, rows, seed = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    {"chiang": chiang_rows, "marschner": marschner_rows}[model](rows, random.Random(seed))
