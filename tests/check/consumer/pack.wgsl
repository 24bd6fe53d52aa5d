// SPDX-License-Identifier: MIT
fn pack(z: f32) -> f32 {
    return min(floor(clamp(z, 0.0, 1.0) * 65536.0), 65535.0) / 65535.0;
}
