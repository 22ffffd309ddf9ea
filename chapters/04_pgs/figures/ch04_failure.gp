# How deep a heavy disc sinks into a light one.
set terminal svg size 720,440 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'R, mass of the upper disc / mass of the lower' tc rgb '#808080'
set ylabel 'overlap after 20 s [mm]' tc rgb '#808080'
set xrange [0.9:1.2e4]; set yrange [1e-3:1200]
unset key
set label 1 '5 sweeps a step' at 1.3,14 left tc rgb '#CC3311'
set label 2 '20' at 42,13 right tc rgb '#EE7733'
set label 3 '100' at 250,2 left tc rgb '#4477AA'
set label 4 'one radius: it falls through, upper edge' at 1,150 left tc rgb '#808080'
plot 100 with lines dt 2 lc rgb '#808080', \
     data.'/sink_5' with points pt 7 ps 0.7 lc rgb '#CC3311', data.'/sink_20' with points pt 7 ps 0.7 lc rgb '#EE7733', \
     data.'/sink_100' with points pt 7 ps 0.7 lc rgb '#4477AA'
