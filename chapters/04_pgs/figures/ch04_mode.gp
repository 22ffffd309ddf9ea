# What the sweeps leave of the error in each row of a column of ten: dots, and the slowest mode alone: lines.
set terminal svg size 720,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set xlabel 'row, from the floor up' tc rgb '#808080'
set ylabel 'error / largest impulse' tc rgb '#808080'
set xrange [0.7:10.5]; set yrange [0:1.05]
set xtics 1
unset key
set samples 200
N = 10
theta = pi / (2 * N)
# (4.15) in row 1, and y_k = mu^k x_k (4.12) in the others
left(x, s) = 2 / (N * sin(theta))**2 * cos(theta)**(2 * s) * cos(theta)**(x - 1) * cos((x - 1) * theta)
set label 1 'before the first sweep' at 2.15,0.95 left tc rgb '#808080'
set label 2 'after 10 sweeps' at 1.9,0.54 left tc rgb '#4477AA'
set label 3 'after 30' at 4.15,0.375 left tc rgb '#228833'
set label 4 'after 90' at 4.15,0.115 left tc rgb '#EE7733'
plot data.'/mode_0' with points pt 7 ps 0.7 lc rgb '#808080', \
     left(x, 10) with lines lw 1.5 lc rgb '#4477AA', left(x, 30) with lines lw 1.5 lc rgb '#228833', \
     left(x, 90) with lines lw 1.5 lc rgb '#EE7733', \
     data.'/mode_10' with points pt 7 ps 0.7 lc rgb '#4477AA', \
     data.'/mode_30' with points pt 7 ps 0.7 lc rgb '#228833', \
     data.'/mode_90' with points pt 7 ps 0.7 lc rgb '#EE7733'
