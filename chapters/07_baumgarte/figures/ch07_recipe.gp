# Raise beta until it is unstable: the error of position, and what it costs.
load style
set terminal svg size 820,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set multiplot layout 1,2
set xlabel 'β' tc rgb '#808080'
set logscale y
set xrange [0:2.6]
set arrow 1 from 2, graph 0 to 2, graph 1 nohead dt (4,6) lw 0.8 lc rgb '#808080'
set arrow 2 from 1, graph 0 to 1, graph 1 nohead dt (4,6) lw 0.8 lc rgb '#808080'
set ylabel 'largest error of position [mm]' tc rgb '#808080'
set yrange [0.05:1200]
set format y '10^{%L}'
set title 'position error' tc rgb '#808080'
set key top left font ',11'
names = "bead hanging_chain swinging_chain column ten_discs"
titles = "'bead' 'hanging chain' 'swinging chain' 'column' 'ten discs'"
colours = "#AA3377 #4477AA #228833 #EE7733 #CC3311"
plot for [i = 1:5] data.'/recipe_'.word(names, i) using 1:2 with linespoints pt 7 ps 0.4 lc rgb word(colours, i) title word(titles, i)
unset logscale y
set title 'hop out of an overlap of 0.1 m' tc rgb '#808080'
set ylabel 'height above rest [m]' tc rgb '#808080'
set yrange [0:8]
set format y '%g'
unset key
set label 1 'Baumgarte' at 1.45,4.2 right tc rgb '#EE7733'
set label 2 'the other ways' at 1.06,0.4 left tc rgb '#4477AA'
plot data.'/hop_baumgarte' using 1:3 with lines lc rgb '#808080', \
     data.'/hop_baumgarte' using 1:2 with points pt 7 ps 0.6 lc rgb '#EE7733', \
     for [way in "relaxation split_impulse projection"] data.'/hop_'.way using 1:2 with points pt 7 ps 0.5 lc rgb '#4477AA'
unset multiplot
