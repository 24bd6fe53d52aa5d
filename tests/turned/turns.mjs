// SPDX-License-Identifier: MIT
//
// Changes the numbers of a program in JavaScript, one at a time, and counts what becomes of it: right, or refused by name.

const turns = { twice: v => 2 * v, half: v => v / 2, thousandth: v => v / 1000, zero: () => 0, negative: v => -v, nan: () => NaN };

/** Numbers of an object, as paths. */
const paths = (value, path = []) => (typeof value === 'number' ? [path]
    : Object.entries(value).flatMap(([key, inner]) => paths(inner, [...path, key])));

/** A copy with one number changed. */
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
     *  @param run        takes the numbers; returns what is wrong with the result, or undefined
     *  @param is_whole   paths of integers, whose fractions are no change */
    run_all(name, numbers, run, is_whole = () => false) {
        for (const path of [undefined, ...paths(numbers)])
            for (const [turn, of] of path ? Object.entries(turns) : [['', v => v]]) {
                const all = path ? changed(numbers, path, of) : numbers;
                const is_same = path && turn !== 'nan' && JSON.stringify(all) === JSON.stringify(numbers);
                const value = path?.reduce((v, k) => v[k], all);
                if (is_same || (path && is_whole(path) && !Number.isInteger(value) && turn !== 'nan')) ++this.counts.same;
                else this.count(`${name} ${path?.join('.') ?? 'as it is'}`, turn, () => run(all));
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
            const must_be_right = turn === 'twice' || turn === 'half' || turn === '';
            if (must_be_right && !is_limit) return this.fails(`${name} ${turn} is refused: ${error.message}`);
            return ++counts[must_be_right ? 'limits' : 'refused'];
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
