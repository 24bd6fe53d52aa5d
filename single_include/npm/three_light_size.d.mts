// SPDX-License-Identifier: MIT
//
// Types of set_light_size, which umbrage/three and umbrage/three/webgpu share.

/** Gives a light a size in the world, for pcss and dpcf: penumbras are as wide as under a round light of that size, whatever
 *  the shadow's camera and map are or become. They end at the largest radius of the filter's softness. The light's
 *  shadow.radius is computed from then on; other filters read the radius that was set.
 *  Texels must be squares of the world. For others pass arguments: { softness: [x, y, min, max] }, with x and y in the ratio
 *  of the texels for each unit of the world.
 *  @param light        a DirectionalLight or a SpotLight
 *  @param light_size   of a SpotLight its radius in world units; of a DirectionalLight the tangent of half the angle under
 *                      which it is seen: 0.00465 for the sun
 *  @throws Error       another light, or a size that is not finite or below 0 */
export function set_light_size(light: object, light_size: number): void;
