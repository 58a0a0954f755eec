#!/usr/bin/env python3
"""Puts the generated references and the pictures of docs/*.md in place.

usage: scripts/update_manual.py build/dev/npsee [--check] [--text]

Between each marker line <!-- npsee ARGUMENTS --> and the next <!-- end --> stands what that command prints. A marker line
<!-- picture FILE: npsee ARGUMENTS --> has the command draw FILE beside the page; OUT among the arguments stands for it. Commands run in the
project's folder. Pictures are kept in 256 colours, which takes the ffmpeg program. --text leaves them alone. With --check nothing is
written; the exit code is 1 where a text is not up to date, or a picture differs visibly from what its command draws.
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
REFERENCE = re.compile(r"<!-- npsee ([^\n]*) -->\n.*?<!-- end -->", re.S)
PICTURE = re.compile(r"<!-- picture (\S+): npsee ([^\n]*) -->")
# Of 256 colours some levels are lost, and other versions of the software renderer round differently; more means other things are drawn.
MEAN_LEVELS = "3"
LARGEST_FILE = 300_000


def texts(program: str, check: bool) -> bool:
    def printed(match: re.Match) -> str:
        done = subprocess.run([program, *shlex.split(match.group(1))], capture_output=True, text=True, check=True, cwd=ROOT)
        return f"<!-- npsee {match.group(1)} -->\n\n{done.stdout}\n<!-- end -->"

    good = True
    for page in sorted((ROOT / "docs").glob("*.md")):
        old = page.read_text()
        new = REFERENCE.sub(printed, old)
        if new == old:
            continue
        if check:
            print(f"{page} is not up to date: run scripts/update_manual.py {program}", file=sys.stderr)
            good = False
        else:
            page.write_text(new)
    return good


def draw(program: str, arguments: str, out: pathlib.Path) -> None:
    command = [program, *(part.replace("OUT", str(out)) for part in shlex.split(arguments))]
    subprocess.run(command, check=True, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


def reduce_colours(drawn: pathlib.Path, kept: pathlib.Path) -> None:
    graph = "split[a][b];[a]palettegen=stats_mode=full:reserve_transparent=0[p];[b][p]paletteuse=dither=none"
    subprocess.run(["ffmpeg", "-v", "error", "-y", "-i", str(drawn), "-vf", graph, "-frames:v", "1", "-compression_level", "9", str(kept)], check=True)


def pictures(program: str, check: bool) -> bool:
    good = True
    with tempfile.TemporaryDirectory() as folder:
        for page in sorted((ROOT / "docs").glob("*.md")):
            for name, arguments in PICTURE.findall(page.read_text()):
                drawn, kept = pathlib.Path(folder) / "drawn.png", page.parent / name
                draw(program, arguments, drawn)
                if not check:
                    reduce_colours(drawn, kept)
                if kept.stat().st_size > LARGEST_FILE:
                    print(f"{kept} has {kept.stat().st_size} bytes, above {LARGEST_FILE}: draw it smaller", file=sys.stderr)
                    good = False
                if check and subprocess.run([program, "compare", str(drawn), str(kept), "--mean", MEAN_LEVELS]).returncode != 0:
                    print(f"{kept} is not what its command draws: run scripts/update_manual.py {program}", file=sys.stderr)
                    good = False
    return good


def main() -> int:
    arguments = sys.argv[1:]
    options = {a for a in arguments if a.startswith("--")}
    programs = [a for a in arguments if not a.startswith("--")]
    if len(programs) != 1 or options - {"--check", "--text"}:
        print(__doc__, file=sys.stderr)
        return 2
    program, check = str(pathlib.Path(programs[0]).resolve()), "--check" in options
    good = texts(program, check)
    if "--text" not in options:
        good = pictures(program, check) and good
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
