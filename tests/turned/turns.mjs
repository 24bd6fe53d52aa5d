// SPDX-License-Identifier: MIT
//
// Changes the numbers and flags of a program in JavaScript, one at a time, and counts what becomes of it: right, or refused by
// name.

const turns = { twice: v => 2 * v, half: v => v / 2, thousandth: v => v / 1000, zero: () => 0, negative: v => -v, nan: () => NaN };
const turns_of_flag = { other: v => !v, number: v => Number(v), text: String };
const must_be_right = ['', 'twice', 'half', 'other'];

/** Numbers and flags of an object, as paths. */
const paths = (value, path = []) => (['number', 'boolean'].includes(typeof value) ? [path]
    : Object.entries(value).flatMap(([key, inner]) => paths(inner, [...path, key])));

/** A copy with one of them changed. */
function changed(value, [key, ...rest], turn) {
    if (key === undefined) return turn(value);
    const copy = Array.isArray(value) ? [...value] : { ...value };
    copy[key] = changed(value[key], rest, turn);
    return copy;
}

export class turned_programs {
    counts = { changes: 0, right: 0, refused: 0, limits: 0, same: 0 };
    failed = 0;

    /** @param limits   where twice or half may be refused, as [pattern of `program number turn`, the page that says so] */
    constructor(limits) {
        this.limits = limits;
    }

    fails(what) {
        ++this.failed;
        console.log(`FAILED: ${what}`);
    }

    /** Runs a program as it is, and with each of its numbers changed.
     *  @param run         takes the numbers; returns what is wrong with the result, or undefined
     *  @param is_whole    paths of integers, whose fractions are no change
     *  @param is_engine   paths of numbers that an engine takes, and no function of this package: twice and half alone */
    run_all(name, numbers, run, is_whole = () => false, is_engine = () => false) {
        for (const path of [undefined, ...paths(numbers)]) {
            const own = path?.reduce((v, k) => v[k], numbers);
            const all_turns = !path ? { '': v => v } : typeof own === 'boolean' ? turns_of_flag : turns;
            for (const [turn, of] of Object.entries(all_turns)) {
                if (path && is_engine(path) && !must_be_right.includes(turn)) continue;
                const all = path ? changed(numbers, path, of) : numbers, value = path?.reduce((v, k) => v[k], all);
                const is_same = path && turn !== 'nan' && JSON.stringify(all) === JSON.stringify(numbers);
                if (is_same || (typeof value === 'number' && is_whole(path) && !Number.isInteger(value) && turn !== 'nan')) ++this.counts.same;
                else this.count(`${name} ${path?.join('.') ?? 'as it is'}`, turn, () => run(all));
            }
        }
    }

    /** Counts a change: what is wrong with its result, or the message that it is refused with. */
    count(name, turn, run) {
        const { counts } = this, is_limit = this.limits.some(([pattern]) => pattern.test(`${name} ${turn}`));
        ++counts.changes;
        let wrong;
        try { wrong = run(); } catch (error) {
            const named = error instanceof Error && /^umbrage(::|\/|: )/.test(error.message) && error.message.includes(' must ');
            if (!named) return this.fails(`${name} ${turn}: ${error.message}`);
            const is_refused_badly = must_be_right.includes(turn);
            if (is_refused_badly && !is_limit) return this.fails(`${name} ${turn} is refused: ${error.message}`);
            return ++counts[is_refused_badly ? 'limits' : 'refused'];
        }
        if (wrong === undefined) return ++counts.right;
        if (is_limit) return ++counts.limits;
        return this.fails(`${name} ${turn}: ${wrong}`);
    }

    /** The last line of a test. */
    summary(right) {
        const { changes, right: count, refused, limits, same } = this.counts;
        return `${changes} changes: ${count} ${right}, ${refused} refused by name, ${limits} beyond a limit that a page states, `
            + `${this.failed} wrong; ${same} more change nothing`;
    }
}
