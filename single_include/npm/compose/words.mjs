// How a language spells what the texts of a shadow are made of: types, declarations, functions. frame.mjs has the texts.

/** Words of languages that declare as C does. */
const as_in_c = ({ type, high = '', precise = '', before = '', library = '', column = (matrix, i) => `${matrix}[${i}]`, count }) => {
    const declared = (of, name) => `${high}${type(of)} ${name}`, local = (of, name, value) => `${declared(of, name)} = ${value};`;
    return {
        type, column, parameter: declared, constant: local, variable: local,
        precise: (of, name, value) => precise + local(of, name, value),
        flag: (name, value) => `bool ${name} = ${value};`, builtin: name => library + name,
        head: (of, name, parameters) => `${before}${high}${type(of)} ${name}(${parameters}) {`,
        choice: (condition, yes, no) => `${condition} ? ${yes} : ${no}`,
        count: count ?? ((name, value) => [`int ${name} = ${value};`]),
        loop: (i, count) => `for (int ${i} = 0; ${i} < ${count}; ++${i}) {`,
    };
};

/** A loop's count, which GLSL before 130 has constant. */
const by_version = (name, value, most) =>
    ['#if __VERSION__ >= 130', `int ${name} = ${value};`, '#else', `const int ${name} = ${most};`, '#endif'];

const short = type => type.replace('vec', 'float');
export const words_of_glsl = /*#__PURE__*/ as_in_c({ type: type => type, high: 'UMBRAGE_HIGHP ', precise: 'UMBRAGE_PRECISE ', count: by_version });
export const words_of_hlsl = /*#__PURE__*/ as_in_c({ type: type => short(type).replace('mat4', 'float4x4'), precise: 'precise ',
    column: (matrix, i) => `transpose(${matrix})[${i}]` });
export const words_of_msl = /*#__PURE__*/ as_in_c({ type: type => short(type).replace('mat4', 'metal::float4x4'), before: 'inline ', library: 'metal::' });

const of_wgsl = type => ({ float: 'f32', int: 'i32', mat4: 'mat4x4f' })[type] ?? `${type}f`;
const declared_by = word => (type, name, value) => `${word} ${name}: ${of_wgsl(type)} = ${value};`;
export const words_of_wgsl = {
    type: of_wgsl, column: (matrix, i) => `${matrix}[${i}]`,
    parameter: (type, name) => `${name}: ${of_wgsl(type)}`,
    constant: /*#__PURE__*/ declared_by('let'), variable: /*#__PURE__*/ declared_by('var'), precise: /*#__PURE__*/ declared_by('let'),
    flag: (name, value) => `let ${name}: bool = ${value};`, builtin: name => name,
    head: (type, name, parameters) => `fn ${name}(${parameters}) -> ${of_wgsl(type)} {`,
    choice: (condition, yes, no) => `select(${no}, ${yes}, ${condition})`,
    count: (name, value) => [`let ${name}: i32 = ${value};`],
    loop: (i, count) => `for (var ${i}: i32 = 0; ${i} < ${count}; ${i}++) {`,
};
