// SPDX-License-Identifier: MIT
//
// Turns the camera or the light by mouse, touch and keys.
import { ranges } from './choices';
import type { State } from './state';

const inside = (name: keyof typeof ranges, value: number) =>
    Math.min(Math.max(value, ranges[name].low), ranges[name].high);
const around = (degrees: number) => ((degrees + 180) % 360 + 360) % 360 - 180;

/** @param moves_light  true when a drag moves the light; with Shift or the right button it does the other */
export function drag(canvas: HTMLCanvasElement, state: () => State, moves_light: () => boolean, changed: (part: Partial<State>) => void) {
    function turn(x: number, y: number, light: boolean) {
        const s = state();
        if (light) changed({ azimuth: around(s.azimuth + x), elevation: inside('elevation', s.elevation - y) });
        else changed({ yaw: around(s.yaw - x), pitch: inside('pitch', s.pitch + y) });
    }
    const zoom = (by: number) => changed({ distance: inside('distance', state().distance * by) });
    const fingers = new Map<number, { x: number; y: number }>();
    const apart = () => {
        const [a, b] = [...fingers.values()];
        return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
    };

    canvas.oncontextmenu = event => event.preventDefault();
    canvas.onpointerdown = event => {
        canvas.setPointerCapture(event.pointerId);
        fingers.set(event.pointerId, event);
    };
    canvas.onpointerup = canvas.onpointercancel = event => { fingers.delete(event.pointerId); };
    canvas.onpointermove = event => {
        const from = fingers.get(event.pointerId);
        if (!from) return;
        const before = apart();
        fingers.set(event.pointerId, event);
        if (before && apart()) return zoom(before / apart());
        const other = event.shiftKey || (event.buttons & 2) !== 0, degrees = 180 / Math.max(canvas.clientWidth, 1);
        turn((event.clientX - from.x) * degrees, (event.clientY - from.y) * degrees, moves_light() !== other);
    };
    canvas.addEventListener('wheel', event => {
        if (!event.ctrlKey && document.activeElement !== canvas) return;  // the page scrolls until the picture is taken up
        event.preventDefault();
        zoom(Math.exp(event.deltaY * 0.001));
    }, { passive: false });
    canvas.onkeydown = event => {
        const steps: Record<string, [number, number]> = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, -5], ArrowDown: [0, 5] };
        const step = steps[event.key];
        if (step) turn(...step, moves_light() !== event.shiftKey);
        else if (event.key === '+' || event.key === '=') zoom(0.9);
        else if (event.key === '-') zoom(1 / 0.9);
        else return;
        event.preventDefault();
    };
}
