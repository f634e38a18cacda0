# SPDX-License-Identifier: Apache-2.0
"""The film of README.md out of the pictures that `abut-demo --film` writes: docs/images/demo.webp.

usage: film.py FOLDER OUT
FOLDER has 1.png, 2.png and so on. Needs Pillow (python3-pil), which Matplotlib brings.
"""

import pathlib
import sys

from PIL import Image

MILLISECONDS = 100  # of one picture
LAST_MILLISECONDS = 1500  # of the last one, so that its contacts can be looked at
LARGEST = 3_000_000  # bytes; front pages are loaded over slow lines too


def main(folder, out):
    paths = sorted(folder.glob("*.png"), key=lambda path: int(path.stem))
    if not paths:
        sys.exit(f"film: there are no pictures in {folder}")
    pictures = [Image.open(path).convert("RGB") for path in paths]
    durations = [MILLISECONDS] * (len(pictures) - 1) + [LAST_MILLISECONDS]
    pictures[0].save(out, save_all=True, append_images=pictures[1:], duration=durations, loop=0, quality=60, method=6)
    size = out.stat().st_size
    print(f"film: {len(pictures)} pictures, {size / 1e6:.2f} MB in {out}")
    if size > LARGEST:
        sys.exit(f"film: {out} has {size} bytes; at most {LARGEST} are allowed")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
