# SPDX-License-Identifier: MIT
import json, struct


def floats(digits):
    """Floats of a text of bits, 8 hexadecimal digits each."""
    return struct.unpack(f">{len(digits) // 8}f", bytes.fromhex(digits))


def vectors(path, name):
    """The vectors of the function `name` in a file: what goes in, what comes out, and its map's size and texels."""
    with open(path) as file:
        data = json.load(file)
    for f in (f for f in data["functions"] if f["name"] == name):
        read = data["maps"][f["map"]] if "map" in f else None
        for vector in f["vectors"]:
            inputs, outputs = map(floats, vector.split())
            yield inputs, outputs, read and (read["size"], floats(read["texels"]))
