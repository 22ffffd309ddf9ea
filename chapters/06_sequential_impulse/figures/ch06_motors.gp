# Speeds of three lifts and of discs on a belt, with their closed forms.
set terminal svg size 820,400 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator comma
set multiplot layout 1,2
unset key
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'speed [m/s]' tc rgb '#808080'
set xrange [0:1.2]
min(a, b) = a < b ? a : b
set title 'three lifts' tc rgb '#808080'
set yrange [-1:1.3]
set label 1 '2 mg' at 0.13,1.12 tc rgb '#228833'
set label 2 '1.1 mg' at 0.6,0.45 tc rgb '#4477AA'
set label 3 '0.9 mg' at 0.12,-0.6 tc rgb '#CC3311'
plot data.'/lift' using 2:3 every 2::1 with points pt 7 ps 0.5 lc rgb '#CC3311', \
     data.'/lift' using 2:4 every 2::1 with points pt 7 ps 0.5 lc rgb '#4477AA', \
     data.'/lift' using 2:5 every 2::1 with points pt 7 ps 0.5 lc rgb '#228833', \
     (x < 0.782 ? -0.981 * x : 1/0) with lines lc rgb '#808080', min(0.981 * x, 1) with lines lc rgb '#808080', \
     min(9.81 * x, 1) with lines lc rgb '#808080'
unset label
set title 'discs on a belt of 1 m/s, at most 1 N' tc rgb '#808080'
set yrange [0:1.2]
plot data.'/belt' using 2:3 every 2::1 with points pt 7 ps 0.5 lc rgb '#4477AA', min(x, 1) with lines lc rgb '#808080'
unset multiplot
