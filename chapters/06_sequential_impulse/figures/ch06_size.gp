# Ten sweeps from rows to impulses, with the matrix and without: time and memory.
set terminal svg size 820,400 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 1,2
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'rows' tc rgb '#808080'
set xrange [60:2e5]
unset key
set ylabel 'time for ten sweeps [µs]' tc rgb '#808080'
set yrange [1:1e6]
do for [what = 1:2] {
    if (what == 2) { set ylabel 'memory [kB]' tc rgb '#808080'; set key bottom right tc rgb '#808080' samplen 1 font ',11'; set yrange [1:1e6] }
    f = what == 1 ? 1. : 1e-3
    plot data.'/size_triangle' using 1:(f * column(2 * what)) with linespoints pt 7 ps 0.5 lc rgb '#4477AA' title 'triangle, impulses', \
         data.'/size_triangle' using 1:(f * column(2 * what + 1)) with linespoints pt 6 ps 0.5 dt 2 lc rgb '#4477AA' title 'triangle, matrix', \
         data.'/size_column' using 1:(f * column(2 * what)) with linespoints pt 7 ps 0.5 lc rgb '#228833' title 'column, impulses', \
         data.'/size_column' using 1:(f * column(2 * what + 1)) with linespoints pt 6 ps 0.5 dt 2 lc rgb '#228833' title 'column, matrix', \
         data.'/size_hub' using 1:(f * column(2 * what)) with linespoints pt 7 ps 0.5 lc rgb '#CC3311' title 'hub, impulses', \
         data.'/size_hub' using 1:(f * column(2 * what + 1)) with linespoints pt 6 ps 0.5 dt 2 lc rgb '#CC3311' title 'hub, matrix'
}
unset multiplot
