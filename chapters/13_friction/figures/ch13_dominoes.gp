# How many dominoes have begun to tip, against time, for three gaps.
set terminal svg size 720,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator ','
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'dominoes that have begun to tip' tc rgb '#808080'
set key outside top center horizontal tc rgb '#808080' samplen 1.5
set xrange [0:5]
set yrange [0:30]
plot data.'/dominoes0.2' using 2:3 every 12 with steps lw 1.6 lc rgb '#4477AA' title 'gap 0.2 m', \
     data.'/dominoes0.35' using 2:3 every 12 with steps lw 1.6 lc rgb '#EE7733' title '0.35 m', \
     data.'/dominoes0.6' using 2:3 every 12 with steps lw 1.6 lc rgb '#228833' title '0.6 m'
