# Sweeps and rows of each step of the ten discs.
set terminal svg size 760,380 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator comma
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'sweeps' tc rgb '#4477AA'
set y2label 'rows' tc rgb '#EE7733'
set border 11 lc rgb '#808080'
set y2tics out tc rgb '#808080'
set y2range [0:60]; set yrange [0:*]; set xrange [0:5]
unset key
plot data.'/discs' using 2:3 every ::2 with points pt 7 ps 0.25 lc rgb '#4477AA', \
     data.'/discs' using 2:6 every ::2 axes x1y2 with steps lw 1.2 lc rgb '#EE7733'
