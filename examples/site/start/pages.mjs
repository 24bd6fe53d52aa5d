// SPDX-License-Identifier: MIT
//
// What the page Start offers to download. The page itself is one of the repository's pages: see ../reference/model.mjs.
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';

import { downloads } from './text.mjs';

export async function pages(context) {
    context.copy('single_include/umbrage/umbrage.hpp', downloads.header);
    const pack = ['pack', join(context.root, 'single_include'), '--json', '--silent', '--pack-destination', context.work];
    const [{ filename }] = JSON.parse(execFileSync('npm', pack, { encoding: 'utf8' }));
    context.copy(join(context.work, filename), downloads.package);
    return [];
}
