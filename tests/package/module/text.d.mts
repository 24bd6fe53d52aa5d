/** The snippets, bound or not, and all they need, each once: text to paste into any shader. */
export function text(items: readonly (Snippet | Bound)[]): string;
