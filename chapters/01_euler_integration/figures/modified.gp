# Energy (left) and modified energy (right) of a pendulum under symplectic Euler, at two step sizes.
size_x = 860; size_y = 380
load folder.'/style.gp'
set xrange [0:5]
set xlabel "t [s]"
set key top right horizontal
rows(h) = sprintf("< grep '^%s,' %s", h, data)
set multiplot layout 1,2 margins 0.09,0.98,0.15,0.90 spacing 0.12,0.1
set title "energy"
set ylabel "change since the start [J/kg]"
set yrange [-0.3:0.4]
plot rows('0.02') using 2:3 with linespoints pt 7 ps 0.25 lw 0.6 lc rgb orange title "h = 0.02 s", \
     rows('0.01') every 2 using 2:3 with linespoints pt 7 ps 0.25 lw 0.6 lc rgb blue title "h = 0.01 s"
set title "modified energy (1.21)"
unset ylabel
set yrange [-0.006:0.008]
plot rows('0.02') using 2:4 with linespoints pt 7 ps 0.25 lw 0.6 lc rgb orange title "h = 0.02 s", \
     rows('0.01') every 2 using 2:4 with linespoints pt 7 ps 0.25 lw 0.6 lc rgb blue title "h = 0.01 s"
unset multiplot
