# SPDX-License-Identifier: MIT
"""moderngl, headless: texts, blocks and matrices come from C++ through ctypes (shadows_for_python.cpp).

    python3 with_moderngl.py LIBRARY.so PICTURE.png

A spot light's map is a depth texture. A sun's cascades lie in an atlas, as this moderngl has no arrays of depths."""
import ctypes
import struct
import sys
import zlib

import moderngl
import numpy as np

umbrage = ctypes.CDLL(sys.argv[1])
umbrage.shadow_text.restype = umbrage.shading_text.restype = ctypes.c_char_p


def values(function, *sizes):
    """Arrays of floats that a function of C++ writes."""
    arrays = [np.zeros(size, 'f4') for size in sizes]
    function(*(ctypes.c_void_p(array.ctypes.data) for array in arrays))
    return arrays


mesh, = values(umbrage.mesh_values, umbrage.mesh_values(None))
camera, = values(umbrage.camera_values, 16)
spot_block, spot_to_clip = values(umbrage.spot_values, umbrage.spot_values(None, None), (1, 16))
sun_block, sun_to_clip = values(umbrage.sun_values, umbrage.sun_values(None, None), (3, 16))
shading = umbrage.shading_text().decode()

context = moderngl.create_standalone_context(require=330, backend='egl')
context.enable(moderngl.DEPTH_TEST)
vertices = context.buffer(mesh.tobytes())
vertex_shader = '''#version 330
in vec3 position, vertex_normal;
in vec2 vertex_uv;
uniform mat4 to_clip;
out vec3 world, normal;
out vec2 uv;
void main() {
    gl_Position = to_clip * vec4(position, 1.0);
    world = position, normal = vertex_normal, uv = vertex_uv;
}'''
depth_pass = context.program(vertex_shader=vertex_shader, fragment_shader='#version 330\nin vec2 uv;\n' + shading + '''
void main() { if (is_hole(uv)) discard; }''')
view = context.program(vertex_shader=vertex_shader, fragment_shader=umbrage.shadow_text().decode() + shading + '''
in vec3 world, normal;
in vec2 uv;
out vec4 color;
void main() {
    if (is_hole(uv)) discard;
    color = vec4(shade(world, normal, umbrage_spot(world, normal), umbrage_sun(world, normal)), 1.0);
}''')
draw_depths = context.vertex_array(depth_pass, [(vertices, '3f 12x 2f', 'position', 'vertex_uv')])
draw_view = context.vertex_array(view, [(vertices, '3f 3f 2f', 'position', 'vertex_normal', 'vertex_uv')])


def draw_maps(matrices, columns, rows):
    """Maps of 1024 texels in one depth texture, row by row."""
    texture = context.depth_texture((1024 * columns, 1024 * rows))
    texture.compare_func = ''  # the text compares
    texture.filter = moderngl.NEAREST, moderngl.NEAREST
    target = context.framebuffer(depth_attachment=texture)
    target.use()
    target.clear()
    for i, to_clip in enumerate(matrices):
        target.viewport = i % columns * 1024, i // columns * 1024, 1024, 1024
        depth_pass['to_clip'].write(to_clip.tobytes())
        draw_depths.render()
    return texture


maps = {'spot': (draw_maps(spot_to_clip, 1, 1), spot_block), 'sun': (draw_maps(sun_to_clip, 2, 2), sun_block)}
for unit, (name, (texture, block)) in enumerate(maps.items()):
    texture.use(unit)
    view[f'umbrage_{name}_map'] = unit
    view[f'umbrage_{name}_block'].binding = unit
    context.buffer(block.tobytes()).bind_to_uniform_block(unit)

target = context.framebuffer(context.renderbuffer((480, 320)), context.depth_renderbuffer((480, 320)))
target.use()
target.clear(0.5, 0.6, 0.7, 1.0)
view['to_clip'].write(camera.tobytes())
draw_view.render()


def chunk(kind, data):
    return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))


rows = np.frombuffer(target.read(), 'u1').reshape(320, 480 * 3)[::-1]  # OpenGL's first row is the lowest
with open(sys.argv[2], 'wb') as file:
    file.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', 480, 320, 8, 2, 0, 0, 0))
               + chunk(b'IDAT', zlib.compress(b''.join(b'\0' + row.tobytes() for row in rows))) + chunk(b'IEND', b''))
