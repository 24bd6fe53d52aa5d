// SPDX-License-Identifier: MIT
//
// The live scene: a state, the GPU's picture of it, C++'s answer beside it, and the text that both run.
import { encodings, exactness } from 'umbrage';
import { load_values } from 'umbrage/values';

import type { Answer } from './check_worker';
import { Controls } from './controls';
import { drag } from './drag';
import { box_of, read_scene, type Part, type Scene } from './mesh';
import { Picture } from './picture';
import { read_state, write_state, type State } from './state';
import { Text } from './text';

const most_pixels = 8e5, most_bytes = 200e6;
const element = <T extends HTMLElement>(name: string) => document.querySelector<T>(`#${name}`)!;
const canvas = element<HTMLCanvasElement>('picture'), divider = element<HTMLInputElement>('divider'), verdict = element('verdict');
const { state: first, refused } = read_state(location.search);
let state = first, scene: Scene | undefined, picture: Picture | undefined;

function say(words: string) {
    element('said').textContent = words;
    element('said').hidden = words === '';
}

/** Distance of the camera and its vertical angle, in scenes that are files of this site and in dropped ones. */
const cameras = {
    garden: { camera_distance: 7.5, view_degrees: 34 },
    outdoor: { camera_distance: 64, view_degrees: 50 },
    dropped: { camera_distance: 6, view_degrees: 34 },
};
const made = new Map<string, Scene>();
function make(name: keyof typeof cameras, parts: Part[], target: Scene['target']) {
    made.set(name, { parts, box: box_of(parts), target, ...cameras[name] });
}
async function scene_named(name: keyof typeof cameras): Promise<Scene> {
    if (!made.has(name)) {
        const answer = await fetch(`scene/${name}.scene`);
        if (!answer.ok) throw new Error(`The scene ${name} could not be fetched: ${answer.status}.`);
        const { parts, target } = read_scene(await answer.arrayBuffer());
        make(name, parts, target);
    }
    return made.get(name)!;
}

// C++ answers for one frame at a time, when the visitor has stopped for a moment.
const check = new Worker('scene/check_worker.js', { type: 'module' });
let drawn = 0;     // number of the frame that was drawn last
let asked = 0;     // of the frame that C++ works on; 0: none
let answered = 0;  // of the frame whose answer is shown

/** True of formats whose decoding is not of tier A. */
const rounds = (encoding: State['encoding']) => exactness(encodings[encoding].needs ?? []) !== 'a';
function ask() {
    if (!picture || asked) return;
    const frame = picture.frame();
    asked = drawn;
    check.postMessage(frame, [frame.points.buffer, frame.normals.buffer, frame.map.buffer, frame.visibility.buffer]);
}
check.onmessage = ({ data }: MessageEvent<Answer | { error: string }>) => {
    const is_current = asked === drawn;
    asked = 0;
    if ('error' in data) verdict.textContent = `C++ gave no answer: ${data.error}`;
    else if (!is_current) ask();
    else {
        picture?.set_answer(data.visibility, data.places);
        answered = drawn;
        const { receivers, different, milliseconds } = data, maps = picture?.map_count;
        const pages = state.light === 'adaptive_pages' ? `${maps} of 64 pages. ` : '';
        element('time').textContent = `${pages}C++ took ${milliseconds.toFixed(0)} ms`;
        const reason = different && rounds(state.encoding) ? ". This format's decoding rounds, and WebGL may regroup its sum: tier B" : '';
        verdict.textContent = `${different.toLocaleString('en')} of ${receivers.toLocaleString('en')} pixels differ between your GPU and C++${reason}`;
        verdict.className = different ? 'amber' : 'good';
        Object.assign(canvas.dataset, { different, receivers, maps });
        show();
    }
};
check.onerror = () => { verdict.textContent = 'C++ gave no answer: this browser did not start its WebAssembly.'; };

function show() {
    const divided = answered === drawn && state.view === 'both';
    picture?.show(answered === drawn ? Number(divider.value) : 1);
    element('divided').style.setProperty('--at', divider.value);
    element('divided').hidden = !divided;
    divider.disabled = state.view !== 'both';
}

