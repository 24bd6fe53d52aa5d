// SPDX-License-Identifier: MIT
//
// Error of every encoding over depth, one small plot each on a common logarithmic scale.
const width = 240, height = 44, least = -26, most = 0;  // powers of two

/// @param table  encodings.tsv of tests/proof/museum: name, bytes a texel, largest errors from depth 0 to 1
export function curves(table) {
    const rows = table.trim().split('\n').slice(1).map(line => {
        const [name, bytes, ...errors] = line.split('\t'), numbers = errors.map(Number);
        return { name, bytes, numbers, worst: Math.max(...numbers) };
    });
    const y = error => height * (1 - (Math.max(Math.log2(Math.max(error, 2 ** least)), least) - least) / (most - least));
    const line = numbers => numbers.map((error, i) => `${(i * width / (numbers.length - 1)).toFixed(1)},${y(error).toFixed(1)}`).join(' ');
    const plot = ({ name, numbers }) => `<svg viewBox="0 -1 ${width} ${height + 2}" width="${width}" height="${height + 2}" role="img" aria-label="Error of ${name} from depth 0 to 1">
<path d="M0 ${y(2 ** -8)}H${width}M0 ${y(2 ** -16)}H${width}M0 ${y(2 ** -24)}H${width}" class="grid"/><polyline points="${line(numbers)}"/></svg>`;
    const said = error => error === 0 ? '0' : `2<sup>${Math.log2(error).toFixed(1).replace('-', '−')}</sup>`;
    return `<p>From depth 0 at the left to 1 at the right. The lines across are errors of 2<sup>−8</sup>, 2<sup>−16</sup> and 2<sup>−24</sup>; lower is better.
An exact depth touches the ground.</p>
<div class="scroll" tabindex="0" role="region" aria-label="Table of errors"><table class="curves"><thead><tr><th>encoding</th><th>error over depth</th><th>largest</th><th>bytes</th></tr></thead>
<tbody>${rows.map(row => `<tr><td><code>${row.name}</code></td><td>${plot(row)}</td><td>${said(row.worst)}</td><td>${row.bytes}</td></tr>`).join('\n')}</tbody></table></div>`;
}
