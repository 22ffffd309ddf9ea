# The energy of the tossed book over that of its start, by four ways.
set terminal svg size 720,480 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'energy over that of the start' tc rgb '#808080'
set xrange [0:8]
set yrange [0.6:2.4]
set key outside top center horizontal maxcols 4 tc rgb '#808080' samplen 1.2
plot data.'/energy_explicit' using 1:2 with lines lw 2 lc rgb '#4477AA' title 'explicit', \
     data.'/energy_implicit' using 1:2 with lines lw 2 lc rgb '#EE7733' title 'implicit', \
     data.'/energy_momentum' using 1:2 with lines lw 2 lc rgb '#AA3377' title 'momentum', \
     data.'/energy_middle' using 1:2 with lines lw 2 lc rgb '#228833' title 'middle'
