// SPDX-License-Identifier: MIT

/// Layout shift of a page since it began to load, as browsers count it.
export const layout_shift = page =>
    page.evaluate(
        () =>
            new Promise(done => {
                let sum = 0;
                new PerformanceObserver(list => {
                    for (const each of list.getEntries()) sum += each.value;
                }).observe({ type: 'layout-shift', buffered: true });
                setTimeout(() => done(sum), 200);
            }),
    );
