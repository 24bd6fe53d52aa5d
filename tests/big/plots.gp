# SPDX-License-Identifier: MIT
#
# Pictures of what big measured, in the style of ../bench/style.gp: CPU time per element over that of 2^20 elements.
# A function whose cost is linear has a level curve. Grey: 20 percent.
set key noenhanced # names have underscores
set logscale x 2
set format x "2^{%L}"
set xrange [2**19.8:2**30.2]
set object rectangle from graph 0, first 0.8 to graph 1, first 1.2 behind fillcolor rgb "#e8e8e8" fillstyle solid noborder
set xlabel "texels" offset 0, 0.7
set ylabel "cost per texel, 2^{20} texels: 1"

name = "big_maps"
set title "Maps of 1024 x 1024 to 32768 x 32768 texels, one thread"
eval start
set yrange [0.5:2]
eval draw

name = "big_passes"
set title "Passes over maps, one thread"
eval start
set yrange [0.5:2]
eval draw

name = "big_tables"
set title "Tables and bounds of maps, one thread"
eval start
set yrange [0.5:2]
eval draw

set xlabel "receivers, and texels of the map" offset 0, 0.7
set ylabel "cost per receiver, 2^{20} receivers: 1"
name = "big_receivers"
set title "Visibility of receivers in bands of 16 rows, map of floats, one thread"
eval start
set yrange [0.5:2]
eval draw

name = "big_receivers_2"
set title "Visibility of receivers, other maps, one thread"
eval start
set yrange [0.5:2]
eval draw

set xrange [2**19.8:2**26.8]
set xlabel "triangles" offset 0, 0.7
set ylabel "cost per triangle, 2^{20} triangles: 1"
name = "big_triangles"
set title "Triangles of two texels, maps of 1024 x 1024 to 8192 x 8192 texels, one thread"
eval start
set yrange [0.5:2]
eval draw
