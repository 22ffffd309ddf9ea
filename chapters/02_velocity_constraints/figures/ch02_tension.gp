# λ/h of the pendulum's rod beside its exact pull.
set terminal svg size 720,400 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set datafile separator comma
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'pull of the rod [N]' tc rgb '#808080'
set key right top tc rgb '#808080' samplen 2
set xrange [0:2.2]; set yrange [-1:38]
set arrow 1 from 0,29.43 to 2.2,29.43 nohead lc rgb '#808080' dt 3
set label 1 '3 m g' at 0.02,30.8 tc rgb '#808080'
file = data.'/tension.csv'
plot file skip 1 using 2:8 with lines lw 1.5 lc rgb '#4477AA' title 'exact motion', \
     file skip 1 every 2 using 2:7 with points pt 7 ps 0.45 lc rgb '#EE7733' title '-λ/h with h = 1/240 s'
