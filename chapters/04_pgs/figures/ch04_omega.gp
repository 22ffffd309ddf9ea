# Relaxation: the rate on a column of ten, the sweeps of the ten discs.
set terminal svg size 820,400 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 1,2
set xlabel 'relaxation ω' tc rgb '#808080'
unset key
set title 'column of 10' tc rgb '#808080'
set ylabel 'error after a sweep / before' tc rgb '#808080'
set xrange [0.2:2]; set yrange [0.7:1.02]
rho = cos(pi / 20)**2
rate(w) = w * w * rho - 4 * (w - 1) > 0 ? ((w * sqrt(rho) + sqrt(w * w * rho - 4 * (w - 1))) / 2)**2 : w - 1
set samples 400
set label 1 'theory' at 0.85,0.955 right tc rgb '#808080'
plot rate(x) with lines lw 1.5 lc rgb '#808080', data.'/omega_column' with points pt 7 ps 0.6 lc rgb '#4477AA'
set title 'ten discs, 2400 steps' tc rgb '#808080'
set ylabel 'mean sweeps of a step' tc rgb '#808080'
unset label 1
set yrange [0:*]
set xrange [0.2:1.8]
plot data.'/omega_discs' with points pt 7 ps 0.6 lc rgb '#EE7733'
unset multiplot