let drawing = false, stopped = 0;
function draw() {
    if (drawing) return;
    drawing = true;
    requestAnimationFrame(() => {
        drawing = false;
        if (!picture || !scene) return;
        const { clientWidth, clientHeight } = canvas, scale = Math.min(2, Math.sqrt(most_pixels / (clientWidth * clientHeight)));
        canvas.width = Math.round(clientWidth * scale);
        canvas.height = Math.round(clientHeight * scale);
        try {
            picture.draw(state, scene, canvas.width, canvas.height);
            ++drawn;
            show();
            element('time').textContent = '';
        } catch (error) {
            return say(error instanceof Error ? error.message : String(error));
        }
        clearTimeout(stopped);
        stopped = window.setTimeout(ask, 150);
    });
}

const text = new Text(element('lines'), () => state);
const controls = new Controls(element('controls'), part => void change(part));
let remembering = 0;
async function change(part: Partial<State>) {
    const before = state;
    state = { ...state, ...part };
    say('');
    if (state.scene !== before.scene || !scene) {
        try {
            scene = await scene_named(state.scene);
            picture?.set_scene(scene);
        } catch (error) {
            state = { ...state, scene: before.scene };
            say(error instanceof Error ? error.message : String(error));
        }
    }
    controls.show(state);
    for (const tab of document.querySelectorAll<HTMLInputElement>('input[name=view]')) tab.checked = tab.value === state.view;
    text.show();
    draw();
    clearTimeout(remembering);
    remembering = window.setTimeout(() => {
        const query = write_state(state);
        history.replaceState(null, '', query ? `?${query}` : location.pathname);
    }, 300);
}

function drop(file: File) {
    if (file.size > most_bytes) return say(`${file.name} has ${Math.ceil(file.size / 1e6)} MB. At most ${most_bytes / 1e6} MB are read.`);
    const reader = new Worker('scene/load_worker.js', { type: 'module' });
    say(`Reading ${file.name} ...`);
    reader.onmessage = ({ data }: MessageEvent<{ parts: Part[] } | { refused: string }>) => {
        reader.terminate();
        if ('refused' in data) return say(data.refused);
        make('dropped', data.parts, [0, 0.9, 0]);
        scene = undefined;
        void change({ scene: 'dropped', distance: 1 });
    };
    reader.onerror = () => say(`${file.name} could not be read: this browser did not start the reader.`);
    void file.arrayBuffer().then(bytes => reader.postMessage({ name: file.name, file: bytes }, [bytes]));
}

async function start() {
    const gl = canvas.getContext('webgl2', { antialias: false, preserveDrawingBuffer: true });
    if (!gl) throw new Error('This browser has no WebGL 2, so the scene cannot be drawn here.');
    const values = await load_values();
    picture = new Picture(gl, values);
    if (refused.length) say(`The address asks for what this page does not have: ${refused.join(', ')}. It shows the default instead.`);
    const words = element('said').textContent ?? '';
    await change({});
    say(words);
    canvas.addEventListener('webglcontextlost', event => {
        event.preventDefault();
        say('The browser took the graphics away. The scene comes back when it returns them.');
    });
    canvas.addEventListener('webglcontextrestored', () => {
        picture = new Picture(gl, values);
        if (scene) picture.set_scene(scene);
        say('');
        draw();
    });
    new ResizeObserver(draw).observe(canvas);
    drag(canvas, () => state, () => element<HTMLInputElement>('drag-light').checked, part => void change(part));
    divider.oninput = show;
    for (const tab of document.querySelectorAll<HTMLInputElement>('input[name=view]'))
        tab.onchange = () => void change({ view: tab.value as State['view'] });
    element<HTMLInputElement>('file').onchange = event => {
        const [file] = (event.target as HTMLInputElement).files ?? [];
        if (file) drop(file);
    };
    document.body.addEventListener('dragover', event => event.preventDefault());
    document.body.addEventListener('drop', event => {
        event.preventDefault();
        const [file] = event.dataTransfer?.files ?? [];
        if (file) drop(file);
    });
}
start().catch(error => {
    document.body.classList.add('no-scene');
    say(error instanceof Error ? error.message : String(error));
});
