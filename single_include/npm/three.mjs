// SPDX-License-Identifier: MIT
//
// three.js with WebGLRenderer: the filters of this package on three's own shadow maps, for every material that receives
// shadows. three's bias, normalBias and intensity keep their meaning; point lights keep three's own hard shadow.
//
//     import * as THREE from 'three';
//     import { castano_dyadic5 } from 'umbrage';
//     import { install } from 'umbrage/three';
//     install(THREE, renderer, { filter: castano_dyadic5 });  // before the first frame
import { hooks } from '../module/glsl/shadows.mjs';
import { disc_rotation, probe_color, text } from '../umbrage.mjs';
import { bind_known } from './compose/bind.mjs';
import { in_use } from './three_fit.mjs';
import {
    check_filter, check_options, checked_arguments, checked_later, end_of_body, flag, further_arguments, must, turn_of_frame,
} from './options.mjs';

export { fit_shadow } from './three_fit.mjs';
export { set_light_size } from './three_light_size.mjs';

const chunk_names = ['shadowmap_pars_fragment', 'dithering_fragment'], first_revision = 182;
const members = ['BasicShadowMap', 'Material', 'ShaderChunk', 'WebGLRenderer'];
const scene_of_three = ['a scene of three.js', value => typeof value?.traverse === 'function'];
const bind = /*#__PURE__*/ bind_known(hooks);  // every filter that check_filter takes suits a map of depths
const installed = new Map();  // ShaderChunk -> what it takes to restore it, and the first renderer's direction
const numbers = new Map();  // chunk -> its number in the keys of programs

