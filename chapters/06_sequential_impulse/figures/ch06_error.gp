# Residual against time for each order, by blocks, and by chapter 4.
set terminal svg size 820,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 1,2
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'time [µs]' tc rgb '#808080'
set ylabel 'residual [m/s]' tc rgb '#808080'
methods = "given alternating shuffled coloured blocks"
colours = "#4477AA #AA3377 #EE7733 #228833 #CC3311 #808080"
set yrange [1e-8:0.3]
set key bottom left tc rgb '#808080' samplen 1 font ',12'
set title 'triangle, about 600 rows' tc rgb '#808080'
plot data.'/error_triangle_pgs' using 3:2 with linespoints lw 1.2 pt 7 ps 0.4 lc rgb '#808080' title 'chapter 4', for [k = 1:5] data.'/error_triangle_'.word(methods, k) using 3:2 with linespoints lw 1.2 pt 7 ps 0.4 lc rgb word(colours, k) title word(methods, k)
unset key
set title 'column of 50' tc rgb '#808080'
plot data.'/error_column_pgs' using 3:2 with linespoints lw 1.2 pt 7 ps 0.4 lc rgb '#808080', for [k = 1:5] data.'/error_column_'.word(methods, k) using 3:2 with linespoints lw 1.2 pt 7 ps 0.4 lc rgb word(colours, k)
unset multiplot
