// SPDX-License-Identifier: MIT
//
// Copies a text, as every page of the site does.

/** @return  false where the browser refuses, or has no clipboard, as under plain HTTP */
export async function copy(text: string): Promise<boolean> {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        return false;
    }
}
