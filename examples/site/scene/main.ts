// SPDX-License-Identifier: MIT
//
// The live scene: a state, the GPU's picture of it, C++'s answer beside it, and the text that both run.
import { load_values } from 'umbrage/values';

import { compare } from './check';
import { Controls } from './controls';
import { drag } from './drag';
import { box_of, read_scene, type Part, type Scene } from './mesh';
import { Picture } from './picture';
import { read_state, write_state, type State } from './state';
import { Text } from './text';
import { sentence, Verdicts } from './verdict';

const most_pixels = 8e5, most_bytes = 200e6;
const element = <T extends HTMLElement>(name: string) => document.querySelector<T>(`#${name}`)!;
const canvas = element<HTMLCanvasElement>('picture'), divider = element<HTMLInputElement>('divider');
const { state: first, refused } = read_state(location.search);
let state = first, picture: Picture | undefined;

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
async function fetch_scene(name: keyof typeof cameras) {
    const answer = await fetch(`scene/${name}.scene`);
    if (!answer.ok) throw new Error(`The scene ${name} could not be fetched: ${answer.status}.`);
    const { parts, target } = read_scene(await answer.arrayBuffer());
    make(name, parts, target);
}

const words_of = (error: unknown) => error instanceof Error ? error.message : String(error);

// C++ answers for one frame at a time, when the visitor has stopped for a moment.
const verdicts = new Verdicts();
let drawn = 0;  // number of the picture that was drawn last
let asking = false;

async function ask() {
    if (!picture || picture.is_lost || asking || drawn !== verdicts.number) return;
    asking = true;
    const of = drawn;
    let is_accepted = false;
    try {
        const { visibility, places, receivers, different, milliseconds } = await compare(picture.frame());
        is_accepted = verdicts.accept(of, { is: 'compared', receivers, different, milliseconds });
        if (is_accepted) picture.set_answer(visibility, places);
    } catch (error) {
        is_accepted = verdicts.accept(of, { is: 'failed', why: words_of(error) });
    }
    asking = false;
    if (is_accepted) show();
    else void ask();
}

/** Shows the picture and what is known of it. */
function show() {
    const verdict = verdicts.current, { words, look } = sentence(verdict, state.encoding), maps = picture?.map_count;
    const is_compared = verdict.is === 'compared', pages = state.light === 'adaptive_pages' ? `${maps} of 64 pages. ` : '';
    if (element('verdict').textContent !== words) element('verdict').textContent = words;  // which is read out
    element('verdict').className = look;
    element('time').textContent = is_compared ? `${pages}C++ took ${verdict.milliseconds.toFixed(0)} ms` : '';
    canvas.dataset.compared = is_compared ? JSON.stringify({ different: verdict.different, receivers: verdict.receivers, maps }) : '';
    picture?.show(is_compared ? Number(divider.value) : 1);
    element('divided').style.setProperty('--at', divider.value);
    element('divided').hidden = !is_compared || state.view !== 'both';
    divider.disabled = state.view !== 'both';
}

/** Another picture is to be shown: what is known of the last one is forgotten. */
function forget() {
    const was_known = verdicts.current.is !== 'computing';
    verdicts.forget();
    if (was_known) show();
}

function set(part: Partial<State>) {
    state = { ...state, ...part };
    forget();
}

let drawing = false, stopped = 0;
function draw() {
    forget();
    if (drawing) return;
    drawing = true;
    requestAnimationFrame(() => {
        drawing = false;
        const scene = made.get(state.scene);
        if (!picture || !scene) return;
        const { clientWidth, clientHeight } = canvas, scale = Math.min(2, Math.sqrt(most_pixels / (clientWidth * clientHeight)));
        canvas.width = Math.round(clientWidth * scale);
        canvas.height = Math.round(clientHeight * scale);
        try {
            picture.draw(state, scene, canvas.width, canvas.height);
            drawn = verdicts.number;
        } catch (error) {
            return fail(error);
        }
        show();
        clearTimeout(stopped);
        stopped = window.setTimeout(ask, 150);
    });
}

/** There is no picture. */
function fail(error: unknown) {
    say(words_of(error));
    verdicts.accept(verdicts.number, { is: 'failed', why: 'there is no picture to compute' });
    show();
}

const text = new Text(element('lines'), () => state);
const controls = new Controls(element('controls'), part => void change(part));
let remembering = 0;
async function change(part: Partial<State>) {
    const before = state;
    set(part);
    say('');
    const name = state.scene;
    if (!made.has(name)) {
        try {
            await fetch_scene(name);
        } catch (error) {
            if (state.scene !== name) return;
            if (!made.has(before.scene)) return fail(error);
            set({ scene: before.scene });
            say(words_of(error));
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
        void change({ scene: 'dropped', distance: 1 });
    };
    reader.onerror = () => say(`${file.name} could not be read: this browser did not start the reader.`);
    void file.arrayBuffer().then(bytes => reader.postMessage({ name: file.name, file: bytes }, [bytes]));
}

async function start() {
    const gl = canvas.getContext('webgl2', { antialias: false, preserveDrawingBuffer: true });
    if (!gl) throw new Error('This browser has no WebGL 2, so the scene cannot be drawn here.');
    show();
    const values = await load_values();
    picture = new Picture(gl, values);
    if (refused.length) say(`The address asks for what this page does not have: ${refused.join(', ')}. It shows the default instead.`);
    const words = element('said').textContent ?? '';
    await change({});
    say(words);
    canvas.addEventListener('webglcontextlost', event => {
        event.preventDefault();
        forget();
        say('The browser took the graphics away. The scene comes back when it returns them.');
    });
    canvas.addEventListener('webglcontextrestored', () => {
        picture = new Picture(gl, values);
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
    say(words_of(error));
});
