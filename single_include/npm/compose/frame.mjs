// Texts of a shadow: the same frame for all, with what a kind of light, a filter and a map state of themselves. They are
// those of C++'s frame.hpp, lookup.hpp, probe.hpp, calibration.hpp and depth_pass.hpp, in the words of a language.

const world = [['vec3', 'world'], ['vec3', 'normal']], terms = [['vec4', 'terms'], ['vec4', 'filter_terms']];
const width = { int: 1, float: 1, vec2: 2, vec3: 3, vec4: 4 };
const listed = all => all.map(name => `${name}, `).join('');

/** A text's functions for one shadow, in the order in which they call each other: name, text and what they need.
 *  @param is   { snippet, maps, along_plane, turns, hardens, layers, linear }: the filter's snippet, the kind's maps, whether the
 *              filter hardens contacts, and its form for a linear comparison sampler, if that is given */
export function frame_in(w, calls, is) {
    const { snippet, maps, along_plane, turns, hardens, layers, linear } = is, { filter } = snippet, { constant } = w;
    const vec = (n, ...parts) => `${w.type(`vec${n}`)}(${parts.join(', ')})`;
    const pixel = turns ? [['vec2', 'pixel']] : [], of_pixel = turns ? ', pixel' : '';
    const own = (name, says, type, parameters, lines, needs) => ({ name, needs, text: `\n// umbrage_${name}: ${says}\n`
        + `${w.head(type, `umbrage_${name}`, parameters.map(p => p === 'map' ? 'UMBRAGE_MAP map' : w.parameter(...p)).join(', '))}\n`
        + lines.map(line => line.startsWith('#') ? `${line}\n` : `    ${line}\n`).join('') + '}\n' });
    /** Matrices of softness, where maps differ; function of the shape, where it differs within a map. */
    const soft = hardens ? maps.softness : 0, shape = hardens ? maps.shape : undefined;
    const fields = all_fields(maps, hardens).map(({ name, matrix }) => [matrix ? 'mat4' : 'vec4', name]);
    const several = maps.grid[0] * maps.grid[1] > 1, columns = `${maps.grid[0]}.0`;

    /** The receiver's bias, from `terms` and `slope`: the slack of its plane, or a bias over a reach in texels. */
    const of_bias = along_plane ? [] : [filter.disc ? calls.acne_free_disc_bias : calls.acne_free_bias];
    const counted = numbers(w, filter.arguments), steep = ['x', 'y'].map(axis => `${w.builtin('abs')}(slope.${axis})`);
    const reach = filter.disc ? `filter_terms.${'xyzw'[counted.length]}` : 'terms.z';
    const bias = linear => [
        (linear ? constant : w.precise)('float', 'error',
            `terms.w + slope.z${linear ? ` + 0.5 * (${steep.join(' + ')})` : ''}`),
        ...along_plane
            ? [`${w.flag('is_seen', `${steep.join(' + ')} < 2.0`)}  // not edge-on by the light`,
                constant('float', 'bias', `${w.builtin('clamp')}(error, 0.0, 1.0)`)]
            : [constant('float', 'bias', `umbrage_${of_bias[0].name}(${vec(2, 'slope.x', 'slope.y')}, ${reach}, error)`)]];

    /** The statement that chooses the map of `number`, and what it calls. */
    const choice = !several ? [] : layers ? [constant('float', 'layer', 'number')]
        : [constant('vec2', 'origin', `umbrage_map_tile(number, ${vec(2, columns, `1.0 / ${columns}`)}, ${vec(2, 'terms.x', 'terms.y')})`)];
    const chooses = several && !layers ? [calls.map_tile] : [];

    /** Statements that find the softness of a place in the map `number`, and its shape. */
    const softness = Array.from({ length: soft }, (_, i) => i === 0
        ? (soft > 1 ? w.variable : constant)('vec2', 'softness', 'umbrage_map_softness(softness_0, number)')
        : `softness = ${w.choice(`number >= ${8 * i}.0`, `umbrage_map_softness(softness_${i}, number - ${8 * i}.0)`, 'softness')};`);
    const own_softness = soft ? vec(4, 'softness', 'filter_terms.z', 'filter_terms.w') : 'filter_terms';
    if (shape) softness.push(constant('vec3', 'shape', `umbrage_${shape.calls.name}(${shape.argument}, number, ${vec(2, 'at.x', 'at.y')})`));
    if (soft || shape) softness.push(constant('vec4', 'own_terms', shape ? `umbrage_shaped_softness(${own_softness}, shape)` : own_softness));
    const softens = [...soft ? [calls.map_softness] : [], ...shape ? [shape.calls, calls.shaped_softness] : []];
    const sheared = shape ? [['float', 'shear']] : [], of_shear = shape ? ', shape.z' : '', no_shear = shape ? ', 0.0' : '';
    const rotation = shape ? 'umbrage_sheared_rotation(umbrage_disc_rotation(pixel), shear)' : 'umbrage_disc_rotation(pixel)';

    /** The frame: a lookup at each place of a receiver, and their blend. */
    const blended = (type, lit, look, blend, statements) => {
        const look_up = (name, of_map) => [
            constant('mat4', 'place', `umbrage_${maps.placing.name}(${listed(maps.fields.map(f => f.name))}terms, world, normal${of_map})`),
            constant('vec4', 'at', w.column('place', 0)), constant('vec4', 'slope', w.column('place', 1)),
            constant('float', 'number', 'at.w'), ...statements, constant(type, name, look)];
        if (!maps.choosing) return [...look_up('sum', ''), 'return sum;'];
        return [constant('vec2', 'choice', `umbrage_${maps.choosing.calls.name}(${maps.choosing.arguments}world)`),
            ...w.count('count', w.choice('choice.y > 0.0', '2', '1'), '2'), w.variable(type, 'sum', lit),
            w.variable('float', 'chosen', 'choice.x'), w.variable('float', 'weight', '1.0'),
            w.loop('i', 'count'), '    if (weight > 0.0) {', ...look_up('next', ', chosen').map(line => `        ${line}`),
            `        sum = ${blend};`, '    }', '    chosen = choice.x + 1.0;', '    weight = choice.y;', '}', 'return sum;'];
    };
    const places = maps.choosing ? [maps.choosing.calls, maps.placing, calls.blend_cascades] : [maps.placing];
    const at = vec(3, 'at.x', 'at.y', 'at.z'), slope = vec(3, 'slope.x', 'slope.y', 'slope.w');

    const called = linear ?? snippet, weights = linear ? filter.linear.weights : '';
    const look = () => own('look', 'visibility of a receiver in one map', 'float', ['map', ...terms, ['vec3', 'at'], ['vec3', 'slope'], ...pixel, ...sheared], [
        ...bias(linear),
        w.flag('is_compared', w.choice('umbrage_beyond_far_plane(at.z)', 'false', along_plane ? 'is_seen' : 'true')),
        `${constant('vec2', 'coord', vec(2, w.choice('is_compared', 'at.x', '65536.0'), 'at.y'))}  // outside all maps, where all is lit`,
        constant('float', 'receiver', w.choice('umbrage_cleared_depth() > 0.5', 'at.z - bias', 'at.z + bias')),
        ...along_plane ? [constant('vec2', 'receiver_slope', vec(2, 'slope.x', 'slope.y')),
            constant('vec3', 'receiver_at', vec(3, 'at.x', 'at.y', 'receiver'))] : [],
        `return umbrage_${called.name}(map, ${vec(2, 'terms.x', 'terms.y')}, coord, receiver${weights}${counted.text}`
            + `${turns ? `, ${rotation}` : ''});`,
    ], [calls.beyond_far_plane, calls.cleared_depth, called, ...of_bias, ...turns ? [calls.disc_rotation] : [],
        ...shape ? [calls.sheared_rotation] : []]);
    const shadow = () => own('shadow', 'visibility of a point of the world, 1.0 is lit', 'float', ['map', ...fields, ...terms, ...world, ...pixel],
        blended('float', '1.0', `umbrage_look(map, terms, ${soft || shape ? 'own_terms' : 'filter_terms'}, ${at}, ${slope}${of_pixel}${of_shear})`,
            'umbrage_blend_cascades(sum, next, weight)', [...choice, ...softness]),
        [...places, ...chooses, ...softens]);

    /** Those behind umbrage_probe_<name> and umbrage_calibrate_<name>. */
    const debug = ({ probe_color, probe_inputs, read_map }, parts) => [
        own('place_color', "a receiver's debug color in one map", 'vec3', [...terms, ['vec4', 'at'], ['vec3', 'slope']],
            [...bias(), ...along_plane ? [constant('float', 'taken', w.choice('is_seen', 'bias', '1.0'))] : [],
                `return umbrage_probe_color(${at}, ${vec(2, 'terms.x', 'terms.y')}, ${along_plane ? 'taken' : 'bias'}, at.w);`], [probe_color, ...of_bias]),
        own('blended_color', 'debug color of a point of the world', 'vec3', [...fields, ...terms, ...world],
            blended('vec3', vec(3, '1.0', '1.0', '1.0'), `umbrage_place_color(terms, filter_terms, at, ${slope})`,
                vec(3, ...['x', 'y', 'z'].map(c => `umbrage_blend_cascades(sum.${c}, next.${c}, weight)`)), []), places),
        own('point_color', 'debug color of a point of the world, or what is wrong with it', 'vec3', [...fields, ...terms, ...world],
            [constant('vec3', 'color', `umbrage_blended_color(${listed(fields.map(([, name]) => name))}terms, filter_terms, world, normal)`),
                'return umbrage_probe_inputs(color, world, normal);'], [calls.cleared_depth, probe_inputs]),
        own('lit_at_distance', '1.0 where a receiver at a distance from the near plane, 0.0 to 1.0, is lit', 'float',
            ['map', ...terms, ['vec2', 'coord'], ['float', 'distance']],
            [constant('float', 'depth', w.choice('umbrage_cleared_depth() > 0.5', 'distance', '1.0 - distance')),
                constant('vec3', 'at', vec(3, 'coord.x', 'coord.y', 'depth')),
                `return ${w.choice(`umbrage_look(map, terms, filter_terms, at, ${vec(3, '0.0', '0.0', '0.0')}`
                    + `${turns ? `, ${vec(2, '0.5', '0.5')}` : ''}${no_shear}) > 0.5`, '1.0', '0.0')};`], [calls.cleared_depth]),
        { name: 'read_map', text: read_map, needs: [] },
        own('reading', "what a map of known depths is read as, a map_reading's number; 0.0 is right", 'float',
            ['map', ...terms, ['float', 'number']],
            [...choice, `return umbrage_read_map(map, terms, filter_terms, number, 1.0 / ${parts}.0);`], []),
    ];
    return { look, shadow, debug };
}

