// SPDX-License-Identifier: MIT
//
// fit_shadow and set_light_size of three.js without a browser: every receiver is in the map and between its planes, the light
// is where it was, steady maps move by whole texels, a light's size follows its camera, and bad input is refused by a name.
//     node fit_test.mjs PACKAGE FOLDER NODE_MODULES
import { cpSync, existsSync, mkdirSync, rmSync, symlinkSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [umbrage, folder, node_modules] = process.argv.slice(2).map(path => resolve(path));
if (!existsSync(join(node_modules, 'three'))) {
    console.log(`SKIPPED: no three in ${node_modules}`);
    process.exit(77);
}
const modules = join(folder, 'node_modules');
rmSync(folder, { recursive: true, force: true });
mkdirSync(modules, { recursive: true });
cpSync(umbrage, join(modules, 'umbrage'), { recursive: true });
symlinkSync(join(node_modules, 'three'), join(modules, 'three'));
const load = path => import(pathToFileURL(join(modules, path)).href);
const THREE = await load('three/build/three.module.js');
const { fit_shadow, install, set_light_size, uninstall } = await load('umbrage/npm/three.mjs');
const { castano_dyadic5, hard, pcss16 } = await load('umbrage/umbrage.mjs');

let failed = 0;
const check = (what, good) => {
    if (!good) ++failed;
    console.log(`${good ? 'ok' : 'FAILED'}: ${what}`);
};
let seed = 7;
const random = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;
const at = (...point) => new THREE.Vector3(...point);
const anywhere = () => at(200 * random() - 100, 20 * random(), 200 * random() - 100);
const world = object => at().setFromMatrixPosition(object.matrixWorld);

/** A light on a cart that is turned, scaled and somewhere. */
function light_of(kind) {
    const light = new THREE[kind](), cart = new THREE.Group();
    cart.scale.setScalar(0.1 + 3 * random());
    cart.rotation.set(random(), random(), random());
    cart.position.copy(anywhere());
    cart.add(light, ...(light.target ? [light.target] : []));
    light.position.set(2 * random() - 1, 0.05 + random(), 2 * random() - 1).multiplyScalar(50);
    if (kind === 'SpotLight') light.angle = 0.1 + random();
    return light;
}

/** Whether the map has a point: undefined where no light reaches it. */
function holds(light, point, { casters_are_cut }) {
    const { camera, matrix } = light.shadow, from = point.clone().sub(world(light));
    if (light.isPointLight) {
        const depth = Math.max(...from.toArray().map(Math.abs));
        return depth <= camera.far && (depth >= camera.near || casters_are_cut);
    }
    if (light.isSpotLight && from.angleTo(world(light.target).sub(world(light))) > light.angle) return undefined;
    light.shadow.updateMatrices(light);
    const place = new THREE.Vector4(...point.toArray(), 1).applyMatrix4(matrix);
    const { x, y, z } = place.divideScalar(place.w);
    return x >= 0 && x <= 1 && y >= 0 && y <= 1 && z <= 1 && (z >= 0 || casters_are_cut);
}

for (const [n, kind] of ['DirectionalLight', 'SpotLight', 'PointLight'].entries()) {
    let [tried, outside, finite, moved] = [0, 0, true, 0];
    for (let k = 0; k < 600; ++k) {
        const receivers = new THREE.Box3().setFromPoints([anywhere(), anywhere()]), light = light_of(kind);
        light.shadow.mapSize.set(512 << (k % 3), 512 << (k % 2));
        light.shadow.radius = 1 + 3 * random();
        const camera = [undefined, new THREE.PerspectiveCamera(40 + 40 * random(), 1.5, 0.1, 150),
            new THREE.OrthographicCamera(-20, 20, 12, -12, 1, 150)][k % 3];
        camera?.position.copy(anywhere());
        camera?.lookAt(receivers.getCenter(at()));
        light.updateWorldMatrix(true, true);
        const before = light.matrixWorld.toArray().join();
        const fitted = fit_shadow(light, { receivers, steady: k % 2 === 1, ...(camera && { camera }) });
        moved += light.matrixWorld.toArray().join() !== before;
        finite &&= Object.values(fitted).every(value => typeof value !== 'number' || Number.isFinite(value));
        for (let i = 0; i < 40; ++i) {
            const point = at(random(), random(), random()).multiply(receivers.getSize(at())).add(receivers.min);
            const seen = camera ? point.clone().project(camera) : at();
            if (Math.max(...seen.toArray().map(Math.abs)) > 1) continue;
            const held = holds(light, point, fitted);
            tried += held !== undefined, outside += held === false;
        }
    }
    check(`${kind}: ${outside} of ${tried} receivers outside the map`, outside === 0 && tried > 2000);
    check(`${kind}: numbers are finite, the light is where it was`, finite && moved === 0 && n >= 0);
}

{  // a camera that walks and turns over a wide floor
    const light = new THREE.DirectionalLight(), receivers = new THREE.Box3(at(-500, 0, -500), at(500, 3, 500));
    const camera = new THREE.PerspectiveCamera(50, 1.5, 0.1, 60), starts = { x: [], y: [] }, texels = new Set();
    light.position.set(3, 5, 2);
    for (let frame = 0; frame < 40; ++frame) {
        camera.position.set(frame * 0.37, 2, frame * 0.71);
        camera.lookAt(camera.position.x + Math.cos(frame / 9), 1.8, camera.position.z + Math.sin(frame / 9));
        light.position.set(3, 5, 2).addScalar(frame * 0.13);  // it follows, as many do
        light.target.position.setScalar(frame * 0.13);
        const { texels_per_unit } = fit_shadow(light, { receivers, camera, steady: true });
        texels.add(texels_per_unit);
        const map = light.shadow.updateMatrices(light) ?? light.shadow.matrix, origin = at().applyMatrix4(map);
        for (const axis of ['x', 'y']) starts[axis].push(origin[axis] * light.shadow.mapSize[axis]);
    }
    const fraction = value => Math.abs(value - starts.x[0] - Math.round(value - starts.x[0]));
    const off = Math.max(...starts.x.map(fraction), ...starts.y.map(value => Math.abs(value - starts.y[0] - Math.round(value - starts.y[0]))));
    check(`steady: texels of ${texels.size} size, off the grid by ${off.toExponential(1)} texels`, texels.size === 1 && off < 1e-6);
}

{  // what it says
    const sun = new THREE.DirectionalLight(), floor = new THREE.Mesh(new THREE.PlaneGeometry(40, 40)), wide = new THREE.Box3(at(-500, 0, -500), at(500, 3, 500));
    const camera = new THREE.PerspectiveCamera(50, 1.5, 0.1, 1000), near = new THREE.Box3(at(-2, 0, -2), at(2, 1, 2));
    camera.position.set(0, 2, 0);
    camera.lookAt(5, 1, 0);
    sun.position.set(1, 4, 2);
    floor.rotation.x = -Math.PI / 2;
    floor.receiveShadow = true;
    const flat = fit_shadow(sun, { receivers: floor }), { bias, normalBias } = sun.shadow;
    check(`a floor alone: ${flat.texels_per_unit} texels per unit`, flat.texels_per_unit > 8 && bias === 0 && normalBias === flat.detachment);
    const fine = fit_shadow(sun, { receivers: floor, renderer: { shadowMap: { type: THREE.BasicShadowMap } } });
    check(`basic detaches less: ${fine.detachment} and ${flat.detachment}`, fine.detachment < 0.5 * flat.detachment);
    sun.shadow.normalBias = 0.5;
    const soft = fit_shadow(sun, { receivers: floor, renderer: { shadowMap: { type: THREE.VSMShadowMap } } });
    check('variance maps keep their bias', sun.shadow.normalBias === 0.5 && !soft.bias_is_set && soft.detachment === undefined);
    const far = fit_shadow(sun, { receivers: wide, camera }).cascades, small = fit_shadow(sun, { receivers: near, camera: floor_camera() }).cascades;
    check(`cascades: ${JSON.stringify(far)} over a plain, ${JSON.stringify(small)} over a table`, far.pay && far.finer > 4 && !small.pay);
    const spot = new THREE.SpotLight(0xffffff, 1, 0, 1), held = new THREE.Box3(at(-1, 0, -1), at(1, 0.2, 1));
    spot.position.set(0, 10, 0);
    fit_shadow(spot, { receivers: held });
    check(`a spot's map is as narrow as its receivers: focus ${spot.shadow.focus}`, spot.shadow.focus < 0.2);
    spot.map = new THREE.Texture();
    fit_shadow(spot, { receivers: held });
    check('but for a spot that projects a picture', spot.shadow.focus === 1);
    const inside = fit_shadow(new THREE.PointLight(), { receivers: held });
    check('a light inside a caster says that it is cut', inside.casters_are_cut && inside.near > 0);
    const scene = new THREE.Scene(), floor_mesh = new THREE.Mesh(new THREE.PlaneGeometry(20, 20)), box = new THREE.Mesh(new THREE.BoxGeometry());
    const lamp = new THREE.PointLight(), turned = new THREE.Group().add(floor_mesh, box, lamp);
    floor_mesh.rotation.x = -Math.PI / 2;
    floor_mesh.receiveShadow = box.castShadow = lamp.castShadow = true;
    box.position.y = 0.5;
    lamp.position.y = 3;
    turned.rotation.set(0.5, 0.5, 0);  // the box around the floor now holds the lamp
    scene.add(turned);
    const above = fit_shadow(lamp, { receivers: scene });
    check(`a receiver around a light is no caster: near ${above.near}`, !above.casters_are_cut && above.near > 1);
}

function floor_camera() {
    const camera = new THREE.PerspectiveCamera(50, 1.5, 0.1, 1000);
    camera.position.set(0, 6, 6);
    camera.lookAt(0, 0, 0);
    return camera;
}

{
    const sun = new THREE.DirectionalLight(), box = new THREE.Box3(at(-1, 0, -1), at(1, 1, 1)), spot = new THREE.SpotLight();
    const tiny = new THREE.DirectionalLight(), own = new THREE.DirectionalLight();
    tiny.shadow.mapSize.set(4, 4);
    own.shadow.filterNode = () => {};
    const nowhere = new THREE.Mesh(new THREE.BoxGeometry());
    nowhere.receiveShadow = nowhere.castShadow = true;
    nowhere.position.x = NaN;
    spot.angle = 1.55;
    /** A light with one of its own numbers changed. */
    const light_with = change => {
        const light = new THREE.DirectionalLight();
        change(light);
        return () => fit_shadow(light, { receivers: box });
    };
    const group = new THREE.Group(), objects = 'objects of three.js, finite boxes, or an array of them';
    for (const [what, call, part] of [
        ['no light', () => fit_shadow({}, { receivers: box }), 'light must be a DirectionalLight, SpotLight, PointLight or SunLight; got an object'],
        ['an ambient light', () => fit_shadow(new THREE.AmbientLight(), { receivers: box }), 'light must be a DirectionalLight'],
        ['no options', () => fit_shadow(sun), `receivers must be ${objects}; got undefined`],
        ['null', () => fit_shadow(sun, null), 'options must be an object; got null'],
        ['an empty box', () => fit_shadow(sun, { receivers: new THREE.Box3() }), `receivers must be ${objects}; got `],
        ['no part', () => fit_shadow(sun, { receivers: [] }), `receivers must be ${objects}; got []`],
        ['a number', () => fit_shadow(sun, { receivers: box, casters: 3 }), `casters must be ${objects}; got 3`],
        ['an empty group', () => fit_shadow(sun, { receivers: group }), 'receivers must have a visible mesh with receiveShadow; got none'],
        ['no camera', () => fit_shadow(sun, { receivers: box, camera: group }), 'camera must be a camera of three.js; got '],
        ['steady', () => fit_shadow(sun, { receivers: box, steady: 1 }), 'steady must be true or false; got 1'],
        ['a misspelled option', () => fit_shadow(sun, { receivers: box, caster: box }), 'options must have no properties but receivers, casters, '],
        ['a renderer', () => fit_shadow(sun, { receivers: box, renderer: {} }), 'renderer must be a renderer of three.js; got '],
        ['a reach', () => fit_shadow(sun, { receivers: box, reach: -1 }), 'reach must be a finite number of texels, 0 or more; got -1'],
        ["someone else's filter", () => fit_shadow(own, { receivers: box }), "reach must be given for a filterNode that is not this package's"],
        ['a tiny map', () => fit_shadow(tiny, { receivers: box }), 'light.shadow.mapSize must have more texels for a filter that reaches 2.4; got [4, 4]'],
        ['a size of NaN', light_with(light => light.shadow.mapSize.setX(NaN)), 'light.shadow.mapSize must be two integers above 0; got [NaN, 512]'],
        ['a radius of NaN', light_with(light => { light.shadow.radius = NaN; }), 'light.shadow.radius must be finite; got NaN'],
        ['a place of NaN', light_with(light => light.position.setY(NaN)), 'light must be at a finite place in the world; got [0, NaN, 0]'],
        ['a target of NaN', light_with(light => light.target.position.setX(NaN)), 'light.target must be at a finite place in the world; got [NaN, 0, 0]'],
        ['a mesh of NaN', () => fit_shadow(sun, { receivers: nowhere }), 'receivers must be at a finite place in the world; got [NaN, '],
        ['a caster of NaN', () => fit_shadow(sun, { receivers: box, casters: [box, nowhere] }), 'casters must be at a finite place in the world; got [NaN, '],
        ['a wide spot', () => fit_shadow(spot, { receivers: box }), 'light.angle must be above 0 and at most 1.5 radians; got 1.55'],
    ]) {
        let said = 'accepted';
        try { call(); } catch (error) { said = error.message; }
        check(`${what}: ${said}`, said.startsWith('umbrage/three: fit_shadow: ') && said.includes(part));
    }
    const endless = new THREE.PointLight();
    endless.distance = -5;  // three.js' shaders take it for none
    check('a distance below 0 is none', fit_shadow(endless, { receivers: box }).far > 0);
    check("someone else's filter with its reach", fit_shadow(own, { receivers: box, reach: 3 }).reach === 3);
}
/** What install needs of a renderer. */
const bare_renderer = () => Object.create(THREE.WebGLRenderer.prototype, { state: { value: { buffers: { depth: { getReversed: () => false } } } },
    shadowMap: { value: { type: THREE.PCFShadowMap } } });

{  // before install it fits for three.js' PCF, which is too little, and after it for the filter
    const sun = new THREE.DirectionalLight(), receivers = new THREE.Box3(at(-9, 0, -9), at(9, 2, 9)), pcf = Math.sqrt(0.9) + Math.SQRT2;
    const before = fit_shadow(sun, { receivers });
    install(THREE, bare_renderer(), { filter: castano_dyadic5 });
    check('install alone changes no bias', sun.shadow.normalBias === before.normal_bias);
    const after = fit_shadow(sun, { receivers });
    check(`fitted before install: ${before.reach} texels, after it: ${after.reach}`, before.reach === pcf && after.reach > 1.5 * pcf);
    check('and a bias to match', sun.shadow.normalBias > 1.4 * before.normal_bias);
    install(THREE, bare_renderer(), { filter: hard });
    check('another filter: fitted again', fit_shadow(sun, { receivers }).reach < pcf);
    uninstall(THREE);
    check("after uninstall: three.js' PCF", fit_shadow(sun, { receivers }).reach === pcf);
}
{  // a light's size
    const renderer = bare_renderer();
    const sun = new THREE.DirectionalLight(), { shadow } = sun, spot = new THREE.SpotLight(0xffffff, 1, 0, 0.5);
    shadow.radius = 3;
    set_light_size(sun, 0.05);
    check('without a search the radius is its own', shadow.radius === 3);
    install(THREE, renderer, { filter: pcss16 });
    // a penumbra across all depths, in 256 texels: 0.05 x 499.5 units, of 10 / 512 units each
    const wide = 0.05 * 499.5 / (10 / 512) / 256;
    check(`with one it is the light's, to 8 bits: ${shadow.radius} for ${wide}`, Math.abs(shadow.radius / wide - 1) <= 1 / 256);
    const before = shadow.radius;
    shadow.camera.far = 250;
    check('it follows the camera', Math.abs(shadow.radius / before * 499.5 / 249.5 - 1) < 1 / 128);
    shadow.mapSize.set(1024, 1024);
    check('and the map', Math.abs(shadow.radius / before * 499.5 / 249.5 / 2 - 1) < 1 / 128);
    set_light_size(spot, 0.2);
    spot.shadow.camera.near = 1;
    spot.distance = 20;
    const tight = 0.2 * 512 / (2 * Math.tan(0.5)) * 19 / 20 / 256;  // between distances of 1 and 20
    check(`a spot: ${spot.shadow.radius} for ${tight}`, Math.abs(spot.shadow.radius / tight - 1) <= 1 / 256);
    set_light_size(spot, 0);
    check('no size: no penumbra', spot.shadow.radius === 0);
    install(THREE, renderer, { filter: hard });
    check('another filter: the radius that was set', shadow.radius === 3);
    uninstall(THREE);
    for (const [what, call, part] of [
        ['a point light', () => set_light_size(new THREE.PointLight(), 1), 'light must be a DirectionalLight or a SpotLight; got PointLight'],
        ['a size', () => set_light_size(sun, -1), 'light_size must be finite, 0 or more; got -1'],
        ['no size', () => set_light_size(sun), 'light_size must be finite, 0 or more; got undefined'],
    ]) {
        let said = 'accepted';
        try { call(); } catch (error) { said = error.message; }
        check(`${what}: ${said}`, said === `umbrage/three: set_light_size: ${part}`);
    }
}
process.exitCode = failed ? 1 : 0;
