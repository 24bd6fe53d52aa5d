// SPDX-License-Identifier: MIT
//
// The frame of every page: head, navigation, main, footer. Links are relative, so that the site works under any path.
import { escape } from './context.mjs';

const sections = [
    ['start.html', 'Start'],
    ['proof/', 'Proof'],
    ['check/', 'Check a shader'],
    ['snippets/', 'Snippets'],
    ['reference/', 'Reference'],
    ['museum.html', 'Museum'],
    ['bias.html', 'Bias'],
];

/// The way from the page at `path` to the root of the site: './', '../', '../../' ...
export const way_up = path => '../'.repeat(path.split('/').length - 1) || './';

/// Where the site is published, from the environment: "https://.../"; unset, pages name no address.
const published = process.env.SITE_URL && process.env.SITE_URL.replace(/\/*$/, '/');

/// The repository, where a workflow of GitHub builds the site; else pages name none.
const { GITHUB_SERVER_URL: server, GITHUB_REPOSITORY: repository } = process.env;
const to_repository = server && repository ? ` · <a href="${escape(`${server}/${repository}`)}">Repository</a>` : '';

/// @param path         of the file in the site, such as "reference/filter/index.html"
/// @param title        of the page, without the project's name
/// @param description  one sentence, for search engines
/// @param body         HTML of the main part
/// @param scripts      modules to load, relative to the root of the site
/// @param styles       style sheets of this page alone, in the same way
/// @return             the HTML of the whole page
export function page({ path, title, description, body, scripts = [], styles = [] }) {
    const up = way_up(path);
    const links = sections.map(([to, name]) => {
        const here = path.startsWith(to) ? ' aria-current="page"' : '';
        return `<li><a href="${up}${to}"${here}>${name}</a></li>`;
    });
    return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="description" content="${escape(description)}">
<meta name="color-scheme" content="light dark">
<title>${escape(title)} · umbrage</title>
${published ? `<link rel="canonical" href="${escape(published + path.replace(/index\.html$/, ''))}">` : ''}
<link rel="icon" href="${up}icon.svg">
${['style.css', ...styles].map(style => `<link rel="stylesheet" href="${up}${style}">`).join('\n')}
${['search.js', ...scripts].map(script => `<script type="module" src="${up}${script}"></script>`).join('\n')}
</head>
<body data-root="${up}">
<a class="skip" href="#main">Skip to the content</a>
<header class="top">
<a class="mark" href="${up}">umbrage</a>
<nav aria-label="Main"><ul>${links.join('')}</ul></nav>
<form class="find" role="search" action="${up}index-by-name.html">
<input type="search" name="q" aria-label="Search the site" placeholder="Search: CSM, acne, pcss ..." autocomplete="off" spellcheck="false">
<div class="found"><output></output><ul></ul></div>
</form>
</header>
<main id="main">
${body}
</main>
<footer class="foot">
<p>umbrage, a C++20 library of shadow mapping functions with shader versions. <a href="${up}source/LICENSE.html">MIT license</a>.</p>
<p><a href="${up}readme.html">Readme</a> · <a href="${up}troubleshooting.html">Troubleshooting</a> · <a href="${up}index-by-name.html">Find by name</a> ·
<a href="${up}contributing.html">Contributing</a> · <a href="${up}changelog.html">Changes</a>${to_repository}</p>
</footer>
</body>
</html>
`;
}
