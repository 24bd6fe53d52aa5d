// umbrage 0.1.0, MIT License: inside_map

#ifndef UMBRAGE_HAS_INSIDE_MAP
#define UMBRAGE_HAS_INSIDE_MAP
// umbrage_inside_map: whether a texel is one of a map's of size texels
precise bool umbrage_inside_map(float2 size, float2 texel) {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
#endif
