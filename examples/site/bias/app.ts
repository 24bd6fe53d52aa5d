// SPDX-License-Identifier: MIT
//
// The bias page: numbers for an engine's light, and its picture with these and with its defaults. All that is chosen is in the
// address.
import { engine_bias, engines, formula_of, lights_of, type AnyMap, type Engine, type Judged, type LightKind } from '../../../single_include/npm/engines.mjs';
import { copy } from '../clipboard';
import { code_of } from './code';
import { draw, units_across } from './picture';
import { shown, type Shown } from './shown';
import { first_filter, limits, read_state, usual_range, write_state, type State } from './state';

const by_id = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;
const form = by_id<HTMLFormElement>('light'), notice = by_id('notice'), filter = by_id<HTMLSelectElement>('filter');
const kind = by_id<HTMLSelectElement>('kind');
let state: State, refused: string[], is_asked = false;

const short = (value: number): string => String(Number(value.toPrecision(3)));
const percent = (share: number): string => (share === 0 ? '0 %' : share < 0.001 ? 'below 0.1 %' : `${(100 * share).toFixed(1)} %`);

function show_form(): void {
    for (const name of ['engine', 'map_size', 'width', 'range', 'angle', 'radius', 'sun'] as const) {
        const field = by_id<HTMLInputElement | HTMLSelectElement>(name), value = String(state[name]);
        if (field.value !== value) field.value = value;
    }
    const { engine } = state, own = engine === 'other' ? [] : Object.keys(engines[engine].filters);
    filter.replaceChildren(...own.map(name => new Option(name, name, false, name === state.filter)));
    kind.replaceChildren(...(engine === 'other' ? [] : lights_of(engine)).map(name => new Option(name, name, false, name === state.light)));
    by_id('radius_field').hidden = engine === 'other' || !engines[engine].radius;
    if (engine !== 'other') by_id('radius_name').textContent = engines[engine].radius ?? '';
    by_id('sun_degrees').textContent = `${state.sun}°`;
    for (const field of form.querySelectorAll<HTMLElement>('.of_engine')) field.hidden = engine === 'other';
    for (const element of document.querySelectorAll<HTMLElement>('.of_directional')) element.hidden = engine === 'other' || state.light !== 'directional';
    by_id('angle').closest('label')!.hidden = engine === 'other' || state.light !== 'spot';
    by_id('range_words').textContent = state.light === 'directional' ? 'near to far plane, world units' : 'the light reaches, world units';
    by_id('no_numbers').hidden = engine !== 'other';
}

/** One column of the table and one picture. */
function show_side(side: 'these' | 'defaults', { settings, detachment, edges, striped }: Judged, texel: number, { shadow, place, all, floor }: Shown): void {
    const cells: Record<string, string> = {
        settings: Object.entries(settings).map(([name, value]) => `${name} ${value}`).join(', '),
        striped: striped ? `${Math.round(striped[0])}° to ${Math.round(striped[1])}°` : 'none',
        all: percent(all(settings)),
        floor: percent(floor(settings)),
        detachment: `${short(detachment)} units, ${short(detachment / texel)} texels`,
        edges: edges >= 89 ? 'all' : `up to ${Math.round(edges)}°`,
    };
    for (const [name, text] of Object.entries(cells)) by_id(`${side}_${name}`).textContent = text;
    draw(by_id<HTMLCanvasElement>(`picture_${side}`), shadow(settings), place);
}

function options_of({ engine, light, filter, radius, map_size, width, range, angle }: State): AnyMap {
    if (engine === 'other') throw new Error('no numbers for another engine');
    const all = { engine, filter, map_size, range, ...(engines[engine].radius && { radius }) };
    return light === 'directional' ? { ...all, light, width } : light === 'spot' ? { ...all, light, angle } : { ...all, light };
}

/** Numbers and pictures of an engine.
 *  @return   what is wrong with them, in words */
function show_found(engine_name: Engine): string[] {
    const engine = engines[engine_name], bias = engine_bias(options_of(state)), { formula, sources } = formula_of(engine_name, state.light);
    by_id('code').textContent = code_of[engine_name](bias.settings, state.light);
    const sides = shown(options_of(state), state.sun), { place: { unit }, texel } = sides;
    show_side('these', bias, bias.texel, sides);
    show_side('defaults', bias.defaults, bias.texel, sides);
    by_id('scale').textContent = `The pictures are ${short(units_across * unit)} units wide${state.light === 'directional' ? '' : ', at four fifths of the range'}. `
        + `A texel is ${short(texel)} units there, the board is ${short((1.5 * unit) / texel)} texels thick.`;
    by_id('formula').textContent = formula;
    by_id('version').textContent = `${engine.title}, ${engine.version}`;
    by_id('sources').replaceChildren(...sources.map(source => Object.assign(document.createElement('li'), { textContent: source })));
    return bias.lacking > 0
        ? [`${engine.title}'s settings cannot end all acne here: ${short(bias.lacking)} texels are missing at tilts from ${bias.striped![0]}° to ${bias.striped![1]}°.`]
        : [];
}

/** Shows what was found, which takes longer than the form. */
function show(): void {
    const told = refused.map(each => `The address has "${each}", which is left out.`), { engine } = state;
    let is_found = engine !== 'other';
    try {
        if (engine !== 'other') told.push(...show_found(engine));
    } catch (error) {
        const { message } = error as Error, of_package = 'umbrage/engines: engine_bias: ';  // a light that no bias serves
        if (!message.startsWith(of_package)) throw error;
        is_found = false;
        told.push(`There are no numbers for this light: ${message.slice(of_package.length)}.`);
    }
    by_id('found').hidden = !is_found;
    notice.textContent = told.join(' ');
    notice.hidden = told.length === 0;
    by_id('bias_page').classList.remove('loading');
}

function changed(): void {
    const wrong = Object.entries(limits).filter(([name]) => !by_id<HTMLInputElement>(name).checkValidity());
    if (wrong.length > 0) return;  // the browser says which number it is
    const before = state, value = (name: string) => by_id<HTMLInputElement>(name).value;
    state = { ...state, engine: value('engine') as State['engine'], light: value('kind') as LightKind || state.light, filter: value('filter') || state.filter, map_size: Number(value('map_size')),
        width: Number(value('width')), range: Number(value('range')), angle: Number(value('angle')), radius: Number(value('radius')), sun: Number(value('sun')) };
    if (state.engine !== before.engine && state.engine !== 'other') state = { ...state, light: 'directional', filter: first_filter(state.engine), radius: 1 };
    if (usual_range(state.light) !== usual_range(before.light)) state.range = usual_range(state.light);
    refused = [];
    history.replaceState(null, '', write_state(state));
    show_form();  // at once, since the next change reads all fields
    if (!is_asked) requestAnimationFrame(() => { is_asked = false; show(); });
    is_asked = true;
}

/** Says on a button that it has done its work. */
function copies(name: string, text: () => string, words: string): void {
    const button = by_id<HTMLButtonElement>(name), before = button.textContent;
    button.onclick = async () => {
        button.textContent = (await copy(text())) ? words : 'Not allowed';
        setTimeout(() => (button.textContent = before), 1500);
    };
}

function read_address(): void {
    ({ state, refused } = read_state(location.hash));
    show_form();
    show();
}

form.addEventListener('input', changed);
form.addEventListener('submit', event => event.preventDefault());
copies('copy', () => by_id('code').textContent!, 'Copied');
copies('link', () => new URL(write_state(state), location.href).href, 'Link copied');
window.addEventListener('hashchange', read_address);
read_address();
