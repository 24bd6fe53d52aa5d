# SPDX-License-Identifier: MIT
#
# Style of the plots, and the words `start` and `draw` for a plot's curves. A file of plots follows it:
#
#     gnuplot -e "data='bench-series.tsv'; folder='plots'" style.gp plots.gp
#
# A colour for each work, of Okabe and Ito's, told apart with any colour vision, and black for memcpy; full lines and discs
# for umbrage, broken lines and other shapes for the rest.
set datafile separator "\t"
set terminal svg size 840,560 dynamic background "white" font "sans-serif,14"
set border 3 linecolor rgb "#606060"
set tics nomirror scale 0.5 textcolor rgb "#000000"
set grid linecolor rgb "#d0d0d0"
set key outside bottom center horizontal Left reverse samplen 4 maxcols 2 height 1
set offsets graph 0.03, graph 0.03, 0, 0
array palette[5] = [0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00]
kind(who) = who eq "umbrage" ? 1 : who eq "memcpy" ? 3 : 2
array dash[3] = [1, 2, 4]
array shape[3] = [7, 4, 8]

# Which curves a plot has and between what they lie, from lines of the form `plot, work, by, x, y`; the first curve here is none.
array works[20]
array bys[20]
array colour[20]
known(work, by) = work eq works[curves] && by eq bys[curves]
see(work, by, y) = (low = y < low ? y : low, high = y > high ? y : high, known(work, by) ? 0 : (curves = curves + 1, \
    works[curves] = work, bys[curves] = by, colour[curves] = colour[curves - 1] + (work ne works[curves - 1])))
start = 'set yrange [*:*]; curves = 1; works[1] = ""; bys[1] = ""; colour[1] = 0; low = 1e30; high = 0; \
    stats data using (strcol(1) eq name ? see(strcol(2), strcol(3), $5) : NaN) nooutput; \
    set output folder."/".name.".svg"; set yrange [low / 1.3 : high * 1.3]'
curve(i, a, b, c) = name eq a && works[i] eq b && bys[i] eq c
draw = 'plot for [i = 2:curves] data using (curve(i, strcol(1), strcol(2), strcol(3)) ? $4 : NaN):5 with linespoints \
    linewidth 2 pointsize 0.8 linecolor rgb (bys[i] eq "memcpy" ? 0 : palette[colour[i]]) \
    dashtype dash[kind(bys[i])] pointtype shape[kind(bys[i])] title works[i].", ".bys[i]'

set logscale y
do for [decade = -3:4] { do for [i in "1 2 5"] { set ytics add (sprintf("%g", i * 10.0**decade) i * 10.0**decade) } }
