# The pendulum: run time against error of the angle.
set terminal svg size 720,460 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set xlabel 'run time for one second of the pendulum [µs]' tc rgb '#808080'
set ylabel 'error of the angle [rad]' tc rgb '#808080'
set key right top Left reverse tc rgb '#808080' samplen 2
names = 'row repaid spring angle'
titles = "'one row, b = 0' 'one row, b = C/h' 'spring, h ω = 1' 'angle as coordinate'"
colours = '#4477AA #228833 #EE7733 #AA3377'
array P[4] = [7, 5, 9, 11]
plot for [i=1:4] data.'/'.word(names, i) using ($4 / 1000):5 with linespoints lw 1.2 pt P[i] ps 0.6 \
        lc rgb word(colours, i) title word(titles, i)
