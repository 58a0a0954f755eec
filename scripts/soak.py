#!/usr/bin/env python3
"""Plays explosions and missions and edits them in the real editor for a long time, and watches its memory, files and threads.

usage: scripts/soak.py build/release/npsee [--minutes 60] [--seed 1]

The minutes are simulated use, 60 frames a second; the editor runs headless and as fast as it can. Exit code 1 where memory, open files or
threads of the last third are above those of the second third by more than what a cache may still fill (5 % and 16 MiB; no file, no thread).
"""
import argparse
import pathlib
import random
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
FRAMES_A_MINUTE = 3600

# What a person does with an explosion; each line takes about as many frames as are said beside it.
EDITS = [
    (["drag fragments.speed_mean {n}"], 10), (["drag fragments.ejection_angle {n}"], 10), (["drag fragments.size_mean {n}"], 10),
    (["set fragments.count {many}"], 4), (["set seed {many}"], 4), (["set fragments.form {form}"], 4), (["key ctrl+Z"], 2), (["key ctrl+shift+Z"], 2),
    (["key Space", "wait 240", "key Space"], 244), (["set time {time}", "wait 10"], 12), (["drag viewport {n} {n}"], 10), (["key F"], 2),
    (["rightclick template", "click item:Splines"], 8), (["rightclick template", "click item:Surface"], 8), (["click layer:flash"], 4), (["click layer:fragments"], 4),
    (["click button:enable:flash", "click button:enable:flash"], 8),
]
# The shipped missions are looked at, one after the other; each opens, plays and is left.
MISSION = ["click mode:Mission", "wait 30", "click tab:Missions", "wait 3", "click mission:{mission}", "wait 30", "key Space", "wait 900", "key Space", "wait 5", "click mode:Explosion", "wait 5"]
MISSIONS = ["danger_close", "foggy_night", "moving_column", "ridge_low", "thesis_default"]


def lines(frames: int, rng: random.Random) -> list[str]:
    out: list[str] = []
    spent = rounds = 0
    while spent < frames:
        rounds += 1
        if rounds % 60 == 0:
            chosen, cost = MISSION, 980
        else:
            chosen, cost = rng.choice(EDITS)
        words = {"n": rng.randint(-40, 40), "many": rng.randint(50, 3000), "time": f"{rng.uniform(0, 6):.2f}", "form": rng.choice(["tetrahedron", "smoke", "fire", "streak", "sphere"]), "mission": rng.choice(MISSIONS)}
        out += [line.format(**words) for line in chosen]
        spent += cost
    return out


def state(pid: int) -> tuple[int, int, int]:
    """Resident memory in KiB, open files, threads."""
    proc = pathlib.Path(f"/proc/{pid}")
    fields = dict(line.split(":", 1) for line in (proc / "status").read_text().splitlines() if ":" in line)
    return int(fields["VmRSS"].split()[0]), len(list((proc / "fd").iterdir())), int(fields["Threads"])


def watch(command: list[str]) -> list[tuple[int, int, int]]:
    seen = []
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as run:
        while run.poll() is None:
            try:
                seen.append(state(run.pid))
            except (OSError, KeyError):
                break  # it has just ended
            time.sleep(0.5)
    if run.returncode != 0:
        sys.exit(f"the editor ended with exit code {run.returncode}")
    return seen


def main() -> int:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("npsee")
    options.add_argument("--minutes", type=float, default=60)
    options.add_argument("--seed", type=int, default=1)
    o = options.parse_args()
    preset = """{"npsee": 1, "title": "Soak", "layers": [{"name": "fragments", "count": 500}, {"name": "flash", "form": "flash", "count": 1, "lifetime_mean": 0.5}]}"""
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        (work / "soak.npsee.json").write_text(preset)
        (work / "script.txt").write_text("\n".join(lines(int(o.minutes * FRAMES_A_MINUTE), random.Random(o.seed))) + "\n")
        seen = watch([o.npsee, "edit", str(work / "soak.npsee.json"), "--headless", "--size", "1024x640", "--script", str(work / "script.txt")])
    third = len(seen) // 3
    if third < 3:
        sys.exit("it was over before anything could be measured: give more --minutes")
    second, last = seen[third : 2 * third], seen[2 * third : -1]
    names = ["resident memory, KiB", "open files", "threads"]
    room = [max(s[0] for s in second) * 0.05 + 16 * 1024, 0, 0]
    grown = False
    for i, name in enumerate(names):
        before, after = max(s[i] for s in second), max(s[i] for s in last)
        grew = after > before + room[i]
        grown = grown or grew
        print(f"{name}: at most {before} in the second third, {after} in the last{' - GREW' if grew else ''}")
    return 1 if grown else 0


if __name__ == "__main__":
    sys.exit(main())
