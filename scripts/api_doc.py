#!/usr/bin/env python3
"""Checks the reference of the public headers (sim/include/npsee): Doxygen must have no warning, and every public function a comment, which
names its errors where the function returns some.

    scripts/api_doc.py            exit 0, or 1 with one line for each fault; 77 where doxygen is not installed
    scripts/api_doc.py --html DIR writes the reference there too

Constructors, destructors, assignment and comparison are left out: C++ says what they do. Declarations right below one that has a comment,
without an empty line between, share it.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

root = pathlib.Path(__file__).resolve().parent.parent
SKIPPED = 77


def text_of(member):
    return "".join("".join(part.itertext()) for tag in ("briefdescription", "detaileddescription") if (part := member.find(tag)) is not None).strip()


def is_special(member, owner):
    name = member.findtext("name")
    return name in (owner, "~" + owner) or name.startswith("operator")


def functions(folder):
    """(file, line) -> (name, type, text) of every public function."""
    found = {}
    for file in sorted(folder.glob("*.xml")):
        for compound in ElementTree.parse(file).getroot().iter("compounddef"):
            owner = compound.findtext("compoundname", "").split("::")[-1]
            for member in compound.iter("memberdef"):
                if member.get("kind") != "function" or member.get("prot") != "public" or is_special(member, owner):
                    continue
                place = member.find("location")
                at = place.get("declfile", place.get("file")), int(place.get("declline", place.get("line")))
                found[at] = member.findtext("qualifiedname") or member.findtext("name"), "".join(member.find("type").itertext()), text_of(member)
    return found


def shared_comment(file, line):
    """The comment above this declaration with only other declarations in between; empty if there is none."""
    lines = (root / "sim/include" / file).read_text().splitlines()
    if "///<" in lines[line - 1]:
        return lines[line - 1]
    comment = []
    for above in reversed(lines[: line - 1]):
        text = above.strip()
        if text.startswith("///"):
            comment.insert(0, text)
        elif comment or not text or text.endswith(("{", ":", "}")):
            break
    return " ".join(comment)


def faults_of(found):
    for (file, line), (name, kind, text) in sorted(found.items()):
        text = text or shared_comment(file, line)
        if not text:
            yield f"{file}:{line}: {name} has no documentation."
        elif re.search(r"\bExpected<|\bnpsee_status\b", kind) and not re.search(r"[Ee]rror", text + shared_comment(file, line)):
            yield f"{file}:{line}: the documentation of {name} does not tell its errors."


def main():
    if shutil.which("doxygen") is None:
        print("doxygen is not installed (scripts/packages.txt): the reference is not checked.")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        settings = (root / "docs/Doxyfile").read_text() + f"\nOUTPUT_DIRECTORY = {folder}\n"
        run = subprocess.run(["doxygen", "-"], input=settings, cwd=root, capture_output=True, text=True, check=False)
        if run.returncode != 0 or run.stderr.strip():
            print(run.stderr.replace(str(root) + "/", "") + "Doxygen has warnings.", file=sys.stderr)
            return 1
        found = functions(pathlib.Path(folder) / "xml")
        if len(sys.argv) == 3 and sys.argv[1] == "--html":
            shutil.copytree(pathlib.Path(folder) / "html", sys.argv[2], dirs_exist_ok=True)
    faults = list(faults_of(found))
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{len(found)} public functions.")
    return 1 if faults or not found else 0


if __name__ == "__main__":
    sys.exit(main())
