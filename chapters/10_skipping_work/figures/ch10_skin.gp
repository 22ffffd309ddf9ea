# Distances computed and discs that query the grid, against the skin.
set terminal svg size 760,400 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format y '10^{%L}'
set xlabel 'skin [mm]' tc rgb '#808080'
set ylabel 'in a step, on average' tc rgb '#808080'
set xtics ('0' 0.5, '1' 1, '2' 2, '5' 5, '10' 10, '20' 20, '50' 50, '100' 100, '200' 200)
set xrange [0.4:250]
set key at graph 0.99,0.62 right top tc rgb '#808080' samplen 1 font ',12' Left reverse
plot data.'/skin' using ($1 > 0 ? 1000 * $1 : 0.5):2 with linespoints pt 7 ps 0.7 lc rgb '#AA3377' title 'distances computed', \
     data.'/skin' using ($1 > 0 ? 1000 * $1 : 0.5):($3 > 0 ? $3 : 1/0) with linespoints pt 5 ps 0.7 lc rgb '#4477AA' title 'discs that query the grid'
