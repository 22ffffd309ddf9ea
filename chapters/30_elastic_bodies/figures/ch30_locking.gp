# Sag of a cantilever over that of theory, against the boxes through its height.
set terminal svg size 720,460 dynamic enhanced font 'DejaVu Sans,16' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator ','
set xlabel 'boxes through the height' tc rgb '#808080'
set ylabel 'sag over theory' tc rgb '#808080'
set key outside top center horizontal tc rgb '#808080' samplen 1.5
set logscale x
set xtics (1, 2, 4, 8)
set xrange [0.9:9]
set yrange [0:1.1]
plot 1 lw 1.2 dt 2 lc rgb '#808080' notitle, \
     data.'/locking_2_0' using 1:4 with linespoints lw 1.6 pt 7 ps 0.8 lc rgb '#4477AA' title 'quadratic, ν = 0', \
     data.'/locking_2_0.4999' using 1:4 with linespoints lw 1.6 pt 5 ps 0.8 lc rgb '#66CCEE' title 'quadratic, ν = 0.4999', \
     data.'/locking_1_0' using 1:4 with linespoints lw 1.6 pt 7 ps 0.8 lc rgb '#CC3311' title 'linear, ν = 0', \
     data.'/locking_1_0.4999' using 1:4 with linespoints lw 1.6 pt 5 ps 0.8 lc rgb '#EE7733' title 'linear, ν = 0.4999', \
     data.'/locking_parallel' using 1:4 with linespoints lw 1.6 pt 9 ps 0.8 lc rgb '#AA3377' title 'the same, parallel'
