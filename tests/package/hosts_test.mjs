// SPDX-License-Identifier: MIT
//
// Texts of a known GLSL version through the preprocessors of engines: what comes out is what GLSL's own makes of them.
//     node hosts_test.mjs MODULE GLSLANG FOLDER NODE_MODULES
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [module_path, glslang, folder, node_modules] = process.argv.slice(2);
const load = path => import(pathToFileURL(resolve(path)).href);
const { bind, encodings, hard, level_rg11, pcf_2x2, snippets, supports, text: glsl_text } = await load(module_path);
const packages = { three: 'three@0.182', playcanvas: 'playcanvas@2.23', babylon: '@babylonjs/core@9.35' };
mkdirSync(folder, { recursive: true });

/** What GLSL's preprocessor leaves, without white space; the rest of a shader stands around what is tried. */
function tokens(text, prefix = '') {
    const file = join(folder, 'trial.frag');
    writeFileSync(file, `#version 300 es\n${prefix}\nprecision highp float;\n${text}\nvoid main() {}\n`);
    return execFileSync(glslang, ['-E', '-S', 'frag', file], { encoding: 'utf8', maxBuffer: 1 << 26 })
        .replace(/^#.*$/gm, '').replace(/\/\/.*/g, '').replace(/\s+/g, ' ').replace(/ ?(\W) ?/g, '$1');
}

const hosts = {
    /** Includes, loops and counts are replaced, then come macros for old names. None of it is GLSL's. */
    async three() {
        const source = readFileSync(join(node_modules, 'three/src/renderers/webgl/WebGLProgram.js'), 'utf8');
        const prefix = source.match(/'#define [^']+'/g).map(line => line.slice(1, -1)).filter(line => /^#define texture/.test(line));
        const patterns = [...source.matchAll(/(?:= |replace\( )\/(.+)\/gm?[;,]/g)].map(match => new RegExp(match[1], 'm'));
        if (prefix.length < 8 || patterns.length < 5) throw new Error('three has changed: see WebGLProgram.js');
        const by_word = /NUM_\w+LIGHT|NUM_CLIPPING|UNION_CLIPPING|UNROLLED_LOOP_INDEX/;
        return text => {
            for (const pattern of [...patterns, by_word])
                if (pattern.test(text)) throw new Error(`three replaces ${pattern} in it`);
            return tokens(text, prefix.join('\n'));
        };
    },
    async playcanvas() {
        const { Preprocessor } = await load(join(node_modules, 'playcanvas/build/playcanvas/src/core/preprocessor.js'));
        return text => tokens(Preprocessor.run(text));
    },
    async babylon() {
        const at = name => join(node_modules, '@babylonjs/core/Engines', name);
        const { Process } = await load(at('Processors/shaderProcessor.js'));
        const { WebGL2ShaderProcessor } = await load(at('WebGL/webGL2ShaderProcessors.js'));
        const options = { defines: [], includesShadersStore: {}, isFragment: true, processor: new WebGL2ShaderProcessor(), version: '300',
            platformName: 'WEBGL2', shouldUseHighPrecisionShader: true };
        const main = 'void main() {}', output = /layout\(location = 0\) out vec4 glFragColor;/;
        return text => {
            let made;
            Process(`${text}\n${main}`, options, code => { made = code; }, undefined);
            return tokens(made.replace(output, '').replace(main, '').replace('precision highp float;', ''));
        };
    },
};

const version = '300 es';
const kinds = ['texture_2d', 'atlas', 'array', 'cube', 'cube_faces', 'integer', 'depth', 'depth_array', 'shadow', 'shadow_array'];
const texts = {
    'every snippet': glsl_text(Object.values(snippets).filter(s => supports(s, version) && !s.scaled), version),
    'depths on a scale of their own': glsl_text(
        [bind(hard, 'a', { depth: 'umbrage_level_rg11(value.xy)', channels: 2, needs: [level_rg11] })], version),
    'every kind of map': glsl_text(kinds.map(texture => bind(pcf_2x2, texture, { texture })), version),
    'every encoding': glsl_text(Object.entries(encodings).map(([name, map]) => bind(hard, `in_${name}`, map)), version),
};

let tried = 0, failed = 0;
for (const [host, name] of Object.entries(packages)) {
    if (!existsSync(join(node_modules, name.slice(0, name.lastIndexOf('@'))))) {
        console.log(`SKIPPED: no ${name} in ${node_modules}; npm install --prefix ${join(node_modules, '..')} ${name}`);
        continue;
    }
    const preprocessed = await hosts[host]();
    for (const [what, text] of Object.entries(texts)) {
        ++tried;
        let same = false, why = 'reads it otherwise than GLSL';
        try { same = preprocessed(text) === tokens(text); } catch (error) { why = error.message; }
        console.log(`${same ? 'ok' : 'FAILED'}: ${name}, ${what}${same ? '' : `: ${why}`}`);
        failed += !same;
    }
}
process.exitCode = failed ? 1 : tried ? 0 : 77;
