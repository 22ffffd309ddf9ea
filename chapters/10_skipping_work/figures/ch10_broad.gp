# Time to find all contacts against the number of discs, four scenes and four ways.
set terminal svg size 820,720 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 2,2
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'discs K' tc rgb '#808080'
set ylabel 'time [µs]' tc rgb '#808080'
set xrange [20:2e5]; set yrange [0.1:3e5]
set key tc rgb '#808080' samplen 1 font ',12' Left reverse top left
do for [p = 1:4] {
    scene = word("sparse dense sizes line", p)
    if (p == 1) { set title 'sparse: a tenth of the area' tc rgb '#808080' }
    if (p == 2) { set title 'dense: seven tenths' tc rgb '#808080' }
    if (p == 3) { set title 'radii from 1 to 100' tc rgb '#808080' }
    if (p == 4) { set title 'all in one line' tc rgb '#808080' }
    if (p == 1) { set key } else { unset key }
    plot data.'/broad_'.scene.'_all' with linespoints pt 7 ps 0.5 lc rgb '#808080' title 'all pairs', \
         data.'/broad_'.scene.'_sweep' with linespoints pt 5 ps 0.5 lc rgb '#EE7733' title 'sort and sweep', \
         data.'/broad_'.scene.'_grid' with linespoints pt 9 ps 0.6 lc rgb '#228833' title 'grid, each step', \
         data.'/broad_'.scene.'_kept' with linespoints pt 7 ps 0.6 lc rgb '#4477AA' title 'grid, pairs kept'
}
unset multiplot
