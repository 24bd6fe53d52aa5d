// SPDX-License-Identifier: MIT
//
// Constant parts of the page: style, box for a snippet, and the script that fills the boxes.
#pragma once

namespace gallery {

inline constexpr char head[] = R"HTML(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<title>umbrage: gallery</title>
<style>
:root {
  color-scheme: light dark;
  --paper: #fbfaf7; --card: #fff; --ink: #1d1f22; --faint: #62666d; --line: #dcd9d1; --accent: #0b62a8;
}
@media (prefers-color-scheme: dark) {
  :root { --paper: #15171a; --card: #1d2024; --ink: #e7e5e0; --faint: #9aa0a8; --line: #34383e; --accent: #7db9f0 }
}
* { box-sizing: border-box }
body { margin: 0 auto; padding: 1rem; max-width: 76rem }
body { background: var(--paper); color: var(--ink); font: 1rem/1.5 system-ui, sans-serif }
h1, h2, h3 { line-height: 1.2 }
h2 { margin: 3rem 0 .5rem }
h3 { margin: 0 0 .25rem }
p { margin: 0 0 1rem; max-width: 60rem }
a { color: var(--accent) }
nav { line-height: 2 }
nav a { margin-right: .8em; white-space: nowrap }
nav:has([open]) .sections { display: none }
summary { cursor: pointer; color: var(--faint) }
article { margin: 1rem 0; padding: 1rem; background: var(--card); border: 1px solid var(--line); border-radius: .5rem }
.pictures { display: flex; flex-wrap: wrap; gap: .75rem; align-items: flex-start }
figure { margin: 0; flex: 0 1 auto; min-width: 0; max-width: 100% }
figure img { display: block; max-width: 100%; height: auto; border: 1px solid var(--line) }
figcaption { width: 0; min-width: 100% }
#lights .pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(17rem, 100%), 1fr)) }
figcaption, .tier { color: var(--faint); font-size: .85rem }
dl { display: flex; flex-wrap: wrap; gap: .5rem 1.75rem; margin: 1rem 0 }
dl div { max-width: 100% }
dt { color: var(--faint); font-size: .85rem }
dd { margin: 0; font-variant-numeric: tabular-nums }
.bar { display: flex; flex-wrap: wrap; gap: .5rem; align-items: center }
select, button, pre { color: inherit; background: var(--paper); border: 1px solid var(--line); border-radius: .3rem }
select, button { font: inherit; padding: .25rem .5rem; max-width: 100% }
button { cursor: pointer; min-width: 5.5em; border-color: var(--accent) }
pre { margin: .5rem 0 0; padding: .75rem; max-height: 20rem; overflow: auto; font: .8rem/1.45 ui-monospace, monospace }
footer { margin: 3rem 0 1rem; color: var(--faint); font-size: .85rem }
</style>
</head>
<body>
)HTML";

/// The options of the dialects come between these two.
inline constexpr char box_before_dialects[] = R"HTML(
<noscript><p>The snippets need JavaScript to be shown.</p></noscript>
<template id="box">
<div class="bar">
<select class="text" aria-label="Snippet"></select>
<select class="dialect" aria-label="GLSL dialect">
)HTML";

inline constexpr char box_after_dialects[] = R"HTML(</select>
<button type="button">Copy</button>
<span class="tier"></span>
</div>
<pre tabindex="0"></pre>
</template>
)HTML";

inline constexpr char script[] = R"HTML(<script>
"use strict";
document.querySelector("nav details").open = innerWidth > 1000;
let dialect = "330";
const boxes = [...document.querySelectorAll(".code")].map(box => {
  box.append(document.getElementById("box").content.cloneNode(true));
  const part = name => box.querySelector(name);
  const text = part(".text"), dialects = part(".dialect"), button = part("button");
  for (const number of box.dataset.texts.split(" "))
    text.add(new Option(document.getElementById("text-" + number).dataset.label, number));
  text.hidden = text.length < 2;
  const show = () => {
    const chosen = document.getElementById("text-" + text.value);
    for (const option of dialects.options) option.disabled = +option.dataset.order < +chosen.dataset.lowest;
    dialects.value = dialect;
    if (dialects.selectedOptions[0].disabled) dialects.value = "330";
    part(".tier").textContent = chosen.dataset.tier;
    const directive = dialects.selectedOptions[0].dataset.directive;
    part("pre").textContent = "#version " + directive + "\n" + chosen.textContent;
  };
  text.onchange = show;
  dialects.onchange = () => {  // one dialect for the whole page
    dialect = dialects.value;
    boxes.forEach(show => show());
  };
  button.onclick = async () => {
    let copied = true;
    try {
      await navigator.clipboard.writeText(part("pre").textContent);
    } catch {  // not allowed here: the old way
      const area = document.createElement("textarea");
      area.style.position = "fixed";
      area.value = part("pre").textContent;
      box.append(area);
      area.select();
      copied = document.execCommand("copy");
      area.remove();
    }
    button.textContent = copied ? "Copied" : "Not allowed";
    setTimeout(() => button.textContent = "Copy", 1500);
  };
  show();
  return show;
});
</script>
</body>
</html>
)HTML";

}  // namespace gallery
