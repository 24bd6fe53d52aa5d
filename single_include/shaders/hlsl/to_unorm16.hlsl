// umbrage 0.1.0, to_unorm16: value that makes a 16-bit target store channel 0..65535. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_TO_UNORM16
#define UMBRAGE_HAS_TO_UNORM16
// umbrage_to_unorm16: value that makes a 16-bit target store channel k, whether it rounds or truncates
float umbrage_to_unorm16(float k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
float2 umbrage_to_unorm16(float2 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
float3 umbrage_to_unorm16(float3 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
float4 umbrage_to_unorm16(float4 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
#endif
