// Errors for bad input, as the C++ library words them: function, argument, condition, and the value.

/** A value in a message; an object by its class, or by its name where it has none. */
export function shown(got) {
    if (Array.isArray(got)) return `[${Array.from(got, shown).join(', ')}]`;
    if (Object(got) !== got) return got === '' ? '""' : String(got);
    const of_class = got.constructor?.name;
    return of_class && of_class !== 'Object' ? of_class : String(got.what?.name ?? got.name ?? 'an object');
}

/** must(holds, condition, got) of a function of this package. */
export const must_in = where => (holds, condition, got) => {
    if (!holds) throw new Error(`umbrage: ${where}: ${condition}; got ${shown(got)}`);
};

/** What was given in place of an encoding. */
export const given_as_encoding = got => got === undefined ? 'undefined. Is it of a name that no encoding has?' : got;

const words = { hand: ['left', 'right'], range: ['zero_to_one', 'minus_one_to_one'], direction: ['forward', 'reversed'], origin: ['bottom', 'top'] };

/** Refuses a clip space that lacks one of the keys, or has another word there. */
export function must_be_clip_space(must, argument, clip, keys = Object.keys(words)) {
    must(typeof clip === 'object' && clip !== null, `${argument} must be a clip space of umbrage/values, such as webgpu_clip_space`, clip);
    for (const key of keys) must(words[key].includes(clip[key]), `${argument}.${key} must be ${words[key].join(' or ')}`, clip[key]);
}
