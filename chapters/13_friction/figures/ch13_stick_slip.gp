# The stretch of a spring whose block sticks and slips: closed form and steps, and with one coefficient.
set terminal svg size 720,400 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator ','
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'stretch of the spring [m]' tc rgb '#808080'
set key outside top center horizontal tc rgb '#808080' samplen 1.5
set xrange [0:3]
set yrange [0:0.21]
plot data.'/two' using 2:4 every ::1 with lines lw 1.6 lc rgb '#4477AA' title 'closed form', \
     data.'/two' using 2:3 every 40::1 with points pt 7 ps 0.5 lc rgb '#EE7733' title 'steps of 1/960 s', \
     data.'/one' using 2:3 every ::1 with lines dt 2 lw 1.4 lc rgb '#808080' title 'one coefficient'
