// umbrage 0.1.0, from_unorm16: channel 0..65535 of a value from a 16-bit texture. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_FROM_UNORM16
#define UMBRAGE_HAS_FROM_UNORM16
// umbrage_from_unorm16: channel 0..65535 of a value from a 16-bit texture, even if the division by 65535 is inexact
float umbrage_from_unorm16(float c) {
    return floor(c * 65535.0 + 0.5);
}
float2 umbrage_from_unorm16(float2 c) {
    return floor(c * 65535.0 + 0.5);
}
float3 umbrage_from_unorm16(float3 c) {
    return floor(c * 65535.0 + 0.5);
}
float4 umbrage_from_unorm16(float4 c) {
    return floor(c * 65535.0 + 0.5);
}
#endif
