#!/usr/bin/env python3
"""Writes the vehicle models of assets/models: low-poly solids in metres, x right, y up, -z forward, standing on y = 0.

    scripts/make_models.py            writes the files
    scripts/make_models.py --check    exits 1 if a file is not what this script writes

Every solid is convex, so its facets are turned outwards by themselves. Materials are roles, not colours: `body` is painted by
side, `accent` carries the side's colour. An object called NAME@x,y,z turns around that point: `turret` with the azimuth, `tube`
with azimuth and elevation.
"""
import math
import pathlib
import sys

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "assets" / "models"
MATERIALS = {"body": (0.36, 0.40, 0.26), "dark": (0.16, 0.17, 0.15), "rubber": (0.09, 0.09, 0.09), "glass": (0.12, 0.17, 0.21),
             "metal": (0.30, 0.31, 0.30), "canvas": (0.42, 0.40, 0.28), "skin": (0.62, 0.46, 0.35), "accent": (1.0, 1.0, 1.0), "brass": (0.55, 0.44, 0.20),
             "brick": (0.56, 0.38, 0.30), "plaster": (0.72, 0.67, 0.57), "concrete": (0.55, 0.54, 0.51), "tile": (0.46, 0.25, 0.19)}


class Model:
    def __init__(self, name):
        self.name, self.objects = name, []

    def part(self, name, pivot=None):
        self.pivot = pivot
        label = name if pivot is None else "%s@%g,%g,%g" % ((name,) + pivot)
        self.objects.append((label, []))
        return self

    def solid(self, points, faces, material):
        centre = [sum(p[k] for p in points) / len(points) for k in range(3)]
        out = []
        for face in faces:
            a, b, c = (points[i] for i in face[:3])
            u, v = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
            n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            outwards = sum(n[k] * (a[k] - centre[k]) for k in range(3))
            out.append([points[i] for i in (face if outwards >= 0 else face[::-1])])
        self.objects[-1][1].append((material, out))
        return self

    def frustum(self, bottom, top, y0, y1, material):
        """Bottom and top rectangles (x0, x1, z0, z1) at heights y0 and y1."""
        def ring(r, y):
            return [(r[0], y, r[2]), (r[1], y, r[2]), (r[1], y, r[3]), (r[0], y, r[3])]
        return self.solid(ring(bottom, y0) + ring(top, y1), [(0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)], material)

    def box(self, x0, x1, y0, y1, z0, z1, material):
        return self.frustum((x0, x1, z0, z1), (x0, x1, z0, z1), y0, y1, material)

    def prism(self, profile, x0, x1, material):
        """A convex outline of (z, y) points drawn out from x0 to x1."""
        n = len(profile)
        points = [(x0, y, z) for z, y in profile] + [(x1, y, z) for z, y in profile]
        faces = [tuple(range(n)), tuple(range(n, 2 * n))] + [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
        return self.solid(points, faces, material)

    def wheel(self, x0, x1, y, z, radius, material="rubber", sides=10):
        return self.prism([(z + radius * math.cos(2 * math.pi * i / sides), y + radius * math.sin(2 * math.pi * i / sides)) for i in range(sides)], x0, x1, material)

    def rod(self, a, b, ra, rb, material, sides=8):
        """A cone's frustum from a to b."""
        axis = [b[k] - a[k] for k in range(3)]
        size = math.sqrt(sum(c * c for c in axis))
        axis = [c / size for c in axis]
        helper = (0.0, 1.0, 0.0) if abs(axis[1]) < 0.9 else (1.0, 0.0, 0.0)
        u = (axis[1] * helper[2] - axis[2] * helper[1], axis[2] * helper[0] - axis[0] * helper[2], axis[0] * helper[1] - axis[1] * helper[0])
        size = math.sqrt(sum(c * c for c in u))
        u = [c / size for c in u]
        v = (axis[1] * u[2] - axis[2] * u[1], axis[2] * u[0] - axis[0] * u[2], axis[0] * u[1] - axis[1] * u[0])
        points = []
        for centre, radius in ((a, ra), (b, rb)):
            for i in range(sides):
                c, s = math.cos(2 * math.pi * i / sides), math.sin(2 * math.pi * i / sides)
                points.append(tuple(centre[k] + radius * (c * u[k] + s * v[k]) for k in range(3)))
        faces = [tuple(range(sides)), tuple(range(sides, 2 * sides))] + [(i, (i + 1) % sides, sides + (i + 1) % sides, sides + i) for i in range(sides)]
        return self.solid(points, faces, material)

    def text(self):
        lines = ["# Written by scripts/make_models.py; change it there.", "mtllib palette.mtl"]
        numbers, vertices, body = {}, [], []
        for label, solids in self.objects:
            body.append("o " + label)
            material_now = None
            for material, faces in solids:
                if material != material_now:
                    body.append("usemtl " + material)
                    material_now = material
                for face in faces:
                    row = []
                    for point in face:
                        # Adding 0 turns -0 into 0.
                        key = tuple(round(c, 4) + 0.0 for c in point)
                        if key not in numbers:
                            numbers[key] = len(numbers) + 1
                            vertices.append("v %g %g %g" % key)
                        if not row or row[-1] != numbers[key]:
                            row.append(numbers[key])
                    if len(set(row)) >= 3:
                        body.append("f " + " ".join(map(str, row)))
        return "\n".join(lines + vertices + body) + "\n"


def tracks(m, half_width, width, length, height):
    a, h = 0.5 * length, height
    outline = [(-a + 0.25 * h, 0.0), (a - 0.25 * h, 0.0), (a, 0.45 * h), (a - 0.12 * h, 0.85 * h), (a - 0.5 * h, h), (-a + 0.5 * h, h), (-a + 0.12 * h, 0.85 * h), (-a, 0.45 * h)]
    for side in (-1, 1):
        x = sorted((side * half_width, side * (half_width - width)))
        m.prism(outline, x[0], x[1], "rubber")
        for i in range(5):
            z = (i - 2) * 0.19 * length
            m.wheel(*sorted((side * (half_width + 0.02), side * (half_width - 0.2))), 0.38 * h, z, 0.34 * h, "dark", 8)


def tank():
    m = Model("tank").part("hull")
    tracks(m, 1.75, 0.58, 6.7, 0.95)
    m.prism([(-3.45, 0.95), (-2.1, 1.42), (3.2, 1.42), (3.35, 1.0), (3.0, 0.5), (-2.9, 0.5)], -1.18, 1.18, "body")
    m.box(-1.78, 1.78, 0.97, 1.12, -3.0, 3.2, "body")
    m.part("turret", (0.0, 1.42, -0.1))
    m.frustum((-1.25, 1.25, -1.5, 1.5), (-0.85, 0.85, -0.75, 1.2), 1.42, 2.12, "body")
    m.box(-0.75, 0.75, 2.12, 2.17, -0.2, 0.9, "accent")
    m.wheel(0.25, 0.75, 2.2, 0.2, 0.24, "dark", 8)
    m.box(-1.3, 1.3, 1.55, 1.95, 1.45, 2.05, "dark")
    m.part("tube", (0.0, 1.75, -1.2))
    m.rod((0.0, 1.75, -1.0), (0.0, 1.75, -4.6), 0.12, 0.10, "metal")
    m.rod((0.0, 1.75, -4.6), (0.0, 1.75, -6.1), 0.09, 0.09, "metal")
    m.rod((0.0, 1.75, -3.0), (0.0, 1.75, -3.7), 0.15, 0.15, "dark")
    return m


def ifv():
    m = Model("ifv").part("hull")
    tracks(m, 1.45, 0.40, 6.0, 0.85)
    m.prism([(-3.35, 1.0), (-1.3, 1.5), (3.1, 1.55), (3.2, 0.6), (2.9, 0.45), (-2.9, 0.5)], -1.42, 1.42, "body")
    m.box(-1.0, -0.1, 1.55, 1.60, 1.2, 3.0, "accent").box(0.1, 1.0, 1.55, 1.60, 1.2, 3.0, "accent")
    m.part("turret", (0.0, 1.5, 0.1))
    m.frustum((-0.85, 0.85, -0.85, 0.95), (-0.5, 0.5, -0.45, 0.6), 1.52, 2.0, "body")
    m.wheel(-0.2, 0.25, 2.02, 0.1, 0.2, "dark", 8)
    m.part("tube", (0.0, 1.75, -0.6))
    m.rod((0.0, 1.75, -0.5), (0.0, 1.75, -2.2), 0.08, 0.07, "metal")
    m.rod((0.0, 2.02, 0.1), (0.0, 2.02, -1.1), 0.07, 0.07, "canvas")
    return m


def truck():
    m = Model("truck").part("hull")
    for z in (-2.35, 1.1, 2.4):
        for side in (-1, 1):
            m.wheel(*sorted((side * 1.2, side * 0.85)), 0.55, z, 0.55)
    m.box(-0.9, 0.9, 0.6, 0.9, -3.2, 3.3, "dark")
    m.prism([(-3.3, 0.75), (-3.3, 1.55), (-2.2, 1.7), (-1.95, 2.55), (-0.75, 2.6), (-0.75, 0.75)], -1.15, 1.15, "body")
    m.prism([(-2.17, 1.75), (-1.98, 2.42), (-1.96, 2.42), (-2.12, 1.75)], -1.0, 1.0, "glass")
    m.box(-1.17, 1.17, 1.75, 2.35, -1.75, -1.05, "glass")
    m.box(-1.2, 1.2, 0.95, 1.35, -0.55, 3.3, "body")
    m.prism([(-0.5, 1.35), (-0.5, 2.7), (3.25, 2.7), (3.25, 1.35)], -1.15, 1.15, "canvas")
    m.prism([(-0.5, 2.7), (-0.4, 2.85), (3.15, 2.85), (3.25, 2.7)], -0.8, 0.8, "canvas")
    m.box(-0.7, 0.7, 2.85, 2.90, 0.4, 2.4, "accent")
    return m


def m577():
    m = Model("m577").part("hull")
    tracks(m, 1.34, 0.42, 4.6, 0.85)
    m.prism([(-2.4, 0.75), (-2.3, 1.35), (-1.35, 1.75), (2.4, 1.75), (2.4, 0.55), (-2.1, 0.45)], -1.3, 1.3, "body")
    m.prism([(-0.95, 1.75), (-0.75, 2.55), (2.4, 2.6), (2.4, 1.75)], -1.28, 1.28, "body")
    m.box(-0.6, 0.6, 2.6, 2.65, 0.4, 1.9, "accent")
    m.box(-0.5, 0.5, 2.45, 2.80, -0.55, 0.1, "dark")
    m.rod((-1.1, 2.6, 2.2), (-1.1, 6.0, 2.35), 0.045, 0.02, "dark", 5).rod((1.1, 2.6, 2.2), (1.1, 6.6, 2.3), 0.045, 0.02, "dark", 5)
    return m


def howitzer():
    m = Model("howitzer").part("hull")
    tracks(m, 1.55, 0.42, 6.1, 0.9)
    m.prism([(-3.2, 0.95), (-2.5, 1.6), (3.0, 1.6), (3.1, 0.7), (2.8, 0.5), (-2.8, 0.5)], -1.52, 1.52, "body")
    m.part("turret", (0.0, 1.6, 1.0))
    m.frustum((-1.5, 1.5, -1.0, 3.0), (-1.1, 1.1, -0.55, 2.8), 1.6, 2.85, "body")
    m.box(-0.9, 0.9, 2.85, 2.90, 0.3, 2.2, "accent")
    m.wheel(0.3, 0.95, 2.9, 0.4, 0.28, "dark", 8)
    m.part("tube", (0.0, 2.15, -0.3))
    m.box(-0.42, 0.42, 1.75, 2.55, -1.25, 0.0, "dark")
    m.rod((0.0, 2.15, -1.0), (0.0, 2.15, -5.4), 0.16, 0.12, "metal")
    m.rod((0.0, 2.15, -5.4), (0.0, 2.15, -6.1), 0.21, 0.21, "dark")
    return m


def car():
    m = Model("car").part("hull")
    for z in (-1.45, 1.4):
        for side in (-1, 1):
            m.wheel(*sorted((side * 1.0, side * 0.72)), 0.42, z, 0.42)
    m.prism([(-2.2, 0.55), (-2.2, 1.1), (-0.8, 1.2), (2.15, 1.2), (2.15, 0.5)], -0.95, 0.95, "body")
    m.prism([(-0.75, 1.2), (-0.35, 1.85), (1.9, 1.85), (2.1, 1.2)], -0.88, 0.88, "glass")
    m.box(-0.86, 0.86, 1.85, 1.91, -0.3, 1.85, "body")
    m.box(-0.45, 0.45, 1.91, 1.95, 0.1, 1.5, "accent")
    return m


def figure(m, x, z, height=1.8, kneeling=False, heading=0.0):
    c, s = math.cos(heading), math.sin(heading)

    def place(p):
        return (x + c * p[0] - s * p[2], p[1], z + s * p[0] + c * p[2])

    def box(x0, x1, y0, y1, z0, z1, material):
        corners = [place(p) for p in ((x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1), (x0, y1, z0), (x1, y1, z0), (x1, y1, z1), (x0, y1, z1))]
        m.solid(corners, [(0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)], material)
    low = 0.55 if kneeling else 0.85
    k = height / 1.8
    box(-0.2, -0.03, 0.0, low * k, -0.1, 0.12, "dark")
    box(0.03, 0.2, 0.0, low * k, -0.1, 0.12, "dark")
    box(-0.24, 0.24, low * k, (low + 0.6) * k, -0.14, 0.14, "body")
    box(-0.34, -0.24, (low + 0.05) * k, (low + 0.58) * k, -0.12, 0.1, "body")
    box(0.24, 0.34, (low + 0.05) * k, (low + 0.58) * k, -0.12, 0.1, "body")
    box(-0.1, 0.1, (low + 0.6) * k, (low + 0.8) * k, -0.1, 0.12, "skin")
    box(-0.15, 0.15, (low + 0.76) * k, (low + 0.93) * k, -0.15, 0.17, "accent")
    return low * k


def squad():
    m = Model("squad").part("hull")
    places = [(-2.6, -2.2), (-0.4, -3.0), (1.9, -1.9), (-3.0, 0.6), (0.3, -0.2), (2.9, 0.7), (-1.2, 2.3), (1.5, 2.8)]
    for i, (x, z) in enumerate(places):
        low = figure(m, x, z, 1.75 + 0.04 * (i % 3), i % 3 == 1, 0.25 * ((i * 5) % 7 - 3))
        m.rod((x + 0.25, low + 0.2, z + 0.1), (x + 0.2, low + 0.45, z - 0.75), 0.035, 0.03, "dark", 5)
    return m


def observer():
    m = Model("observer").part("hull")
    low = figure(m, 0.0, 0.0)
    m.box(-0.30, -0.18, low + 0.45, low + 0.62, -0.42, 0.0, "body").box(0.18, 0.30, low + 0.45, low + 0.62, -0.42, 0.0, "body")
    m.box(-0.13, -0.02, low + 0.62, low + 0.72, -0.42, -0.12, "dark").box(0.02, 0.13, low + 0.62, low + 0.72, -0.42, -0.12, "dark")
    m.box(-0.22, 0.22, low + 0.05, low + 0.5, 0.14, 0.36, "canvas")
    m.rod((0.18, low + 0.5, 0.25), (0.2, low + 1.7, 0.3), 0.02, 0.01, "dark", 5)
    return m


def shell():
    m = Model("shell").part("hull")
    # A 155 mm projectile, its nose along -z.
    outline = [(0.30, 0.062), (0.22, 0.0775), (-0.05, 0.0775), (-0.22, 0.06), (-0.33, 0.038), (-0.40, 0.012)]
    for (z0, r0), (z1, r1), material in zip(outline, outline[1:], ("body", "body", "body", "accent", "brass")):
        m.rod((0.0, 0.0, z0), (0.0, 0.0, z1), r0, r1, material, 10)
    m.rod((0.0, 0.0, 0.235), (0.0, 0.0, 0.205), 0.081, 0.081, "brass", 10)
    return m


def boat():
    m = Model("boat").part("hull")
    keel = [(-1.5, 0.9, 4.5), (1.5, 0.9, 4.5), (1.7, 0.9, -1.0), (0.0, 1.2, -6.0), (-1.7, 0.9, -1.0), (-1.1, -0.4, 4.4), (1.1, -0.4, 4.4), (0.9, -0.4, -2.0), (0.0, -0.4, -4.4), (-0.9, -0.4, -2.0)]
    m.solid(keel, [(0, 1, 2, 3, 4), (5, 6, 7, 8, 9), (0, 1, 6, 5), (1, 2, 7, 6), (2, 3, 8, 7), (3, 4, 9, 8), (4, 0, 5, 9)], "body")
    m.frustum((-1.0, 1.0, -1.5, 2.2), (-0.8, 0.8, -0.8, 2.0), 0.9, 2.5, "body")
    m.frustum((-1.01, 1.01, -1.42, 1.0), (-0.86, 0.86, -1.0, 1.0), 1.6, 2.2, "glass")
    m.box(-0.6, 0.6, 2.5, 2.56, -0.4, 1.6, "accent")
    m.rod((0.0, 2.5, 1.6), (0.0, 5.2, 1.8), 0.06, 0.03, "dark", 5)
    return m


def helicopter():
    m = Model("helicopter").part("hull")
    m.prism([(-4.2, 1.3), (-3.4, 2.1), (-1.8, 2.7), (2.0, 2.7), (2.6, 1.9), (1.6, 0.7), (-3.0, 0.6)], -0.95, 0.95, "body")
    m.prism([(-4.1, 1.45), (-3.4, 2.05), (-1.9, 2.6), (-1.7, 1.5)], -0.98, 0.98, "glass")
    m.rod((0.0, 2.1, 2.2), (0.0, 2.5, 8.2), 0.45, 0.16, "body")
    m.prism([(7.6, 2.4), (8.3, 4.1), (8.8, 4.1), (8.5, 2.4)], -0.08, 0.08, "accent")
    m.box(-6.4, 6.4, 3.25, 3.30, -0.25, 0.25, "dark").box(-0.25, 0.25, 3.25, 3.30, -6.4, 6.4, "dark")
    m.rod((0.0, 2.6, 0.0), (0.0, 3.3, 0.0), 0.25, 0.18, "dark")
    m.box(-1.3, -1.15, 0.0, 0.1, -2.6, 2.2, "dark").box(1.15, 1.3, 0.0, 0.1, -2.6, 2.2, "dark")
    m.box(-1.28, -1.18, 0.1, 0.8, -1.4, -1.2, "dark").box(1.18, 1.28, 0.1, 0.8, -1.4, -1.2, "dark").box(-1.28, -1.18, 0.1, 0.8, 1.0, 1.2, "dark").box(1.18, 1.28, 0.1, 0.8, 1.0, 1.2, "dark")
    return m


def storey(m, y0, y1, x, z, thick, material, windows_x, windows_z):
    """Four walls around a floor of 2x by 2z, with windows: piers from floor to ceiling, and what is under and over the openings."""
    sill, lintel, wide = y0 + 0.30 * (y1 - y0), y0 + 0.72 * (y1 - y0), 1.3

    def wall(half, windows, box):
        gap = 2 * half / windows
        edges = [-half] + [e for i in range(windows) for e in (-half + (i + 0.5) * gap - wide / 2, -half + (i + 0.5) * gap + wide / 2)] + [half]
        for i in range(0, len(edges), 2):
            box(edges[i], edges[i + 1], y0, y1, material)
        for i in range(1, len(edges) - 1, 2):
            box(edges[i], edges[i + 1], y0, sill, material)
            box(edges[i], edges[i + 1], lintel, y1, material)
    for side in (-1, 1):
        a, b = sorted((side * z, side * (z - thick)))
        c, d = sorted((side * x, side * (x - thick)))
        wall(x, windows_x, lambda u, v, p, q, mat: m.box(u, v, p, q, a, b, mat))
        wall(z - thick, windows_z, lambda u, v, p, q, mat: m.box(c, d, p, q, u, v, mat))


def house():
    """A house of two storeys, of masonry, to be brought down."""
    m = Model("house").part("hull")
    x, z = 6.0, 3.75
    m.box(-x - 0.15, x + 0.15, 0.0, 0.25, -z - 0.15, z + 0.15, "concrete")
    storey(m, 0.25, 3.2, x, z, 0.45, "plaster", 4, 2)
    m.box(-x - 0.1, x + 0.1, 3.2, 3.45, -z - 0.1, z + 0.1, "concrete")
    storey(m, 3.45, 6.2, x, z, 0.40, "brick", 4, 2)
    m.box(-x - 0.2, x + 0.2, 6.2, 6.4, -z - 0.2, z + 0.2, "concrete")
    for side in (-1, 1):
        gable = sorted((side * x, side * (x - 0.4)))
        m.prism([(-z, 6.4), (0.0, 8.6), (z, 6.4)], gable[0], gable[1], "brick")
        # A slope of the roof: its underside lies on the gables.
        outline = [(side * (z + 0.5), 6.4 - 0.29), (0.0, 8.6), (0.0, 8.85), (side * (z + 0.5), 6.4 - 0.04)]
        m.prism(outline, -x - 0.3, x + 0.3, "tile")
    m.box(-3.9, -3.2, 8.0, 9.6, -1.2, -0.5, "brick")
    return m


def block():
    """What stands for a vehicle that is a few pixels large."""
    m = Model("block").part("hull")
    m.frustum((-0.5, 0.5, -0.5, 0.5), (-0.42, 0.42, -0.38, 0.42), 0.0, 0.72, "body")
    m.frustum((-0.34, 0.34, -0.24, 0.3), (-0.3, 0.3, -0.2, 0.26), 0.72, 1.0, "accent")
    return m


def main():
    files = {model.name + ".obj": model.text() for model in (tank(), ifv(), truck(), m577(), howitzer(), car(), squad(), observer(), shell(), boat(), helicopter(), block(), house())}
    files["palette.mtl"] = "# Written by scripts/make_models.py; change it there.\n" + "".join("newmtl %s\nKd %g %g %g\n" % ((name,) + colour) for name, colour in MATERIALS.items())
    if "--check" in sys.argv[1:]:
        wrong = [name for name, text in files.items() if not (FOLDER / name).exists() or (FOLDER / name).read_text() != text]
        if wrong:
            sys.exit("not what scripts/make_models.py writes: " + ", ".join(wrong) + "\n  Change the script and run it.")
        return
    FOLDER.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        (FOLDER / name).write_text(text)


if __name__ == "__main__":
    main()
