#!/usr/bin/env python3
"""Compares pictures with the goldens in tests/golden: presets, templates, and scenes that show one pass each.

usage: scripts/goldens.py build/dev/npsee [--update | --elsewhere] [--report DIR]

Nothing may differ on the driver and class of processor that a golden was drawn by; elsewhere, and with --elsewhere everywhere, 0.01 % of the
pixels by more than 2 levels. --update writes the goldens that differ and names them: look at them before they are committed. --report makes a
page with before, after and difference, and a JUnit file, for each part. Exit code 1 where pictures differ, are missing, or belong to nothing.
"""
import argparse
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
GOLDEN = ROOT / "tests" / "golden"
SCENES = GOLDEN / "scenes"
SIZE = ["--size", "320x180"]
MOMENTS = ["--time", "10%,35%,70%"]

# Presets whose templates differ in kind: a disc, all directions, a narrow cone, a region with height.
TEMPLATES = ["classic_1993", "air_burst", "directional_charge", "demolition_masonry"]
VIEWS = ["surface", "polygons", "splines"]


def presets(names: list[str] | None = None) -> list[str]:
    files = sorted((ROOT / "presets").glob("*.npsee.json"))
    return [str(file) for file in files if names is None or file.name.removesuffix(".npsee.json") in names]


def scenes() -> list[str]:
    return [str(file) for file in sorted(SCENES.glob("*.npsee.json"))]


def parts() -> dict[str, list[str]]:
    """Folder of the goldens -> arguments of `npsee render`."""
    out = {"presets": presets() + MOMENTS, "passes": scenes() + MOMENTS, "transparent": scenes() + ["--time", "35%", "--background", "transparent"]}
    for view in VIEWS:
        out[f"template_{view}"] = presets(TEMPLATES) + ["--template", "--view", view]
    return out


def strays(folder: pathlib.Path, call: list[str]) -> list[str]:
    """Goldens of presets that are no more."""
    wanted = {pathlib.Path(word).name.removesuffix(".npsee.json") for word in call if word.endswith(".npsee.json")}
    numbered = any("," in word for word in call)
    return [str(file.relative_to(ROOT)) for file in sorted(folder.glob("*")) if (file.stem.rpartition("_")[0] if numbered else file.stem) not in wanted]


def main() -> int:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("npsee")
    options.add_argument("--report", type=pathlib.Path)
    how = options.add_mutually_exclusive_group()
    how.add_argument("--update", action="store_true")
    how.add_argument("--elsewhere", action="store_true")
    o = options.parse_args()
    failed = False
    for name, call in parts().items():
        folder = GOLDEN / name
        if o.update:
            folder.mkdir(exist_ok=True)
        command = [o.npsee, "render", *call, *SIZE, "--golden", str(folder), "--progress", "never"]
        if o.update:
            command.append("--update-golden")
        if o.elsewhere:
            command += ["--pixels", "0.01% over 2"]
        if o.report:
            o.report.mkdir(parents=True, exist_ok=True)
            command += ["--report", str(o.report / f"{name}.html"), "--junit", str(o.report / f"{name}.xml")]
        print(f"{name}:", flush=True)
        failed = subprocess.run(command).returncode != 0 or failed
        for stray in strays(folder, call):
            print(f"{stray} belongs to no picture that is drawn: delete it", file=sys.stderr)
            failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
