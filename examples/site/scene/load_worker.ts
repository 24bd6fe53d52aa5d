// SPDX-License-Identifier: MIT
//
// Reads a dropped file beside the page, which stays responsive.
import { load, Refused } from './load';

self.onmessage = async ({ data: { name, file } }: MessageEvent<{ name: string; file: ArrayBuffer }>) => {
    try {
        self.postMessage({ parts: await load(name, file) });
    } catch (error) {
        const why = error instanceof Refused ? error.message
            : `${name} cannot be read: ${error instanceof Error ? error.message : String(error)}`;
        self.postMessage({ refused: why });
    }
};
