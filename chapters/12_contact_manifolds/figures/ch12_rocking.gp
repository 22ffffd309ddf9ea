# Angular velocity of a rocking block, and its angle.
set terminal svg size 720,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator ','
set xlabel 'time [s]' tc rgb '#808080'
set ytics 0.5
set key outside top center horizontal tc rgb '#808080' samplen 1.5
set arrow from graph 0, first 0 to graph 1, first 0 nohead lc rgb '#808080' dt 3
plot data.'/rocking' using 2:($4) with lines lw 1.6 lc rgb '#4477AA' title 'angular velocity [rad/s]', \
     data.'/rocking' using 2:($3 / 10) with lines dt 2 lc rgb '#EE7733' title 'angle [10°]'
