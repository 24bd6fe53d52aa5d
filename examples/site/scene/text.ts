// SPDX-License-Identifier: MIT
//
// Shows the picture's shadow as a shader, with a tab for each language and a button that copies all of it. The library's
// part is folded.
import { copy } from '../clipboard';
import { highlight, type Language } from '../highlight';
import { asked_of } from './light';
import { lines_of } from './lines';
import { turns } from './passes';
import type { State } from './state';

export class Text {
    private language: Language = 'glsl';
    private shown = '';
    private text = '';

    constructor(private readonly place: HTMLElement, private readonly state: () => State) {
        for (const tab of place.querySelectorAll<HTMLInputElement>('input[name=language]'))
            tab.onchange = () => { this.language = tab.value as Language; this.show(); };
        const button = place.querySelector('button')!;
        button.onclick = async () => {
            button.textContent = await copy(this.text) ? 'Copied' : 'Not allowed: select the text';
            setTimeout(() => { button.textContent = 'Copy'; }, 1500);
        };
    }

    show() {
        const asked = asked_of(this.state()), key = this.language + JSON.stringify(asked);
        if (key === this.shown) return;
        this.shown = key;
        void lines_of(asked, this.language, turns(asked.filter)).then(({ library, main }) => {
            if (key !== this.shown) return;
            this.text = `${library}\n${main}`;
            const [folded, called] = this.place.querySelectorAll('pre code');
            folded!.innerHTML = highlight(library, this.language);
            called!.innerHTML = highlight(main, this.language);
            this.place.querySelector('summary')!.textContent = `${library.split('\n').length - 1} lines of umbrage`;
        });
    }
}
