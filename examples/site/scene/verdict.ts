// SPDX-License-Identifier: MIT
//
// What the page says of the picture that it shows. A verdict belongs to one picture, and is gone when there is another.
import { encodings, exactness } from 'umbrage';

import type { State } from './state';

export type Verdict =
    | { is: 'computing' }
    | { is: 'compared'; receivers: number; different: number; milliseconds: number }
    | { is: 'failed'; why: string };

const computing: Verdict = { is: 'computing' };

/** The picture that is shown, by its number, and what is known of it. */
export class Verdicts {
    number = 0;
    private known = { of: this.number, verdict: computing };

    get current(): Verdict {
        return this.known.of === this.number ? this.known.verdict : computing;
    }

    /** Another picture is to be shown. */
    forget() {
        ++this.number;
    }

    /** @return  false, and nothing changes, if the verdict is of a picture of before */
    accept(of: number, verdict: Verdict): boolean {
        if (of !== this.number) return false;
        this.known = { of, verdict };
        return true;
    }
}

/** True of formats whose decoding is not of tier A. */
const rounds = (encoding: State['encoding']) => exactness(encodings[encoding].needs ?? []) !== 'a';

/** A verdict in words, and the class that colors them. */
export function sentence(verdict: Verdict, encoding: State['encoding']): { words: string; look: 'faint' | 'good' | 'amber' | 'bad' } {
    if (verdict.is === 'computing') return { words: 'C++ is computing this picture ...', look: 'faint' };
    if (verdict.is === 'failed') return { words: `C++ gave no answer: ${verdict.why}`, look: 'bad' };
    const { receivers, different } = verdict;
    if (receivers === 0) return { words: 'No surface is in this picture: there is nothing to compare', look: 'faint' };
    const words = `${different.toLocaleString('en')} of ${receivers.toLocaleString('en')} pixels differ between your GPU and C++`;
    if (different === 0) return { words, look: 'good' };
    const reason = rounds(encoding) ? ". This format's decoding rounds, and WebGL may regroup its sum: tier B" : '';
    return { words: words + reason, look: 'amber' };
}
