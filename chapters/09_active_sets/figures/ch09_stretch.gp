# Length of the chain of 200 links over that of its links, less one.
set terminal svg size 760,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator ','
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'chain longer by [%]' tc rgb '#808080'
set xrange [0:5]; set yrange [-0.2:1.2]
set key tc rgb '#808080' samplen 1.5 font ',12' Left reverse top right
plot data.'/stretch_10' skip 2 using 2:(100*($14-1)) with lines lw 1.5 lc rgb '#EE7733' title '10 sweeps', \
     data.'/stretch_40' skip 2 using 2:(100*($14-1)) with lines lw 1.5 lc rgb '#228833' title '40 sweeps', \
     data.'/stretch_160' skip 2 using 2:(100*($14-1)) with lines lw 1.5 lc rgb '#AA3377' title '160 sweeps', \
     data.'/stretch_exact' skip 2 using 2:(100*($14-1)) with lines lw 2 lc rgb '#4477AA' title 'active sets: one factorisation'
