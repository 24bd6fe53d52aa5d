// SPDX-License-Identifier: MIT
declare module 'prismjs/components/prism-core' {
    const Prism: {
        highlight(text: string, grammar: object, language: string): string;
        languages: Record<string, object | undefined>;
    };
    export default Prism;
}
declare module 'prismjs/components/*';
