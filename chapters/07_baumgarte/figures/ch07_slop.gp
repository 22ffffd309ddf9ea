# Three discs at rest, or not: the speed of the fastest.
load style
set logscale y
set format y '10^{%L}'
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'greatest speed of a disc [m/s]' tc rgb '#808080'
set xrange [0:10]; set yrange [1e-9:30]
set key top right horizontal
plot data.'/slop_none' using 2:7 every ::2 with points pt 7 ps 0.3 lc rgb '#EE7733' title 'rows of overlaps only', \
     data.'/slop_slop' using 2:7 every ::2 with points pt 7 ps 0.3 lc rgb '#228833' title 'slop of 2 mm', \
     data.'/slop_margin' using 2:7 every ::2 with points pt 7 ps 0.3 lc rgb '#4477AA' title 'rows from a gap of 20 mm on'
