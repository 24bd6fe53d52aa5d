// SPDX-License-Identifier: MIT
//
// The search box' script and what it searches. Every page's header has the box.
import { search_index } from './index.mjs';

export async function pages(context) {
    context.write('search.json', JSON.stringify(await search_index(context)));
    await context.bundle('search/box.ts', 'search.js');
    return [];
}
