# The force of friction on a block that slides, for 24 directions of its velocity: on a disc, on a box, in a pyramid of six corners.
set terminal svg size 720,300 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080' 1
set size ratio -1
set xrange [-1.3:1.3]
set yrange [-1.3:1.3]
set xlabel 'force along t_1 over μ m g' tc rgb '#808080'
set ylabel 'along t_2' tc rgb '#808080'
set parametric
set trange [0:2*pi]
set samples 200
unset key
set multiplot layout 1,3
set title 'disc' tc rgb '#4477AA'
plot cos(t), sin(t) with lines lc rgb '#808080', \
     data.'/drag_cone' using 1:2 with points pt 7 ps 0.8 lc rgb '#4477AA'
set title 'box' tc rgb '#EE7733'
plot cos(t), sin(t) with lines dt 2 lc rgb '#808080', \
     '-' using 1:2 with lines lc rgb '#808080', \
     data.'/drag_box' using 1:2 with points pt 7 ps 0.8 lc rgb '#EE7733'
1 1
-1 1
-1 -1
1 -1
1 1
e
set title 'pyramid' tc rgb '#228833'
plot cos(t), sin(t) with lines dt 2 lc rgb '#808080', \
     '-' using 1:2 with lines lc rgb '#808080', \
     data.'/drag_pyramid' using 1:2 with points pt 7 ps 0.8 lc rgb '#228833'
1 0
0.5 0.8660254
-0.5 0.8660254
-1 0
-0.5 -0.8660254
0.5 -0.8660254
1 0
e
unset multiplot
