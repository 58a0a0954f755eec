#!/usr/bin/env python3
"""Puts the generated references of docs/missions.md in place.

usage: scripts/update_manual.py build/dev/npsee [--check]

Between each marker line <!-- npsee ARGUMENTS --> and the next <!-- end --> stands what that command prints. With --check nothing is
written; the exit code is 1 where the text is not up to date.
"""
import pathlib
import re
import subprocess
import sys

MANUAL = pathlib.Path(__file__).resolve().parent.parent / "docs" / "missions.md"


def main() -> int:
    arguments = sys.argv[1:]
    check = "--check" in arguments
    programs = [a for a in arguments if a != "--check"]
    if len(programs) != 1:
        print(__doc__, file=sys.stderr)
        return 2

    def printed(match: re.Match) -> str:
        done = subprocess.run([programs[0], *match.group(1).split()], capture_output=True, text=True, check=True)
        return f"<!-- npsee {match.group(1)} -->\n\n{done.stdout}\n<!-- end -->"

    old = MANUAL.read_text()
    new = re.sub(r"<!-- npsee ([^\n]*) -->\n.*?<!-- end -->", printed, old, flags=re.S)
    if new == old:
        return 0
    if check:
        print(f"{MANUAL} is not up to date: run scripts/update_manual.py {programs[0]}", file=sys.stderr)
        return 1
    MANUAL.write_text(new)
    return 0


if __name__ == "__main__":
    sys.exit(main())
