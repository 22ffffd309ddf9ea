# Height of a disc that should rest in a groove, by how the impulses are clamped.
set terminal svg size 720,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator comma
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'height above its place of rest [mm]' tc rgb '#808080'
set xrange [0:3]; set yrange [-1:2.2]
set label 1 'each correction clamped, contacts known when they touch' at 0.1,1.95 left tc rgb '#CC3311'
set label 2 'each correction clamped, contacts known before' at 2.95,0.75 right tc rgb '#EE7733'
set label 3 'the sum clamped' at 0.1,-0.8 left tc rgb '#4477AA'
unset key
plot data.'/late_correction' using 2:(1000*$4) with linespoints pt 7 ps 0.3 lw 0.8 lc rgb '#CC3311', \
     data.'/jitter_correction' using 2:(1000*$4) with points pt 7 ps 0.4 lc rgb '#EE7733', \
     data.'/jitter_given' using 2:(1000*$4) with lines lw 1.5 lc rgb '#4477AA'
