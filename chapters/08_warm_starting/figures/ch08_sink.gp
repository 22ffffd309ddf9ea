# How far the top of a column of 20 sinks with ten sweeps a step.
set terminal svg size 720,440 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator comma
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'the top is above its start [mm]' tc rgb '#808080'
set xrange [0:6]; set yrange [-130:5]
unset key
set label 1 'cold: falls through' at 0.65,-120 left tc rgb '#CC3311'
set label 2 'from the previous answer' at 3,-44 left tc rgb '#4477AA'
set label 3 'from its best multiple' at 3,-20 left tc rgb '#228833'
set label 4 'theory, (8.8)' at 5.9,-57 right tc rgb '#808080'
stats data.'/sink_previous' using 15 every ::10 nooutput
sunk = 1000 * STATS_min
plot sunk with lines dt 2 lw 1.5 lc rgb '#808080', \
     data.'/sink_cold' using 2:(1000 * $12) every ::1 with lines lw 2 lc rgb '#CC3311', \
     data.'/sink_previous' using 2:(1000 * $12) every ::1 with lines lw 2 lc rgb '#4477AA', \
     data.'/sink_best_multiple' using 2:(1000 * $12) every ::1 with lines lw 2 lc rgb '#228833'
