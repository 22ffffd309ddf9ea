# Guesses of each step of the ten discs, from yesterday's set and from none.
set terminal svg size 860,380 dynamic enhanced font 'DejaVu Sans,13' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator ','
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'guesses of the step' tc rgb '#808080'
set xrange [0:3]; set yrange [0:*]
set ytics 1
set key tc rgb '#808080' samplen 1 font ',12' Left reverse top left horizontal
plot data.'/cold' skip 1 using 2:3 with points pt 6 ps 0.6 lc rgb '#EE7733' title 'from nothing', \
     data.'/warm' skip 1 using 2:3 with points pt 7 ps 0.35 lc rgb '#4477AA' title "from yesterday's set"
