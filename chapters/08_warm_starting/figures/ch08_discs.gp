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
unset key
set label 1 'cold' at 1,260 left tc rgb '#CC3311'
set label 2 'from the previous answer' at 0.5,8.5 left tc rgb '#4477AA'
set label 3 'from its best multiple' at 1.75,1.5 left tc rgb '#228833'
plot data.'/discs_cold' using 2:3 every ::1 with points pt 7 ps 0.25 lc rgb '#CC3311', \
     data.'/discs_previous' using 2:3 every ::1 with points pt 7 ps 0.25 lc rgb '#4477AA', \
     data.'/discs_best_multiple' using 2:3 every ::1 with points pt 7 ps 0.25 lc rgb '#228833'
