// SPDX-License-Identifier: MIT
//
// Discs that rotate from frame to frame.

/** Whether the mean of 16 frames in a row is that of any other 16, and how far one frame is from it, of 255.
 *  @param pixels   draws a frame: bytes, or a promise of them */
export async function tried_turns(pixels) {
    const frames = [];
    for (let i = 0; i < 24; ++i) frames.push(await pixels());
    const sum = first => frames[0].map((_, at) => frames.slice(first, first + 16).reduce((all, frame) => all + frame[at], 0));
    const [one, other] = [0, 7].map(first => sum(first)), differing = one.filter((value, i) => value !== other[i]).length;
    const noise = Math.sqrt(one.reduce((all, value, i) => all + (value / 16 - frames[3][i]) ** 2, 0) / one.length);
    // discs that stand still have none at all; 0.4 is left in three.js r182, which lights half of a penumbra
    return `${differing} differ, ${noise > 0.1 ? 'noise' : 'no noise'} in one: ${noise.toFixed(2)}`;
}
