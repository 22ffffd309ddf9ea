# What the tie tolerance does: pivots of Fathi's family and friction problems solved.
set terminal svg size 760,400 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 11 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set xlabel 'tie tolerance' tc rgb '#808080'
set ylabel 'friction problems solved, of 10' tc rgb '#4477AA'
set y2label "pivots on Fathi's 10 rows" tc rgb '#EE7733'
set y2tics (0, 256, 512, 768, 1024) tc rgb '#808080'
set xrange [0.5:16.5]; set yrange [0:11]; set y2range [0:1126.4]
set xtics ('10^{-2}' 2, '10^{-4}' 4, '10^{-6}' 6, '10^{-8}' 8, '10^{-10}' 10, '10^{-12}' 12, '10^{-14}' 14, '10^{-16}' 16)
unset key
set arrow 1 from 8,0 to 8,10.6 nohead dt 2 lc rgb '#808080'
set label 1 'the default' at 8.15,1 left tc rgb '#808080'
plot data.'/tie_stacks' with linespoints pt 7 ps 0.7 lc rgb '#4477AA', \
     data.'/tie_fathi' axes x1y2 with linespoints pt 5 ps 0.7 lc rgb '#EE7733'
