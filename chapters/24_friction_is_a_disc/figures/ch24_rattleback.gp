# The spin of a rattleback about the vertical against time, at two steps and by its equation.
set terminal svg size 720,400 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'spin about the vertical [rad/s]' tc rgb '#808080'
set xrange [0:3]
set yrange [-3.5:3.5]
set xzeroaxis lc rgb '#808080' dt 3
set key outside top center horizontal maxcols 3 tc rgb '#808080' samplen 1.2
plot data.'/rattle_0.0005' using 1:3 with lines lc rgb '#808080' title 'by (24.12)', \
     data.'/rattle_0.002' using 1:2 with points pt 4 ps 0.6 lc rgb '#EE7733' title 'h = 2 ms', \
     data.'/rattle_0.0005' using 1:2 with points pt 7 ps 0.5 lc rgb '#4477AA' title 'h = 0.5 ms'
