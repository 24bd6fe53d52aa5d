// umbrage 0.1.0, MIT License: tap_coordinate

#ifndef UMBRAGE_HAS_TAP_COORDINATE
#define UMBRAGE_HAS_TAP_COORDINATE
// umbrage_tap_coordinate: coordinate, before the division by w, moved by offset texels
float4 umbrage_tap_coordinate(float4 coordinate, float2 offset) {
    precise float2 moved = float2(coordinate.x, coordinate.y) + offset * coordinate.w;
    return float4(moved.x, moved.y, coordinate.z, coordinate.w);
}
#endif
