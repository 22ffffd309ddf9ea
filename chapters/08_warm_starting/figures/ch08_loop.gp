# Five discs and seven rods, nudged: the greatest speed against time.
set terminal svg size 720,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator comma
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'greatest speed [m/s]' tc rgb '#808080'
set logscale y
set format y '10^{%T}'
set xrange [0:4]; set yrange [1e-7:100]
unset key
set label 1 'from the previous answer' at 1.55,1e-3 left tc rgb '#4477AA'
set label 2 'slope by (8.6)' at 0.45,1e-2 left tc rgb '#808080'
set label 3 'cold, best multiple, or a sweep there and back' at 3.95,1e-6 right tc rgb '#228833'
stats data.'/loop_previous' using 15 every ::10::20 nooutput
growth = STATS_mean  # in a step
stats data.'/loop_previous' using 13 every ::15::45 nooutput
first = STATS_max
theory(t) = t > 0.3 && t < 2.2 ? 30 * first * growth**(60 * t - 45) : NaN
set samples 400
plot theory(x) with lines dt 2 lw 1.5 lc rgb '#808080', \
     data.'/loop_previous' using 2:13 every ::1 with lines lw 2 lc rgb '#4477AA', \
     data.'/loop_cold' using 2:13 every ::1 with lines lw 2 lc rgb '#CC3311', \
     data.'/loop_symmetric' using 2:13 every ::1 with lines lw 2 lc rgb '#AA7744', \
     data.'/loop_best_multiple' using 2:13 every ::1 with lines lw 2 lc rgb '#228833'
