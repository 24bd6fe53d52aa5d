# SPDX-License-Identifier: MIT
"""Two functions written in Python against the vectors: as they are, none differs, and with a slip some do.

    python3 read_test.py FILE
"""
import json, math, sys

from read import vectors

with open(sys.argv[1]) as opened:
    file = json.load(opened)


def encode_rg11(codes):
    """Depth to two bytes. `codes` is the slip: 2^11 of them are right."""

    def encode(inputs, _):
        depth = inputs[0]
        code = 2047 if not depth < 1 else min(math.floor(depth * codes), 2047) if depth > 0 else 0
        return code % 256, code // 256 * 32, 0, 255

    return encode


def hard(half):
    """The nearest texel, compared. `half`, in texels, is the slip: 0 is right."""

    def filtered(inputs, read):
        (x, y, receiver), (size, texels) = inputs, read
        if not (abs(x) < 32768 and abs(y) < 32768) or receiver > 1:
            return (1,)
        column, row = (min(max(math.floor(c - half), 0), most - 1) for c, most in zip((x, y), size))
        return (1 if receiver <= texels[4 * (row * size[0] + column)] else 0,)

    return filtered


def different(name, mine):
    """How many of a function's vectors differ. Every NaN is one, and -0 is 0."""
    every = list(vectors(file, name))
    assert len(every) >= 20, f"{len(every)} vectors of {name}"
    same = lambda a, b: a == b or (math.isnan(a) and math.isnan(b))
    return sum(not all(map(same, mine(inputs, read), outputs)) for inputs, outputs, read in every)


failed = 0
for name, mine, is_right in (
    ("encode_rg11", encode_rg11(2048), True),
    ("encode_rg11", encode_rg11(2047), False),
    ("hard", hard(0), True),
    ("hard", hard(0.5), False),
):
    wrong = different(name, mine)
    if (wrong == 0) != is_right:
        failed += 1
        print(f"FAILED: {name}: {wrong} vectors differ", file=sys.stderr)
sys.exit(1 if failed else 0)
