# A disc in a steep groove creeps sideways where the rows are visited in the same order in each step.
set terminal svg size 720,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator comma
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'sideways [mm]' tc rgb '#808080'
set xrange [0:10]
set key left bottom tc rgb '#808080' samplen 1
h = 1. / 60; a = pi / 3; c = cos(2 * a); n = 3
v = 9.81 * h * sin(a) * c**(2 * n - 1) / (1 - c**(2 * n)) * cos(a)
plot data.'/creep_given' using 2:(1000*$3) every 20::1 with points pt 7 ps 0.6 lc rgb '#4477AA' title 'given', \
     1000 * v * x with lines dt 2 lc rgb '#808080' title '(6.27)', \
     data.'/creep_coloured' using 2:(1000*$3) every 20::10 with points pt 6 ps 0.7 lc rgb '#228833' title 'coloured', \
     data.'/creep_alternating' using 2:(1000*$3) every 20::1 with points pt 5 ps 0.5 lc rgb '#AA3377' title 'alternating', \
     data.'/creep_shuffled' using 2:(1000*$3) with lines lc rgb '#EE7733' title 'shuffled'
