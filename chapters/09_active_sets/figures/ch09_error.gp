# Residual against time [us]: sweeps as lines, the exact methods as one point each.
set terminal svg size 860,740 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 2,2
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'time [µs]' tc rgb '#808080'
set ylabel 'natural residual [m/s]' tc rgb '#808080'
set yrange [1e-17:3e3]; set xrange [3:1e7]
set xtics 10; set ytics 1000
set key tc rgb '#808080' samplen 1 font ',11' Left reverse at graph 1, graph 0.6
do for [p = 1:4] {
    problem = word("spd column_hit chain pyramid_hit", p)
    if (p == 1) { set title 'random, positive definite, n = 300' tc rgb '#808080' }
    if (p == 2) { set title 'column of boxes, hit, n = 300' tc rgb '#808080' }
    if (p == 3) { set title 'chain on hills, n = 999' tc rgb '#808080' }
    if (p == 4) { set title 'pyramid of boxes, hit, n = 512' tc rgb '#808080' }
    if (p == 2) { set key } else { unset key }
    plot data.'/error_'.problem.'_pgs' with linespoints lw 1.2 pt 7 ps 0.4 lc rgb '#4477AA' title 'sweeps (chapter 4)', \
         data.'/error_'.problem.'_lemke' with points pt 5 ps 1 lc rgb '#EE7733' title 'Lemke (chapter 5)', \
         data.'/error_'.problem.'_dantzig' with points pt 9 ps 1.2 lc rgb '#228833' title 'one row at a time', \
         data.'/error_'.problem.'_active_sets' with points pt 7 ps 1.2 lc rgb '#CC3311' title 'active sets'
}
unset multiplot
