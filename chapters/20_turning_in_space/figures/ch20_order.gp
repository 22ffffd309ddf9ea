# The error of a free spin after 5 s against the step.
set terminal svg size 720,480 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format y '10^{%L}'
set xlabel 'step h [s]' tc rgb '#808080'
set ylabel 'error of ω after 5 s [rad/s]' tc rgb '#808080'
set xrange [1e-3:0.15]
set yrange [5e-7:1]
set key outside top center horizontal maxcols 3 tc rgb '#808080' samplen 1.2
plot data.'/order_explicit' using 1:2 with points pt 7 ps 0.8 lc rgb '#4477AA' title 'explicit', \
     data.'/order_implicit' using 1:2 with points pt 4 ps 1 lc rgb '#EE7733' title 'implicit', \
     data.'/order_momentum' using 1:2 with points pt 9 ps 0.9 lc rgb '#AA3377' title 'momentum', \
     data.'/order_middle' using 1:2 with points pt 13 ps 1.1 lc rgb '#228833' title 'middle', \
     1.2 * x with lines dt 2 lc rgb '#808080' title 'order 1', \
     0.62 * x * x with lines dt 3 lc rgb '#808080' title 'order 2'
