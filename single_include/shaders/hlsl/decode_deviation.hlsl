// umbrage 0.1.0, MIT License: decode_deviation

#ifndef UMBRAGE_HAS_DECODE_DEVIATION
#define UMBRAGE_HAS_DECODE_DEVIATION
// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
float2 umbrage_decode_deviation(float2 held) {
    float half_of_it = held.y * 0.5;
    precise float square = held.x * held.x + half_of_it * half_of_it;
    return float2(held.x, square);
}
#endif
