# Error of the position against time of a step, by sub-steps, for every method on a sheet that falls on a ball.
set terminal svg size 720,460 dynamic enhanced font 'DejaVu Sans,17' linewidth 1.4
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'time of a step [µs]' tc rgb '#808080'
set ylabel 'way to the reference [m]' tc rgb '#808080'
set xrange [10:1e5]; set yrange [1e-3:1]
methods = "small threads xpbd particles augmented projective implicit newton midpoint explicit exact"
colours = "#4477AA #CC3311 #66CCEE #228833 #99CC55 #CCBB44 #EE7733 #AA3377 #332288 #808080 #88CCAA"
set key outside right tc rgb '#808080' samplen 0.8 Left reverse
plot for [m = 1:11] data.'/ball_'.word(methods, m) using 1:2 with linespoints lw 1.2 pt 7 ps 0.55 lc rgb word(colours, m) title word(methods, m)
