# The error of a rod on a pin, and of the pin, against the step.
set terminal svg size 720,480 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format y '10^{%L}'
set xlabel 'step or sub-step h [s]' tc rgb '#808080'
set ylabel 'after 1 s: angle [rad], pin [m]' tc rgb '#808080'
set yrange [1e-7:1]
set xrange [4e-4:0.05]
set key outside top center horizontal maxcols 3 tc rgb '#808080' samplen 1.2
plot data.'/order_exact' using 1:2 with points pt 7 ps 0.8 lc rgb '#4477AA' title 'angle, exact repair', \
     data.'/order_baumgarte' using 1:2 with points pt 5 ps 0.7 lc rgb '#EE7733' title 'angle, Baumgarte', \
     data.'/order_rattle' using 1:2 with points pt 13 ps 1 lc rgb '#66CCEE' title 'angle, RATTLE', \
     data.'/parts' using 1:2 with points pt 4 ps 1.1 lc rgb '#AA3377' title 'angle, h = 1/60 s in parts', \
     data.'/order_baumgarte' using 1:3 with points pt 9 ps 0.8 lc rgb '#228833' title 'pin, Baumgarte', \
     5 * x with lines dt 2 lc rgb '#808080' title 'order 1', \
     5 * x * x with lines dt 3 lc rgb '#808080' title 'order 2'
