# What steps the adaptive method takes, and how fast the body moves.
size_x = 860; size_y = 380
load folder.'/style.gp'
rows(name) = sprintf("< grep '^%s,' %s", name, data)
set multiplot
set size 0.52, 1; set origin 0, 0
set title "Kepler e = 0.6, tolerance 10^{−6}"
set xlabel "t [s]"; set ylabel "step h [s]"; set yrange [0:0.55]; set xrange [0:12.6]
set y2label "speed |u| [m/s]" textcolor rgb blue; set y2tics textcolor rgb blue; set y2range [0:2.8]; set border 11
set key top center horizontal
plot rows('kepler') using 2:4 axes x1y2 with lines lw 1.2 lc rgb blue title "speed", \
     rows('kepler') using 2:3 with linespoints pt 7 ps 0.45 lw 0.6 lc rgb orange title "step"
set size 0.48, 1; set origin 0.52, 0
set title "projectile, k = 0.02 1/m, tolerance 10^{−6}"
set xrange [0:3]; set yrange [0:0.7]; set y2range [0:36]
plot rows('projectile') using 2:4 axes x1y2 with lines lw 1.2 lc rgb blue title "speed", \
     rows('projectile') using 2:3 with linespoints pt 7 ps 0.5 lw 0.6 lc rgb orange title "step"
unset multiplot
