# Guesses of the ten discs, added up over the steps: from the previous set and from none.
set terminal svg size 760,380 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator ','
set xlabel 'steps' tc rgb '#808080'
set ylabel 'guesses so far' tc rgb '#808080'
set xrange [0:1440]; set yrange [0:*]
set key tc rgb '#808080' samplen 1.5 font ',12' Left reverse top left
plot data.'/cold' skip 1 using 1:3 smooth cumulative with lines lw 2 lc rgb '#EE7733' title 'from nothing', \
     data.'/warm' skip 1 using 1:3 smooth cumulative with lines lw 2 lc rgb '#4477AA' title "from the previous set", \
     x with lines dt 2 lc rgb '#808080' title 'one for each step'
