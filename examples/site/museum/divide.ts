// SPDX-License-Identifier: MIT
//
// Moves the dividers of the museum's drawings.
for (const figure of document.querySelectorAll<HTMLElement>('.exhibit')) {
    const divider = figure.querySelector('input')!;
    divider.oninput = () => figure.style.setProperty('--at', divider.value);
}
