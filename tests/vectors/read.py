# SPDX-License-Identifier: MIT
import struct


def floats(digits):
    """Floats of a text of bits, 8 hexadecimal digits each."""
    return struct.unpack(f">{len(digits) // 8}f", bytes.fromhex(digits))


def vectors(data, name):
    """The vectors of the function `name` in a parsed file: inputs, outputs, and its map's size and texels, if any."""
    for f in (f for f in data["functions"] if f["name"] == name):
        read = data["maps"][f["map"]] if "map" in f else None
        read = read and (read["size"], floats(read["texels"]))
        for vector in f["vectors"]:
            inputs, outputs = map(floats, vector.split())
            yield inputs, outputs, read
