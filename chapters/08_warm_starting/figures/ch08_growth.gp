# Growth a step of what a chain of 20 under Baumgarte remembers.
set terminal svg size 720,440 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set xlabel 'sweeps a step' tc rgb '#808080'
set ylabel 'greatest speed, a step later / before' tc rgb '#808080'
set xrange [0:52]; set yrange [0.85:1.07]
unset key
set label 1 'β = 0.2, all that is remembered' at 13,1.047 left tc rgb '#CC3311'
set label 2 'β = 0.2, share 0.8 (dashed)' at 22,0.958 left tc rgb '#228833'
set label 3 'no error in the bias' at 2,0.94 left tc rgb '#4477AA'
set label 4 '(8.9): 29.5 sweeps' at 30.5,1.02 left tc rgb '#808080'
set arrow 1 from 29.53,0.85 to 29.53,1.07 nohead dt 3 lc rgb '#808080'
plot 1 with lines lw 0.8 lc rgb '#808080', \
     data.'/growth_previous' using 1:2 with lines lw 1.5 lc rgb '#CC3311', \
     data.'/growth_previous' using 1:3 with points pt 7 ps 0.6 lc rgb '#CC3311', \
     data.'/growth_none' using 1:2 with lines lw 1.5 lc rgb '#4477AA', \
     data.'/growth_none' using 1:3 with points pt 7 ps 0.6 lc rgb '#4477AA', \
     data.'/growth_factor' using 1:2 with lines dt 2 lw 2 lc rgb '#228833', \
     data.'/growth_factor' using 1:3 with points pt 6 ps 0.9 lc rgb '#228833'
