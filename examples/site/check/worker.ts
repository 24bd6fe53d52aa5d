// SPDX-License-Identifier: MIT
//
// Runs checks away from the page's thread.
import { carry_out, type Order } from './run';

addEventListener(
    'message',
    ({ data }: MessageEvent<Order | null>) => void carry_out(data, answer => postMessage(answer)),
);
