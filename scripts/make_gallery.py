#!/usr/bin/env python3
"""Draws the presets' thumbnails and writes docs/presets.md, the gallery of them.

usage: scripts/make_gallery.py build/dev/npsee [--all | --check]

Only thumbnails that are missing or were made from another state of their preset are drawn; with --all every one, as after a change
of the renderer. With --check nothing is written; the exit code is 1 where a thumbnail or the page is not up to date.
"""
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
THUMBNAILS = ROOT / "presets" / "thumbnails"
PAGE = ROOT / "docs" / "presets.md"
SIZE = "256x160"

# The moment that tells most of a preset, others are drawn after a quarter of their time.
MOMENTS = {
    "air_burst": "1.3",
    "cascade": "2.2",
    "classic_1993": "1.5",
    "demolition_masonry": "1.1",
    "dense_fragments": "1.2",
    "directional_charge": "0.3",
    "firework_crossette": "4.1",
    "firework_peony": "3.2",
    "firework_willow": "4.7",
    "grenade": "0.6",
    "ground_burst_rock": "1.0",
    "ground_burst_soil": "1.5",
    "ground_burst_water": "1.5",
    "howitzer_155": "2.6",
    "illumination_flare": "11",
    "impact_dry": "1.1",
    "impact_small": "0.7",
    "mortar": "1.0",
    "vehicle_apart": "0.85",
    "vehicle_fireball": "1.5",
    "wall_of_fire": "2.4",
    "white_smoke_shell": "2.8",
}
# The whole effect otherwise; a firework's ground and its way up would make its flower small.
CAMERAS = {
    "vehicle_apart": "eye=13,5,16 target=0,2.4,0",
    "firework_crossette": "eye=27,36,80 target=0,41.5,0",
    "firework_peony": "eye=26,36,76 target=0,41.5,0",
    "firework_willow": "eye=26,34,80 target=0,36,0",
}

INTRODUCTION = """# The shipped presets

Each lies in [presets](../presets) as `NAME.npsee.json`, opens in the editor from the library, and renders with
`npsee render presets/NAME.npsee.json -o NAME.png`. Missions name them where a shell shall burst as one of them. Copy one to begin a
preset of your own: every figure in them is a parameter that `npsee params` explains.

The hour (day, dusk or night) is a parameter of the preset, `sky`. This page is made by `scripts/make_gallery.py`.
"""


def names() -> list[str]:
    return sorted(file.name.removesuffix(".npsee.json") for file in (ROOT / "presets").glob("*.npsee.json"))


def draw(npsee: str, name: str, how: list[str]) -> bool:
    """Draws one thumbnail, or only verifies it; false where it is not up to date."""
    command = [npsee, "render", str(ROOT / "presets" / f"{name}.npsee.json"), "-o", str(THUMBNAILS / f"{name}.png"), "--size", SIZE]
    command += ["--time", MOMENTS.get(name, "25%"), "--camera", CAMERAS.get(name, "auto"), "--progress", "never"]
    done = subprocess.run(command + how, stdout=subprocess.DEVNULL)
    if done.returncode > 1 or (done.returncode == 1 and "--verify" not in how):
        sys.exit(f"{' '.join(command)}: exit code {done.returncode}")
    return done.returncode == 0


def page() -> str:
    out = [INTRODUCTION, "| | |", "|---|---|"]
    for name in names():
        preset = json.loads((ROOT / "presets" / f"{name}.npsee.json").read_text())
        text = f"**{preset['title']}** (`{name}`)<br>{preset['description']}<br>*{preset['tags']}*"
        out.append(f"| ![{preset['title']}](../presets/thumbnails/{name}.png) | {text} |")
    return "\n".join(out) + "\n"


def main() -> int:
    options = [a for a in sys.argv[1:] if a.startswith("--")]
    programs = [a for a in sys.argv[1:] if not a.startswith("--")]
    if len(programs) != 1 or len(options) > 1 or not set(options) <= {"--all", "--check"}:
        print(__doc__, file=sys.stderr)
        return 2
    check = options == ["--check"]
    # Another build does not make a picture stale; a change of the renderer is answered by --all.
    how = ["--verify", "--any-build"] if check else ["--resume", "--any-build"] if not options else []
    if not check:
        THUMBNAILS.mkdir(exist_ok=True)
    stale = [f"presets/thumbnails/{name}.png" for name in names() if not draw(programs[0], name, how)]
    stale += [f"presets/thumbnails/{file.name} (no preset)" for file in sorted(THUMBNAILS.glob("*")) if file.stem not in names()]
    if not check:
        PAGE.write_text(page())
    elif not PAGE.exists() or PAGE.read_text() != page():
        stale.append("docs/presets.md")
    for file in stale:
        print(f"{file} is not up to date: run scripts/make_gallery.py", file=sys.stderr)
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
