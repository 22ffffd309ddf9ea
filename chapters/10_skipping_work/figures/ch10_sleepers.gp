# Time of a step against the number of sleepers.
set terminal svg size 760,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format y '10^{%L}'
set xlabel 'discs at rest K' tc rgb '#808080'
set ylabel 'time of a step [µs]' tc rgb '#808080'
set xtics ('0' 0.5, '1' 1, '10' 10, '100' 100, '1000' 1000, '10 000' 10000)
set xrange [0.4:2e4]; set yrange [3e-3:2e6]
set key top left tc rgb '#808080' samplen 1 font ',12' Left reverse
set label 1 '1 µs' at 0.45,1.7 left tc rgb '#808080' font ',12'
plot 1 with lines dt 2 lc rgb '#808080' notitle, \
     data.'/plain' with linespoints pt 7 ps 0.7 lc rgb '#EE7733' title "chapter 8's step, all awake", \
     data.'/beside' with linespoints pt 5 ps 0.7 lc rgb '#228833' title 'a pendulum awake, K discs asleep', \
     data.'/sleepers' with linespoints pt 7 ps 0.7 lc rgb '#4477AA' title 'all asleep'
