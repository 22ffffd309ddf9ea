# Run time against error of the exact ways, a point for each size.
load folder.'/style.gp'
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'run time [µs]' tc rgb ink
set ylabel 'natural residual / largest |q|' tc rgb ink
set xrange [0.2:1e6]; set yrange [5e-17:1e-6]
set key left top
set arrow 1 from 0.2,1e-10 to 1e6,1e-10 nohead dt 2 lw 1 lc rgb ink
set label 1 'tolerance: above it no answer is called solved' at 400,3e-10 tc rgb ink font ',12'
plot data.'/enumerate_boxed' using ($3/1000):4 with linespoints pt 9 ps 0.7 lw 1.2 lc rgb red title 'enumeration, 3^n sets, n to 10', \
     data.'/enumerate_contacts' using ($3/1000):4 with linespoints pt 5 ps 0.6 lw 1.2 lc rgb orange title 'enumeration, 2^n sets, n to 16', \
     data.'/schur' using ($3/1000):4 with linespoints pt 7 ps 0.6 lw 1.2 lc rgb green title 'Schur, to 3000 links', \
     data.'/direct' using ($3/1000):4 with linespoints pt 11 ps 0.7 lw 1.2 lc rgb blue title 'direct, to 10000 links'
