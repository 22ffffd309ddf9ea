# When a bouncing ball lies still: error against the time step for three thresholds.
set terminal svg size 720,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'time step h [s]' tc rgb '#808080'
set ylabel 'error of the time of rest [s]' tc rgb '#808080'
set xrange [2e-4:0.05]; set yrange [1e-3:100]
rest = sqrt(2 / 9.81) * 9
bounces(h) = log(sqrt(2 * 9.81) / (9.81 * h)) / log(1 / 0.8)
set key top left tc rgb '#808080' samplen 1
plot data.'/rest_none' using 1:(abs($3 - rest)) with points pt 7 ps 0.7 lc rgb '#EE7733' title 'no threshold', \
     data.'/rest_fixed' using 1:(abs($3 - rest)) with points pt 7 ps 0.7 lc rgb '#CC3311' title '1 m/s', \
     data.'/rest_scaled' using 1:(abs($3 - rest)) with points pt 7 ps 0.7 lc rgb '#4477AA' title '2 g h', \
     x * bounces(x) with lines dt 2 lc rgb '#808080' title 'one step for each bounce'
