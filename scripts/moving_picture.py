#!/usr/bin/python3
"""Writes the frames of an animation as one GIF that repeats; needs Pillow (python3-pil).

usage: moving_picture.py --output FILE.gif [--colors N] [--milliseconds T] FRAME.png...

All frames share the colors of the first, so that plain areas do not flicker.
"""
import argparse

from PIL import Image


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("frames", nargs="+", metavar="FRAME.png")
    parser.add_argument("--output", required=True, metavar="FILE.gif")
    parser.add_argument("--colors", type=int, default=24, help="colors of all frames (default 24)")
    parser.add_argument("--milliseconds", type=int, default=60, help="time of a frame (default 60)")
    arguments = parser.parse_args()
    frames = [Image.open(path).convert("RGB") for path in arguments.frames]
    palette = frames[0].quantize(arguments.colors, dither=Image.Dither.NONE)
    first, *others = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    first.save(arguments.output, save_all=True, append_images=others,
               duration=arguments.milliseconds, loop=0)


if __name__ == "__main__":
    main()
