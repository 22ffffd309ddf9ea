# Error after a second against the time that the second takes, for each way, from 30 to 3840 steps.
set terminal svg size 640,470 dynamic enhanced font 'DejaVu Sans,15' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'time of one second [µs]' tc rgb '#808080'
set ylabel 'error [m]' tc rgb '#808080'
set yrange [3e-14:top]
set key outside top center horizontal tc rgb '#808080' samplen 1 maxrows 3
colour(way) = way eq 'spring' ? '#EE7733' : way eq 'end_spring' ? '#AA7700' : way eq 'acceleration' ? '#CC3311' : \
              way eq 'single' ? '#33AACC' : way eq 'impulses' ? '#4477AA' : way eq 'positions' ? '#228833' : '#AA3377'
title(way) = way eq 'end_spring' ? 'end spring' : way
plot for [way in ways] data.'/'.scene.'_'.way using 1:2 with linespoints lw 1.4 pt 7 ps 0.6 lc rgb colour(way) title title(way)
