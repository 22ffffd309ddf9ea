# Residual against time [us]: sweeps as lines, the walk as one point.
set terminal svg size 820,720 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 2,2
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'time [µs]' tc rgb '#808080'
set ylabel 'natural residual [m/s]' tc rgb '#808080'
set yrange [1e-16:3e3]; set xrange [1:2e5]
set key tc rgb '#808080' samplen 1 font ',12' Left reverse top right
do for [p = 1:4] {
    problem = word("spd column heavy_top friction", p)
    if (p == 1) { set title 'random, positive definite, n = 100' tc rgb '#808080' }
    if (p == 2) { set title 'column of boxes, n = 100' tc rgb '#808080' }
    if (p == 3) { set title '1000 kg on 99 discs of 1 kg' tc rgb '#808080' }
    if (p == 4) { set title 'boxes with friction, n = 80' tc rgb '#808080' }
    if (p == 3) { set key at graph 0.98, graph 0.55 } else { unset key }
    plot data.'/'.problem.'_pgs' with linespoints lw 1.2 pt 7 ps 0.4 lc rgb '#4477AA' title 'sweeps (chapter 4)', \
         data.'/'.problem.'_lemke' with points pt 5 ps 1 lc rgb '#CC3311' title 'Lemke'
}
unset multiplot
