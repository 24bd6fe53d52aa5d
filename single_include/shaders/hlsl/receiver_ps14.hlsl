// umbrage 0.1.0, MIT License: receiver_ps14

#ifndef UMBRAGE_HAS_RECEIVER_PS14
#define UMBRAGE_HAS_RECEIVER_PS14
// umbrage_receiver_ps14: depth * 256 / 255, the scale of umbrage_decode_ps14; beyond the far plane what every texel
//   lights
float umbrage_receiver_ps14(float depth) {
    return depth > 1.0 ? -1.0 : depth * 1.00392163;
}
#endif
