# SPDX-License-Identifier: MIT
#
# Pictures of what bench_series measured, in the style of style.gp.
set logscale x 2
set xrange [200:10500]
set xlabel "side of the square map, texels" offset 0, 0.7
set ylabel "nanoseconds per texel"

name = "map_size_encode"
set title "Depth to 11 bits in two bytes and back, one thread"
eval start
eval draw

name = "map_size_summed_area"
set title "Summed-area table of 32-bit integers, one thread"
eval start
eval draw

name = "map_size_visibility"
set title "2 x 2 PCF of 1920 x 1080 coherent receivers, one thread"
set ylabel "nanoseconds per receiver"
eval start
eval draw

unset logscale x
set xrange [*:*]
name = "kernel_size"
set title "Box filter of 1920 x 1080 coherent receivers, map of 2048 x 2048 floats, one thread"
set xlabel "side of the kernel, texels"
set xtics 1, 2
eval start
eval draw

set xtics autofreq format "10^{%L}"
set logscale x
set xrange [700:3e6]
name = "triangles"
set title "Hills of ever smaller triangles, one thread"
set xlabel "triangles"
set ylabel "milliseconds"
eval start
eval draw

unset logscale
name = "threads"
set title "Threads: 2048 x 2048 texels, 1920 x 1080 receivers, a million triangles"
set xlabel "threads"
set ylabel "time of one thread / time"
set autoscale x noextend
set ytics autofreq
set key inside left top vertical maxcols 1
eval start
set yrange [*:*]
stats data using (strcol(1) eq name ? $4 : NaN) nooutput
set xtics 0, ceil(STATS_max / 16) format "%g"
set yrange [0:*]
eval draw.', x linewidth 2 linecolor rgb "#808080" dashtype 3 title "ideal"'
