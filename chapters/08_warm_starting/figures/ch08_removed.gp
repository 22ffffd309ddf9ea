# How far the next disc rises when the heavy one is taken away.
set terminal svg size 820,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 1,2
set xlabel 'sweeps a step' tc rgb '#808080'
set ylabel 'rises above its place by [mm]' tc rgb '#808080'
set logscale xy
set xrange [1.8:45]; set yrange [0.008:4000]
set xtics (2, 5, 10, 20, 40)
set format y '10^{%L}'
unset key
set arrow 1 from 1.8,10 to 45,10 nohead dt 3 lc rgb '#808080'
shown(y) = y < 0.01 ? 0.01 : y
set title 'from the previous answer' tc rgb '#808080'
plot data.'/removed_previous_0' using 1:(shown($2)) with linespoints pt 7 ps 0.6 lc rgb '#808080' title 'none', \
     data.'/removed_previous_1' using 1:(shown($2)) with linespoints pt 7 ps 0.6 lc rgb '#CC3311' title 'Baumgarte', \
     data.'/removed_previous_2' using 1:(shown($2)) with linespoints pt 7 ps 0.6 lc rgb '#EE7733' title 'relaxation', \
     data.'/removed_previous_3' using 1:(shown($2)) with linespoints pt 7 ps 0.6 lc rgb '#4477AA' title 'split impulse', \
     data.'/removed_previous_4' using 1:(shown($2)) with linespoints pt 7 ps 0.6 lc rgb '#228833' title 'projection'
set title 'from its best multiple' tc rgb '#808080'
set label 1 'wanted: 10 mm' at 43,16 right tc rgb '#808080'
set key at graph 0.98, graph 0.45 tc rgb '#808080' samplen 1 spacing 1.1
plot data.'/removed_best_multiple_0' using 1:(shown($2)) with linespoints pt 7 ps 0.6 lc rgb '#808080' title 'none', \
     data.'/removed_best_multiple_1' using 1:(shown($2)) with linespoints pt 7 ps 0.6 lc rgb '#CC3311' title 'Baumgarte', \
     data.'/removed_best_multiple_2' using 1:(shown($2)) with linespoints pt 7 ps 0.6 lc rgb '#EE7733' title 'relaxation', \
     data.'/removed_best_multiple_3' using 1:(shown($2)) with linespoints pt 7 ps 0.6 lc rgb '#4477AA' title 'split impulse', \
     data.'/removed_best_multiple_4' using 1:(shown($2)) with linespoints pt 7 ps 0.6 lc rgb '#228833' title 'projection'
unset multiplot
