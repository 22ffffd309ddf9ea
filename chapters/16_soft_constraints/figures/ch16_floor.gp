# Overlap of a stack of five boxes at rest against sub-steps; the line is (16.14) with a quarter of a turn a sub-step.
set terminal svg size 720,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator ','
set xlabel 'sub-steps' tc rgb '#808080'
set ylabel 'deepest overlap [m]' tc rgb '#808080'
set key outside top center horizontal tc rgb '#808080' samplen 1.5
set logscale xy
set format y '10^{%T}'
set xtics (1, 2, 4, 8, 16)
set xrange [0.8:20]
sag(n) = 5*4*9.81/2/(2*pi*15*n)**2
plot sag(x) lw 1.6 lc rgb '#808080' title 'load over stiffness', \
     data.'/floor_soft' using 1:4 with points pt 7 ps 0.8 lc rgb '#4477AA' title 'soft', \
     data.'/floor_preloaded' using 1:4 with points pt 5 ps 0.8 lc rgb '#EE7733' title 'preloaded'
