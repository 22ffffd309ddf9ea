# The tallest column that stands.
set terminal svg size 720,440 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set xlabel 'sweeps a step' tc rgb '#808080'
set ylabel 'discs in the tallest column that stands' tc rgb '#808080'
set logscale xy
set xrange [0.9:70]; set yrange [1:250]
set xtics (1, 2, 4, 8, 16, 32, 64)
set ytics (1, 2, 5, 10, 20, 50, 100, 200)
unset key
set label 1 'cold' at 40,6 left tc rgb '#CC3311'
set label 2 'from the previous answer' at 6,15 left rotate by 22 tc rgb '#4477AA'
set label 3 'from its best multiple' at 6,60 right tc rgb '#228833'
plot data.'/height_cold' with linespoints pt 7 ps 0.7 lc rgb '#CC3311', \
     data.'/height_previous' with linespoints pt 7 ps 0.7 lc rgb '#4477AA', \
     data.'/height_best_multiple' with linespoints pt 7 ps 0.7 lc rgb '#228833'