/** three's own getShadow for maps of plain depths: where it begins and ends in the chunk. */
function own_function(chunk) {
    const heads = [...chunk.matchAll(/float getShadow\( sampler2D shadowMap[^{]*\{/g)];
    const head = heads.at(-1);  // behind the one for variance maps
    const parameters = 'sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, '
        + 'float shadowRadius, vec4 shadowCoord';
    must('three: install', heads.length === 2 && head[0].includes(parameters),
        'THREE must have the shadow shader of r182 or later', 'another text of shadowmap_pars_fragment');
    return { head: head[0], begin: head.index, end: end_of_body(chunk, head.index + head[0].length) };
}

/** The chunk with our function in place of three's. */
function with_filter(chunk, filter, given, direction, { probe = false, frame = false }) {
    const { head, begin, end } = own_function(chunk);
    const further = further_arguments(filter, given,
        { rotation: `umbrage_disc_rotation( gl_FragCoord.xy${frame ? ' + umbrage_turn' : ''} )`, radius: 'shadowRadius', vec4: 'vec4' });
    const map = { texture: 'depth', direction, outside: 'bordered' };
    const items = [disc_rotation, bind(filter, 'three', map), ...(probe ? [bind(probe_color, 'three', map)] : [])];
    const declarations = `
#if defined( SHADOWMAP_TYPE_BASIC )
highp vec4 umbrage_receiver = vec4( 0.0 );  // texels, texels, depth, visibility
highp vec3 umbrage_color = vec3( 0.5 );
${frame ? 'uniform highp vec2 umbrage_turn;\n' : ''}${text(items, '300 es')}
#endif
`;
    const body = `${head}
			shadowCoord.xyz /= shadowCoord.w;
			shadowCoord.z ${direction === 'reversed' ? '-' : '+'}= shadowBias;
			highp vec2 size = vec2( textureSize( shadowMap, 0 ) );
			highp vec3 at = vec3( shadowCoord.xy * size, shadowCoord.z );
			float shadow = umbrage_${filter.name}_three( shadowMap, size, at.xy, at.z${further} );
			umbrage_receiver = vec4( at, shadow );${probe ? `
			umbrage_color = umbrage_probe_color_three( at, size, abs( shadowBias ), 0.0 );` : ''}
			return mix( 1.0, shadow, shadowIntensity );
		}`;
    const place = '#ifdef USE_SHADOWMAP';
    must('three: install', chunk.indexOf(place) < begin, 'THREE must have the shadow shader of r182 or later', 'another order');
    return chunk.slice(0, begin).replace(place, place + declarations) + body + chunk.slice(end);
}

/** A uniform of all lit materials that each frame of a renderer changes: three.js reads x and y when it draws. */
function turn_by_frame(shaders, { info }) {
    const value = { x: 0, get y() { return turn_of_frame(info.render.frame); } };
    for (const { uniforms } of Object.values(shaders)) if (uniforms.directionalLightShadows) uniforms.umbrage_turn = { value };
}

/** Puts a filter in place of three's own, for all lights and materials of a page. */
export function install(THREE, renderer, options = {}) {
    const where = 'three: install';
    must(where, Number.parseInt(THREE?.REVISION) >= first_revision, `THREE must be r${first_revision} or later`, THREE?.REVISION);
    for (const member of members) must(where, member in THREE, `THREE must have ${members.join(', ')}`, `no ${member}`);
    must(where, renderer instanceof THREE.WebGLRenderer, 'renderer must be a WebGLRenderer of this copy of three.js', renderer);
    check_options(where, options, { filter: checked_later, arguments: checked_later, frame: flag, probe: flag, scene: scene_of_three });
    const { filter, frame = false, probe = false, scene } = options;
    must(where, !frame || THREE.ShaderLib, 'THREE must have ShaderLib for frame', 'no ShaderLib');
    check_filter(where, 'filter', filter, 'GLSL');
    const given = checked_arguments(where, filter, options.arguments);
    const { ShaderChunk, Material: { prototype: material } } = THREE;
    const direction = renderer.state.buffers.depth.getReversed() === true ? 'reversed' : 'forward';
    const own = installed.get(ShaderChunk) ?? {
        chunks: Object.fromEntries(chunk_names.map(name => [name, ShaderChunk[name]])),
        key: material.customProgramCacheKey, first: direction, types: new Map(),  // of each renderer
    };
    const { chunks, key, first, types } = own;
    must(where, direction === first,
        `renderer must have the depth direction of the page's first, ${first}: call uninstall(THREE) before`, direction);
    const text = with_filter(chunks.shadowmap_pars_fragment, filter, given, direction, options);
    ShaderChunk.shadowmap_pars_fragment = text;
    ShaderChunk.dithering_fragment = chunks.dithering_fragment + (probe
        ? '\n#if defined( USE_SHADOWMAP ) && defined( SHADOWMAP_TYPE_BASIC )\ngl_FragColor.rgb = umbrage_color;\n#endif\n' : '');
    if (!numbers.has(text)) numbers.set(text, numbers.size);
    const mark = `umbrage ${numbers.get(text)}`;
    material.customProgramCacheKey = function () { return key.call(this) + mark; };
    if (!types.has(renderer)) types.set(renderer, renderer.shadowMap.type);
    renderer.shadowMap.type = THREE.BasicShadowMap;  // depths as they are
    if (frame) turn_by_frame(THREE.ShaderLib, renderer);
    installed.set(ShaderChunk, own);
    in_use.webgl = { filter, given };
    compile_again(THREE, scene);
}

/** Restores three's own text, byte for byte. */
export function uninstall(THREE, options = {}) {
    const where = 'three: uninstall', own = installed.get(THREE?.ShaderChunk);
    must(where, THREE?.ShaderChunk !== undefined, 'THREE must have ShaderChunk', THREE);
    check_options(where, options, { scene: scene_of_three });
    if (!own) return;
    Object.assign(THREE.ShaderChunk, own.chunks);
    THREE.Material.prototype.customProgramCacheKey = own.key;
    for (const [renderer, type] of own.types) renderer.shadowMap.type = type;
    for (const { uniforms } of Object.values(THREE.ShaderLib ?? {})) delete uniforms.umbrage_turn;
    installed.delete(THREE.ShaderChunk);
    in_use.webgl = undefined;
    compile_again(THREE, options.scene);
}

function compile_again({ Material: { prototype } }, scene) {
    scene?.traverse(object => {
        for (const material of [object.material ?? []].flat()) {
            // a key of its own stays the same: three.js must forget its program
            if (material.customProgramCacheKey !== prototype.customProgramCacheKey) material.dispose();
            material.needsUpdate = true;
        }
    });
}