/** A kind's uniforms, without the terms. */
export const all_fields = (maps, hardens) => [...maps.fields, ...!hardens ? []
    : [...Array.from({ length: maps.softness }, (_, i) => `softness_${i}`), ...maps.warps ? ['warps'] : []]
        .map(name => ({ name, matrix: true }))];

/** A filter's numbers as arguments, from the components of filter_terms, and how many these are. */
function numbers(w, all) {
    let length = 0, text = '';
    for (const { name, type } of all.filter(argument => argument.name !== 'rotation')) {
        const parts = Array.from({ length: width[type] }, () => `filter_terms.${'xyzw'[length++]}`).join(', ');
        text += `, ${type === 'float' ? parts : `${w.type(type)}(${parts})`}`;
    }
    return { length, text };
}

/** What a depth pass calls for its vertices. */
export function vertex_in(w, calls, { vertex, pancakes }, at_near) {
    const own = vertex?.arguments ?? [['vec4', 'anchor']], passed = own.map(([, name]) => `, ${name}`).join('');
    const placed = `umbrage_${(vertex?.calls ?? calls.anchored_vertex).name}(to_clip, world${passed})`;
    const parameters = [['mat4', 'to_clip'], ['vec3', 'world'], ...own].map(p => w.parameter(...p)).join(', ');
    return { name: 'vertex', needs: [...vertex ? [vertex.calls] : [calls.anchored_vertex, calls.pancake], calls.cleared_depth],
        text: '\n// umbrage_vertex: clip space position of a vertex of the depth pass\n'
            + `${w.head('vec4', 'umbrage_vertex', parameters)}\n    return ${pancakes ? `umbrage_pancake(${placed}, ${at_near})` : placed};\n}\n` };
}
