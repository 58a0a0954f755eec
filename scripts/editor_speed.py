#!/usr/bin/env python3
"""Measures how quickly the editor draws each preset while it plays, without a display.

usage: scripts/editor_speed.py build/release/npsee [--size 1280x720] [--seconds 5] [PRESET...]

Prints a table: frames per second, milliseconds of a usual and of a slow frame (one in twenty is slower), of the processor in all threads,
and of the parts; and at which quality the picture was drawn. Without presets all that are shipped. Exit code 1 if any has fewer than 15 frames a
second.
"""
import argparse
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
COLUMNS = ["fps", "median_ms", "slow_ms", "cpu_ms", "explosion_ms", "panels_ms", "window_ms", "quality"]
ENOUGH = 15.0


def measure(program: str, preset: pathlib.Path, size: str, seconds: str) -> dict:
    done = subprocess.run([program, "edit", str(preset), "--headless", "--measure", seconds, "--size", size], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{preset}: exit code {done.returncode}\n{done.stderr}")
    return dict(line.split("=", 1) for line in done.stdout.splitlines())


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--seconds", default="5")
    parser.add_argument("presets", nargs="*", type=pathlib.Path)
    chosen = parser.parse_args()
    presets = chosen.presets or sorted((ROOT / "presets").glob("*.npsee.json"))
    print("| preset | " + " | ".join(COLUMNS) + " |\n|---|" + "---|" * len(COLUMNS))
    slow = 0
    for preset in presets:
        figures = measure(chosen.program, preset, chosen.size, chosen.seconds)
        slow += float(figures["fps"]) < ENOUGH
        print(f"| {preset.name.removesuffix('.npsee.json')} | " + " | ".join(figures[column] for column in COLUMNS) + " |", flush=True)
    return 1 if slow else 0


if __name__ == "__main__":
    sys.exit(main())
