# Residual and sideways momentum against sweeps for each order of the rows.
set terminal svg size 860,720 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator comma
set multiplot layout 2,2
methods = "given alternating shuffled coloured blocks"
colours = "#4477AA #AA3377 #EE7733 #228833 #CC3311"
set xlabel 'sweeps' tc rgb '#808080'
set logscale y
set format y '10^{%L}'
set ylabel 'residual [m/s]' tc rgb '#808080'
set key bottom left tc rgb '#808080' samplen 1 font ',12'
set xrange [0:1500]; set yrange [1e-5:0.3]
set title 'triangle of 210 discs, 592 rows' tc rgb '#808080'
plot for [k = 1:5] data.'/order_'.word(methods, k) using 1:4 every 10::1 with lines lw 1.3 lc rgb word(colours, k) title word(methods, k)
set title 'column of 20 discs' tc rgb '#808080'
set yrange [1e-8:0.3]
plot for [k = 1:5] data.'/column_'.word(methods, k) using 1:4 every 10::1 with lines lw 1.3 lc rgb word(colours, k) title word(methods, k)
unset logscale
set format y '%g'
set ylabel 'sideways / (weight · h)' tc rgb '#808080'
unset key
set xrange [0:60]; set autoscale y
set title 'triangle: what the first sweeps leave' tc rgb '#808080'
plot 0 with lines lc rgb '#808080' dt 2, for [k = 1:5] data.'/order_'.word(methods, k) using 1:6 every ::1 with lines lw 1.3 lc rgb word(colours, k)
set ylabel 'largest velocity / (g · h)' tc rgb '#808080'
set yrange [0:1.6]
plot for [k = 1:5] data.'/order_'.word(methods, k) using 1:5 every ::1 with lines lw 1.3 lc rgb word(colours, k)
unset multiplot
