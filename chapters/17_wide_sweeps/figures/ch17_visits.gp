# Nanoseconds a row visit against rows, for each way of sweeping.
set terminal svg size 720,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale x
set xlabel 'rows' tc rgb '#808080'
set ylabel 'ns a row visit' tc rgb '#808080'
set yrange [0:*]
set xrange [300:80000]
set key outside top center horizontal tc rgb '#808080' samplen 1.5
ways = "given rows bundles doubles floats"
colours = "#4477AA #66CCEE #228833 #EE7733 #AA3377"
plot for [m = 1:5] data.'/visits_'.word(ways, m) using 1:2 with linespoints lw 1.6 pt 7 ps 0.5 lc rgb word(colours, m) title word(ways, m)
