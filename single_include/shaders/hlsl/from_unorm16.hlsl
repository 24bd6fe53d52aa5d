// umbrage 0.1.0, from_unorm16: value read from a 16-bit texture to channel 0..65535. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_FROM_UNORM16
#define UMBRAGE_HAS_FROM_UNORM16
// umbrage_from_unorm16: channel 0..65535 behind a value read from a 16-bit texture, however the driver divides by 65535
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
