// umbrage 0.1.0, to_unorm: value that makes an 8-bit target store channel 0..255. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_TO_UNORM
#define UMBRAGE_HAS_TO_UNORM
// umbrage_to_unorm: value that makes an 8-bit target store channel k, whether it rounds or truncates
// k * 257 / 65536 + 64 / 65536, in decimals because 65536.0 is infinite in mediump
float umbrage_to_unorm(float k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
float2 umbrage_to_unorm(float2 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
float3 umbrage_to_unorm(float3 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
float4 umbrage_to_unorm(float4 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
#endif
