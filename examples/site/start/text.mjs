// SPDX-License-Identifier: MIT
//
// The page Start as Markdown: three ways in, whose code is that of the repository's pages, then all pages by task.

/// Names of the page in the search.
export const known_as = [
    'start, getting started, quick start',
    'install, installation, npm install',
    'download, single header',
    'CMake, FetchContent, find_package',
];

/// Files that the site offers, and the page names.
export const downloads = { header: 'umbrage.hpp', package: 'umbrage.tgz' };

export const start_text = context => `# Start

umbrage is a header-only C++20 library for shadow maps, and the same functions as text for shaders. It has nothing to build.
Take the way that fits your program. Below are [all pages, by task](#all-pages).

## In a C++ engine

Save <a href="${downloads.header}" download>\`umbrage.hpp\`</a> as \`umbrage/umbrage.hpp\` in your include path. It needs C++20 and
[GLM](https://github.com/g-truc/glm) 0.9.9.8 or later. With a copy of the repository, CMake 3.21 does both:

${quoted(context, 'README.md', 'add_subdirectory(umbrage)', 'target_link_libraries')}

One object has the matrix of your depth pass and the uniform block of your shader:

${quoted(context, 'examples/README.md', 'const umbrage::shadow spot', 'const auto block')}

It also writes the shader's lookup. Next: [add shadows to an OpenGL program](examples/README.md#add-shadows-to-an-opengl-program),
copy [a whole program for your API](examples/recipes/README.md), or see where it goes in [your engine](examples/recipes/engines.md).

## As text in your shader

Copy functions from [Snippets](single_include/shaders), in GLSL, HLSL, WGSL or Metal. Each brings all that it needs.
HLSL and Metal also have one header of all functions. For a first shadow, paste <a href="snippets/?snippet=project_coordinate"><code>project_coordinate</code></a> and
<a href="snippets/?snippet=pcf_2x2"><code>pcf_2x2</code></a> above this:

${quoted(context, 'single_include/README.md', 'uniform sampler2D shadow_map;  // the depth texture', '}')}

Next: [paste a file](single_include/README.md#paste-a-file), or
[print the text for your kind of map](include/umbrage/shader/README.md).

## As a package for JavaScript

The package is not on npm yet. Download <a href="${downloads.package}" download>\`umbrage.tgz\`</a> and install it from there:

\`\`\`sh
npm install ./umbrage.tgz three
\`\`\`

One call puts a filter into three.js' own shadow maps:

${quoted(context, 'single_include/npm/README.md', "import * as THREE from 'three';", 'install(')}

Next: [three.js, Babylon.js and PlayCanvas](single_include/npm/README.md) in full, or
[text for your own WebGL and WebGPU shaders](single_include/README.md).

${section(context, 'README.md', 'All pages')}`;

/// Lines of a page's code, from the one that begins with `first` to the next that begins with `last`, as a block.
function quoted(context, path, first, last) {
    for (const [, language, code] of context.read(path).matchAll(/^```(\w+)[^\n]*\n(.*?)^```$/gms)) {
        const lines = code.split('\n'), from = lines.findIndex(line => line.startsWith(first));
        const length = lines.slice(from).findIndex(line => line.startsWith(last)) + 1;
        if (from >= 0 && length > 0) return ['```' + language, ...lines.slice(from, from + length), '```'].join('\n');
    }
    throw new Error(`${path} has no code from "${first}" to "${last}", which the page Start shows`);
}

/// A section of a page, with its heading.
function section(context, path, heading) {
    const found = context.read(path).split(/^(?=## )/m).find(part => part.startsWith(`## ${heading}\n`));
    if (!found) throw new Error(`${path} has no section "${heading}", which the page Start shows`);
    return found;
}
