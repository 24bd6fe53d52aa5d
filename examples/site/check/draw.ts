// SPDX-License-Identifier: MIT
//
// Two drawings of an answer: the input on which two functions differ, and the texels that a filter reads.
import type { Verdict } from './engine';

function svg(name: string, attributes: Record<string, string | number>, ...inside: (string | Node)[]): SVGElement {
    const made = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
    made.append(...inside);
    return made;
}

/** A float in few digits that still tell it apart. */
export const short = (value: number) => (Number.isNaN(value) ? 'NaN' : String(Number(value.toPrecision(7))));

/** A map with the depth in each texel, dark where it is nearer than the receiver, and the receiver's place. */
export function draw_map({
    size: [columns, rows],
    map,
    input: [x, y, receiver],
}: NonNullable<Verdict['first']>): SVGElement {
    const place = Number.isFinite(x) && Number.isFinite(y),
        reach = 3,
        within = (v: number, most: number) => Math.min(Math.max(v, -reach), most + reach);
    const at = place ? ([within(x, columns), within(y, rows)] as const) : ([0, 0] as const);
    const left = Math.min(0, at[0] - 0.5),
        top = Math.min(0, at[1] - 0.5);
    const width = Math.max(columns, at[0] + 0.5) - left,
        height = Math.max(rows, at[1] + 0.5) - top;
    const cells = map.map((depth, i) => {
        const column = i % columns,
            row = Math.floor(i / columns),
            dark = depth < receiver;
        const cell = svg(
            'g',
            { class: dark ? 'nearer' : 'farther' },
            svg('rect', { x: column, y: row, width: 1, height: 1 }),
        );
        if (columns <= 8 && rows <= 8)
            cell.append(
                svg(
                    'text',
                    { x: column + 0.5, y: row + 0.92, 'font-size': Math.min(0.26, 1.5 / short(depth).length) },
                    short(depth),
                ),
            );
        return cell;
    });
    const mark = place
        ? [svg('circle', { class: 'place', cx: at[0], cy: at[1], r: Math.max(width, height) / 40 })]
        : [];
    const rem = Math.min(20, 7 * Math.max(width, height));
    return svg(
        'svg',
        {
            class: 'drawn',
            style: `width: ${rem}rem`,
            viewBox: `${left - 0.1} ${top - 0.1} ${width + 0.2} ${height + 0.2}`,
            role: 'img',
            'aria-label':
                `A map of ${columns} x ${rows} texels` +
                (place ? `, with the receiver at ${short(x)}, ${short(y)}` : ''),
        },
        ...cells,
        ...mark,
    );
}

/** Weights by the texel's offset from the receiver, which is the circle. Lines are whole texels apart. */
export function draw_footprint({
    steps,
    first,
    size: [columns, rows],
    weights,
}: NonNullable<Verdict['seen']>): SVGElement | null {
    const used = weights.flatMap((weight, i) => (Math.abs(weight) > 1e-4 ? [i] : []));
    if (used.length === 0) return null;
    const step = 1 / steps,
        most = Math.max(...used.map(i => Math.abs(weights[i]!)));
    const cells = used.map(i =>
        svg('rect', {
            class: weights[i]! < 0 ? 'negative' : 'weight',
            x: first[0] + (i % columns) * step - step / 2,
            y: first[1] + Math.floor(i / columns) * step - step / 2,
            width: step,
            height: step,
            opacity: Math.abs(weights[i]!) / most,
        }),
    );
    // what is drawn: all weights and the receiver, to whole texels
    const xs = used.map(i => first[0] + (i % columns) * step),
        ys = used.map(i => first[1] + Math.floor(i / columns) * step);
    const [left, top] = [Math.floor(Math.min(...xs, -1) - 0.01), Math.floor(Math.min(...ys, -1) - 0.01)];
    const [right, bottom] = [Math.ceil(Math.max(...xs, 1) + 0.01), Math.ceil(Math.max(...ys, 1) + 0.01)];
    let lines = '';
    for (let x = left; x <= right; ++x) lines += `M${x} ${top}V${bottom}`;
    for (let y = top; y <= bottom; ++y) lines += `M${left} ${y}H${right}`;
    return svg(
        'svg',
        {
            class: 'drawn',
            viewBox: `${left - 0.1} ${top - 0.1} ${right - left + 0.2} ${bottom - top + 0.2}`,
            role: 'img',
            'aria-label':
                `Weights of texels from ${short(Math.min(...xs))} to ${short(Math.max(...xs))} ` +
                `texels beside the receiver, and from ${short(Math.min(...ys))} ` +
                `to ${short(Math.max(...ys))} above and below it`,
        },
        ...cells,
        svg('path', { class: 'lines', d: lines }),
        svg('circle', { class: 'place', cx: 0, cy: 0, r: (right - left) / 40 }),
    );
}
