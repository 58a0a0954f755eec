#!/usr/bin/env python3
"""Compares the editor's main states with the pictures in tests/editor/golden.

usage: scripts/ui_goldens.py build/dev/npsee [--update]

Each state is reached by a script and photographed without a display. Beside the pictures lies the driver and processor class that drew them:
there nothing may differ, elsewhere 0.01 % of the pixels by more than 2 levels. Explosions and missions themselves are left out, and so are
shipped thumbnails: other tests look at those. With --update the pictures are drawn anew; it names what it wrote, and still fails.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
GOLDEN = ROOT / "tests" / "editor" / "golden"
QUIET = "set time 20\npictures off\n"
IN_MISSION = "set time 30\npictures off\nclick observer:fo1\n"
AWAY = "mouse 3 200\nwait 40\n"
PRESET, MISSION = "library/classic.npsee.json", "ridge_low.mission.json"
# name: file, script, further options
STATES = {
    "main": (PRESET, QUIET, ["--size", "1024x640"]),
    "history": (PRESET, QUIET + "set fragments.speed_mean 61\nset fragments.count 240\nkey ctrl+Z\nkey ctrl+H\n", ["--size", "1024x640"]),
    "find": (PRESET, QUIET + "key ctrl+P\ntype mag\n", ["--size", "1024x640"]),
    "export": (PRESET, QUIET + "key ctrl+E\nclick \"field:export folder\"\nkey ctrl+A\ntype pictures\nkey Enter\n", ["--size", "1024x640"]),
    "question": (PRESET, QUIET + "set fragments.speed_mean 61\nkey ctrl+Q\n", ["--size", "1024x640"]),
    "light_large": (PRESET, QUIET + "click menu:View\nclick \"item:Light theme\"\nkey Escape\n", ["--size", "1440x900", "--scale", "1.5"]),
    "compare": (PRESET, QUIET + "key shift+C\nset fragments.speed_mean 61\n", ["--size", "1024x640"]),
    "variations": (PRESET, QUIET + "key shift+V\n", ["--size", "1024x640"]),
    "cheat_sheet": (PRESET, QUIET + "key F1\n", ["--size", "1024x640"]),
    "mission": (MISSION, IN_MISSION, ["--size", "1024x640"]),
    "mission_fire": (MISSION, IN_MISSION + "click tab:Fire\nclick button:take\n", ["--size", "1440x900"]),
    "mission_light_large": (MISSION, IN_MISSION + "click menu:View\nclick \"item:Light theme\"\nkey Escape\nclick tab:Shots\n", ["--size", "1440x900", "--scale", "1.5"]),
}


def run(program: str, *words: str) -> subprocess.CompletedProcess:
    return subprocess.run([program, *words], capture_output=True, text=True)


def machine(program: str, folder: pathlib.Path) -> dict:
    preset = str(ROOT / "presets" / "classic_1993.npsee.json")
    done = run(program, "render", preset, "-o", str(folder / "machine.png"), "--size", "16x16", "--summary", "json")
    summary = json.loads(done.stdout)
    return {"driver": summary["driver"], "processor": summary["processor"]}


def draw(program: str, name: str, folder: pathlib.Path) -> pathlib.Path:
    file, script, options = STATES[name]
    library = folder / "library"
    library.mkdir(exist_ok=True)
    preset = library / "classic.npsee.json"
    if not preset.exists():
        shutil.copyfile(ROOT / "presets" / "classic_1993.npsee.json", preset)
    missions = ROOT / "assets" / "missions"
    path = file if file == PRESET else str(missions / file)
    (folder / "script.txt").write_text(script + AWAY)
    out = folder / f"{name}.png"
    done = subprocess.run([program, "edit", path, "--library", "library", "--headless", "--script", "script.txt", "--screenshot", str(out), *options],
                          capture_output=True, text=True, cwd=folder)
    if done.returncode != 0:
        sys.exit(f"{name}: exit code {done.returncode}\n{done.stderr}")
    return out


def main() -> int:
    programs = [word for word in sys.argv[1:] if not word.startswith("--")]
    if len(programs) != 1 or set(sys.argv[1:]) - {*programs, "--update"}:
        print(__doc__, file=sys.stderr)
        return 2
    program, update = str(pathlib.Path(programs[0]).resolve()), "--update" in sys.argv
    with tempfile.TemporaryDirectory() as parent:
        folder = pathlib.Path(parent)
        here = machine(program, folder)
        record = GOLDEN / "machine.json"
        same = record.exists() and json.loads(record.read_text()) == here
        bad = 0
        for name in STATES:
            drawn, golden = draw(program, name, folder), GOLDEN / f"{name}.png"
            tolerance = [] if same else ["--pixels", "0.01% over 2"]
            done = run(program, "compare", str(golden), str(drawn), *tolerance) if golden.exists() else None
            if done is not None and done.returncode == 0:
                continue
            bad += 1
            if update:
                GOLDEN.mkdir(exist_ok=True)
                shutil.copyfile(drawn, golden)
                record.write_text(json.dumps(here, indent=2) + "\n")
                print(f"{golden} was drawn anew: look at it")
            else:
                print(f"{name}: {done.stdout if done else 'there is no golden picture'}  `scripts/ui_goldens.py {sys.argv[1]} --update` draws it anew.")
        return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
