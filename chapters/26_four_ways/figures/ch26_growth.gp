# Time of a step for each rod of a chain, against the number of rods.
set terminal svg size 640,420 dynamic enhanced font 'DejaVu Sans,15' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set xtics (10, 20, 40, 80, 160)
set xrange [9:180]
set format y '10^{%L}'
set xlabel 'rods of the chain' tc rgb '#808080'
set ylabel 'time of a step for each rod [ns]' tc rgb '#808080'
set key outside top center horizontal tc rgb '#808080' samplen 1 maxrows 3
ways = 'spring end_spring acceleration impulses positions coordinates'
colours = '#EE7733 #AA7700 #CC3311 #4477AA #228833 #AA3377'
titles = 'spring end_spring acceleration impulses positions coordinates'
plot for [i = 1:6] data.'/beads_'.word(ways, i) using 1:2 with linespoints lw 1.4 pt 7 ps 0.6 lc rgb word(colours, i) \
     title (i == 2 ? 'end spring' : word(titles, i))
