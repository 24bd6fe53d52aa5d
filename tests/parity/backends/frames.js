// SPDX-License-Identifier: MIT
//
// Blocks of bytes on standard input and output, each with its length in four bytes before it; see child.hpp.
'use strict';

/// Calls take(block) for each.
async function collect(stream, take) {
    let chunks = [], held = 0;
    for await (const chunk of stream) {
        chunks.push(chunk);
        held += chunk.length;
        for (;;) {
            if (held < 4) break;
            if (chunks[0].length < 4) chunks = [Buffer.concat(chunks)];
            const length = chunks[0].readUInt32LE(0);
            if (held < 4 + length) break;
            const all = Buffer.concat(chunks);
            await take(all.subarray(4, 4 + length));
            chunks = [all.subarray(4 + length)];
            held -= 4 + length;
        }
    }
}

function send(block, then) {
    const length = Buffer.alloc(4);
    length.writeUInt32LE(block.length);
    process.stdout.write(length);
    process.stdout.write(block, then);
}

/// Answers each block with answer(block), behind a zero; where that throws, with what it says, behind a one.
function serve(answer) {
    return collect(process.stdin, async block => {
        let status = 0, result;
        try {
            result = await answer(block);
        } catch (error) {
            status = 1;
            result = Buffer.from(error.formatted || error.message);
        }
        send(Buffer.concat([Buffer.from([status]), result]));
    });
}

module.exports = { collect, send, serve };
