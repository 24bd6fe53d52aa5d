// SPDX-License-Identifier: MIT
//
// Scene of every recipe in JavaScript: a mesh with a fence, the numbers of its camera and lights, and their shading.

export const size = [480, 320], sky = [0.53, 0.69, 0.87, 1];

/** Floor, pillars, a plate in the air and a fence: position, normal and uv of each vertex. uv is 0 but on the fence. */
export function make_mesh() {
    const floats = [], add = (a, b, s) => a.map((x, i) => x + b[i] * s);
    const quad = (corner, a, b, normal, pickets = 0) => {
        for (const [x, y] of [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]])
            floats.push(...add(add(corner, a, x), b, y), ...normal, x * pickets, y);
    };
    const box = (low, [w, h, d]) => {
        const high = add(low, [w, h, d], 1);
        quad(low, [0, h, 0], [0, 0, d], [-1, 0, 0]), quad(high, [0, 0, -d], [0, -h, 0], [1, 0, 0]);
        quad(low, [0, 0, d], [w, 0, 0], [0, -1, 0]), quad(high, [-w, 0, 0], [0, 0, -d], [0, 1, 0]);
        quad(low, [w, 0, 0], [0, h, 0], [0, 0, -1]), quad(high, [0, -h, 0], [-w, 0, 0], [0, 0, 1]);
    };
    quad([-16, 0, -30], [32, 0, 0], [0, 0, 36], [0, 1, 0]);
    for (let i = 0; i < 5; ++i) box([-4, 0, -6 * i], [1, 3, 1]), box([4, 0, -6 * i - 3], [1, 4, 1]);
    box([-1, 0, -1], [1.4, 1.2, 1.4]);
    box([1, 1.5, -3], [1.5, 0.2, 1.5]);
    quad([-2.5, 0, 3], [3, 0, 0], [0, 1, 0], [0, 0, 1], 8);
    return new Float32Array(floats);
}

/** View, projection and both of the camera, for an API's clip space. */
export function make_camera({ range, direction }) {
    const c = 1 / Math.hypot(1, 0.4), s = 0.4 * c, [y, z] = [5, 9];
    const view = [1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, z * s - y * c, -y * s - z * c, 1];
    const forward = [range === 'zero_to_one' ? 0 : -1, 1], [a, b] = direction === 'reversed' ? [1, 0] : forward;
    const near = 0.1, far = 60, slope = (a * near - b * far) / (far - near);
    const projection = [1 / 0.75, 0, 0, 0, 0, 1 / 0.5, 0, 0, 0, 0, slope, -1, 0, 0, near * (slope + a), 0];
    const element = i => [0, 1, 2, 3].reduce((sum, k) => sum + projection[k * 4 + i % 4] * view[(i & 12) + k], 0);
    return { view, projection, to_clip: Float32Array.from(view, (_, i) => element(i)) };
}

export const spot_light = { position: [5, 8, 4], direction: [-5, -8, -4], outer_angle_radians: 0.5, z_near: 1,
    z_far: 30 };
export const sun_light = ({ view, projection }) => ({ direction: [1, -1.2, -0.7],
    scene: { low: [-16, 0, -30], high: [16, 4, 6] },
    camera: { view, projection, z_near: 2, z_far: 40 }, cascades: 3, lambda: 0.8 });

/** Holes of the fence, and light from a spot and a sun of given visibilities. */
export const glsl_shading = `
bool is_hole(vec2 uv) { return fract(uv.x) > 0.5; }
vec3 shade(vec3 world, vec3 normal, float spot, float sun) {
    vec3 to_spot = normalize(vec3(5.0, 8.0, 4.0) - world), to_sun = normalize(vec3(-1.0, 1.2, 0.7));
    float cone = smoothstep(0.88, 0.9, dot(to_spot, normalize(vec3(5.0, 8.0, 4.0))));
    return vec3(0.2, 0.22, 0.27) + vec3(0.3, 0.17, 0.0) * spot * cone * max(dot(normal, to_spot), 0.0)
        + vec3(0.52, 0.46, 0.36) * sun * max(dot(normal, to_sun), 0.0);
}
`;
export const wgsl_shading = `
fn is_hole(uv: vec2f) -> bool { return fract(uv.x) > 0.5; }
fn shade(world: vec3f, normal: vec3f, spot: f32, sun: f32) -> vec3f {
    let to_spot = normalize(vec3f(5.0, 8.0, 4.0) - world);
    let to_sun = normalize(vec3f(-1.0, 1.2, 0.7));
    let cone = smoothstep(0.88, 0.9, dot(to_spot, normalize(vec3f(5.0, 8.0, 4.0))));
    return vec3f(0.2, 0.22, 0.27) + vec3f(0.3, 0.17, 0.0) * spot * cone * max(dot(normal, to_spot), 0.0)
        + vec3f(0.52, 0.46, 0.36) * sun * max(dot(normal, to_sun), 0.0);
}
`;
