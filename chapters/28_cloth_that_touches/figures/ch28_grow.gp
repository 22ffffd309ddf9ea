# Time of a step against the number of particles.
set terminal svg size 720,420 dynamic enhanced font 'DejaVu Sans,16' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xrange [90:150000]
set xlabel 'particles' tc rgb '#808080'
set ylabel 'time of a step [ms]' tc rgb '#808080'
set yrange [0.03:2000]
set key bottom right tc rgb '#808080' samplen 1.5
plot 16.7 with lines dt 2 lc rgb '#808080' title 'a step of 1/60 s', \
     data.'/grow_small' with linespoints pt 7 ps 0.6 lc rgb '#4477AA' title 'XPBD, 8 sub-steps', \
     data.'/grow_threads' with linespoints pt 7 ps 0.6 lc rgb '#CC3311' title 'threads, 8 sub-steps', \
     data.'/grow_particles' with linespoints pt 7 ps 0.6 lc rgb '#228833' title 'particles, 10 sweeps', \
     data.'/grow_projective' with linespoints pt 7 ps 0.6 lc rgb '#CCBB44' title 'one matrix, 10 passes', \
     data.'/grow_implicit' with linespoints pt 7 ps 0.6 lc rgb '#EE7733' title 'conjugate gradients'
