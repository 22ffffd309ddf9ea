# Sweeps of each step of the ten discs.
set terminal svg size 760,400 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator comma
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'sweeps' tc rgb '#808080'
set logscale y
set xrange [0:5]; set yrange [0.8:600]
set key above tc rgb '#808080' samplen 1
plot data.'/discs_cold' using 2:3 every ::1 with points pt 7 ps 0.25 lc rgb '#CC3311' title 'cold', \
     data.'/discs_yesterday' using 2:3 every ::1 with points pt 7 ps 0.25 lc rgb '#4477AA' title 'from yesterday', \
     data.'/discs_best_multiple' using 2:3 every ::1 with points pt 7 ps 0.25 lc rgb '#228833' title 'from its best multiple'
