# Guesses of active sets, pivots of Dantzig's and Lemke's methods, against the number of rows.
set terminal svg size 900,400 dynamic enhanced font 'DejaVu Sans,13' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 1,2
set logscale xy
set xlabel 'rows n' tc rgb '#808080'
set ylabel 'linear solves, or pivots' tc rgb '#808080'
set xrange [3:700]; set yrange [0.8:3000]
set key tc rgb '#808080' samplen 1 font ',12' Left reverse top left
do for [p = 1:2] {
    name = word("column pyramid", p)
    if (p == 1) { set title 'column of boxes, hit' tc rgb '#808080' }
    if (p == 2) { set title 'pyramid of boxes, hit (A is singular)' tc rgb '#808080'; unset key }
    plot data.'/count_'.name.'_lemke' using 1:2 with linespoints pt 5 ps 0.6 lc rgb '#EE7733' title 'pivots, Lemke', \
         data.'/count_'.name.'_dantzig' using 1:2 with linespoints pt 7 ps 0.6 lc rgb '#228833' title 'pivots, one row at a time', \
         data.'/count_'.name.'_active_sets' using 1:2 with linespoints pt 7 ps 0.7 lc rgb '#4477AA' title 'guesses, all wrong rows at once', \
         data.'/count_'.name.'_active_sets' using 1:3 with points pt 6 ps 1.1 lc rgb '#4477AA' title 'factorisations of them'
}
unset multiplot
