# A disc in the floor: its overlap and its speed under the four ways that correct an error.
load style
set terminal svg size 900,360 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set multiplot layout 1,2
set xlabel 'step' tc rgb '#808080'
set xrange [-0.5:20.5]
set key top right
set ylabel 'overlap [mm]' tc rgb '#808080'
set yrange [0:110]
plot 100*0.8**x lc rgb '#808080' lw 1.5 title '0.8^{n}', \
     data.'/three_baumgarte' using 1:(1000*$4) every ::1 with points pt 7 ps 0.9 lc rgb '#CC3311' title 'Baumgarte', \
     data.'/three_relaxation' using 1:(1000*$4) every ::1 with points pt 4 ps 0.9 lc rgb '#EE7733' title 'relaxation', \
     data.'/three_split_impulse' using 1:(1000*$4) every ::1 with points pt 6 ps 1.1 lc rgb '#4477AA' title 'split impulse', \
     data.'/three_projection' using 1:(1000*$4) every ::1 with points pt 2 ps 0.8 lc rgb '#228833' title 'projection'
set ylabel 'speed [m/s]' tc rgb '#808080'
set yrange [-0.06:1.3]
plot data.'/three_baumgarte' using 1:7 every ::1 with points pt 7 ps 0.9 lc rgb '#CC3311' title 'Baumgarte', \
     data.'/three_relaxation' using 1:7 every ::1 with points pt 4 ps 0.9 lc rgb '#EE7733' title 'relaxation', \
     data.'/three_split_impulse' using 1:7 every ::1 with points pt 6 ps 1.1 lc rgb '#4477AA' title 'split impulse', \
     data.'/three_projection' using 1:7 every ::1 with points pt 2 ps 0.8 lc rgb '#228833' title 'projection'
unset multiplot
