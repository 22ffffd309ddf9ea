# The way of the first mass in one step against the number of sweeps.
set terminal svg size 720,400 dynamic enhanced font 'DejaVu Sans,16' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale x
set xrange [0.9:120]; set yrange [0:75]
set xlabel 'sweeps' tc rgb '#808080'
set ylabel 'the first mass comes down [mm]' tc rgb '#808080'
set key at 100,48 right tc rgb '#808080' samplen 1.5
plot 60 with lines dt 2 lc rgb '#808080' notitle, \
     data.'/count_xpbd' using 1:(1000*$4) with linespoints pt 7 ps 0.6 lc rgb '#4477AA' title 'XPBD', \
     data.'/count_forgotten' using 1:(1000*$4) with linespoints pt 7 ps 0.6 lc rgb '#CC3311' title 'XPBD, Λ forgotten', \
     data.'/count_pbd' using 1:(1000*$4) with linespoints pt 7 ps 0.6 lc rgb '#EE7733' title 'PBD, s = 1'
