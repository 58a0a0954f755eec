#!/usr/bin/env python3
"""Draws the program's icon with the program itself: a preset at its brightest over nothing, in the sizes of the hicolor theme.

    scripts/make_icon.py NPSEE            writes assets/desktop/icons/SIZE.png
    scripts/make_icon.py NPSEE --check    exit 1 if one is missing or no icon
"""

import pathlib
import struct
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent
folder = root / "assets/desktop/icons"
SIZES = (16, 22, 24, 32, 48, 64, 128, 256, 512)
PICTURE = ["presets/vehicle_fireball.npsee.json", "--time", "0.9", "--background", "transparent", "--camera", "eye=3,6,26 target=0.3,6,0 fov=30deg"]


def draw(npsee, size, out):
    subprocess.run([npsee, "render", *PICTURE, "--size", f"{size}x{size}", "-o", str(out)], cwd=root, check=True, stdout=subprocess.DEVNULL)


def is_icon(file, size):
    data = file.read_bytes() if file.exists() else b""
    # Signature, then the header chunk with width, height, bit depth and colour type 6: with opacity.
    return data[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">IIBB", data[16:26]) == (size, size, 8, 6)


def main():
    npsee = pathlib.Path(sys.argv[1]).resolve()
    if "--check" in sys.argv:
        wrong = [str(size) for size in SIZES if not is_icon(folder / f"{size}.png", size)]
        if wrong:
            print("assets/desktop/icons lacks a picture of " + ", ".join(wrong) + " pixels; scripts/make_icon.py draws them.", file=sys.stderr)
        return 1 if wrong else 0
    folder.mkdir(parents=True, exist_ok=True)
    for size in SIZES:
        draw(npsee, size, folder / f"{size}.png")
    return 0


if __name__ == "__main__":
    sys.exit(main())
