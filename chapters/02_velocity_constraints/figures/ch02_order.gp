# Errors against the step.
set terminal svg size 720,460 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set datafile separator comma
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set xlabel 'time step h [s]' tc rgb '#808080'
set ylabel 'error [m] or [rad]' tc rgb '#808080'
set key left top Left reverse tc rgb '#808080' samplen 2
set xrange [1.6e-4:2.2e-2]; set yrange [5e-5:1]
plot (1 + 20 * x)**0.25 - 1 with lines lw 1.5 lc rgb '#4477AA' title 'bead after 10 s, equation (2.34)', \
     data.'/bead.csv' using 1:4 with points pt 7 ps 0.7 lc rgb '#4477AA' title 'bead, measured [m]', \
     9.8 * x with lines lw 1.5 dt 2 lc rgb '#EE7733' title 'first order: 9.8 h', \
     data.'/pendulum.csv' using 1:(abs($4)) with points pt 5 ps 0.6 lc rgb '#EE7733' title "pendulum's angle after 1 s, measured [rad]"
