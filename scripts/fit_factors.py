#!/usr/bin/env python3
"""Fits the factors of the charges in assets/projectiles/m107.json to published firing-table values.

    scripts/fit_factors.py NPSEE            shows the fit and its residuals
    scripts/fit_factors.py NPSEE --write    and writes the factors into the projectile file
    scripts/fit_factors.py NPSEE --check    exit 1 unless the file already holds them

NPSEE is the built program; every impact is one `npsee fly`. Gauss-Newton on the residuals in CEPs (thesis rows) or in per cent of
range and tenths of drift (rows without a CEP), numbers rounded to four decimals. Which numbers are free is in PLAN below: per
charge fewer than there are data. docs/physics.md discusses the result.
"""
import json
import math
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SHELL = ROOT / "assets/projectiles/m107.json"
THESIS = ROOT / "assets/firing_tables/thesis_1993.json"
LIM = ROOT / "assets/firing_tables/ft_155_am_2.json"

# charge: (source key, powers of QE in the form factor, powers in the lift factor)
PLAN = {"3W": ("THESIS", 2, 1), "7W": ("THESIS", 3, 1), "4W": ("LIM2016", 1, 1), "6W": ("LIM2016", 1, 1)}


def rows_of(charge, source):
    """(elevation mil, range m, drift m, scale of the range error m, scale of the drift error m)"""
    if source == "THESIS":
        table = json.loads(THESIS.read_text())["rows"]
        return [(r["elevation_mil"], r["firing_table"]["range_m"], r["firing_table"]["deflection_m"], r["cep_m"], r["cep_m"]) for r in table if r["charge"] == charge]
    table = json.loads(LIM.read_text())["rows"]
    return [(r["elevation_mil"], r["range_m"], r["drift_m"], 0.01 * r["range_m"], 0.1 * r["drift_m"]) for r in table if r["charge"] == charge]


def polynomial(numbers, mil):
    return sum(c * (mil / 1000.0) ** k for k, c in enumerate(numbers))


def impact(npsee, charge, mil, form, lift):
    out = subprocess.run([npsee, "fly", "--projectile", str(SHELL), "--charge", charge, "--qe", f"{mil}mil", "--json", "--tolerance", "1e-7", "--set", f"form={form!r}", "--set", f"lift={lift!r}"],
                         capture_output=True, text=True, check=True)
    flight = json.loads(out.stdout)
    return flight["range_m"], flight["drift_m"]


def residuals(npsee, charge, rows, forms, numbers):
    out = []
    for mil, range_m, drift_m, range_scale, drift_scale in rows:
        r, d = impact(npsee, charge, mil, polynomial(numbers[:forms], mil), polynomial(numbers[forms:], mil))
        out += [(r - range_m) / range_scale, (d - drift_m) / drift_scale]
    return out


def solve(matrix, vector):
    """Gaussian elimination with pivoting."""
    n = len(vector)
    rows = [list(matrix[i]) + [vector[i]] for i in range(n)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(i + 1, n):
            factor = rows[k][i] / rows[i][i]
            rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i])]
    out = [0.0] * n
    for i in reversed(range(n)):
        out[i] = (rows[i][n] - sum(rows[i][k] * out[k] for k in range(i + 1, n))) / rows[i][i]
    return out


def fit(npsee, charge, source, forms, lifts):
    rows = rows_of(charge, source)
    numbers = [1.0] + [0.0] * (forms - 1) + [1.0] + [0.0] * (lifts - 1)
    assert len(numbers) < 2 * len(rows), "more free numbers than data"
    for _ in range(12):
        r0 = residuals(npsee, charge, rows, forms, numbers)
        columns = []
        for k in range(len(numbers)):
            moved = list(numbers)
            moved[k] += 1e-3
            columns.append([(a - b) / 1e-3 for a, b in zip(residuals(npsee, charge, rows, forms, moved), r0)])
        normal = [[sum(a * b for a, b in zip(p, q)) for q in columns] for p in columns]
        step = solve(normal, [-sum(a * b for a, b in zip(p, r0)) for p in columns])
        numbers = [a + b for a, b in zip(numbers, step)]
        if max(map(abs, step)) < 1e-6:
            break
    return [round(x, 4) for x in numbers], rows


def written(value, indent=0):
    """JSON as `npsee` writes projectiles: objects over lines, lists of numbers on one."""
    spread = value and (isinstance(value, dict) or (isinstance(value, list) and isinstance(value[0], (dict, list))))
    if not spread:
        return json.dumps(value, ensure_ascii=False, separators=(",", ":"))
    pad = "  " * (indent + 1)
    if isinstance(value, dict):
        inner = [f"{pad}{json.dumps(k, ensure_ascii=False)}: {written(v, indent + 1)}" for k, v in value.items()]
    else:
        inner = [pad + written(v, indent + 1) for v in value]
    return ("{" if isinstance(value, dict) else "[") + "\n" + ",\n".join(inner) + "\n" + "  " * indent + ("}" if isinstance(value, dict) else "]")


def main():
    if len(sys.argv) not in (2, 3) or (len(sys.argv) == 3 and sys.argv[2] not in ("--write", "--check")):
        sys.exit(__doc__)
    npsee, mode = sys.argv[1], sys.argv[2] if len(sys.argv) == 3 else ""
    shell = json.loads(SHELL.read_text())
    same = True
    for charge in shell["charges"]:
        if charge["name"] not in PLAN:
            continue
        source, forms, lifts = PLAN[charge["name"]]
        numbers, rows = fit(npsee, charge["name"], source, forms, lifts)
        factors = {"elevation_mil": [rows[0][0], rows[-1][0]], "form": numbers[:forms], "lift": numbers[forms:], "source": f"{source}, FIT"}
        print(f"{charge['name']}: form {factors['form']}, lift {factors['lift']} ({len(numbers)} numbers from {2 * len(rows)} data, {source})")
        errors = residuals(npsee, charge["name"], rows, forms, numbers)
        for i, (mil, range_m, drift_m, range_scale, drift_scale) in enumerate(rows):
            dr, dd = errors[2 * i] * range_scale, errors[2 * i + 1] * drift_scale
            line = f"  {mil:7.2f} mil  range {range_m:8.1f} {dr:+7.1f} m  drift {drift_m:6.1f} {dd:+6.1f} m"
            print(line + (f"  {math.hypot(dr, dd) / range_scale:5.2f} CEPs" if source == "THESIS" else ""))
        same = same and charge.get("factors") == factors
        charge["factors"] = factors
    if mode == "--write":
        SHELL.write_text(written(shell) + "\n")
    if mode == "--check":
        print("the shipped factors are those of this fit" if same else "the shipped factors differ from this fit; --write replaces them")
        sys.exit(0 if same else 1)


main()
