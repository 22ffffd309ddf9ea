# A linear error under five values of beta.
load style
set terminal svg size 760,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set multiplot layout 1,2
set xlabel 'step n' tc rgb '#808080'
set xrange [0:20]
set ylabel 'C_n / C_0' tc rgb '#808080'
set xzeroaxis lc rgb '#808080' dt 3
set title 'monotone to β = 1' tc rgb '#808080'
set yrange [-0.1:1.05]
plot for [i = 1:3] data.'/rail_'.word("0.2 0.5 1", i) using 1:4 every ::1 with lines lc rgb '#808080' notitle, \
     for [i = 1:3] data.'/rail_'.word("0.2 0.5 1", i) using 1:3 every ::1 with points pt 7 ps 0.5 lc rgb word("#4477AA #228833 #EE7733", i) title 'β = '.word("0.2 0.5 1", i)
set title 'beyond 1 it swings, beyond 2 it grows' tc rgb '#808080'
set yrange [-3:4.6]
plot for [i = 1:3] data.'/rail_'.word("1.5 1.9 2.05", i) using 1:4 every ::1 with lines lc rgb '#808080' notitle, \
     for [i = 1:3] data.'/rail_'.word("1.5 1.9 2.05", i) using 1:3 every ::1 with points pt 7 ps 0.5 lc rgb word("#4477AA #228833 #EE7733", i) title 'β = '.word("1.5 1.9 2.05", i)
unset multiplot
