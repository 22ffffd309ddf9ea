# A spring in its phase plane, hω = 0.5: dots are steps, the ellipse is (1.11).
size_x = 680; size_y = 480
load folder.'/style.gp'
set size ratio -1
set xrange [-1.7:1.7]; set yrange [-1.6:1.25]
set xlabel "x / amplitude"; set ylabel "u / (ω · amplitude)"
set parametric; set trange [0:2*pi]; set samples 400
set key outside right top
h = 0.5
# u² + x² − h x u = 1 in polar coordinates: r² (1 − h cos t sin t) = 1.
r(t) = 1/sqrt(1 - h*cos(t)*sin(t))
plot data using 2:3 every ::0::6 with linespoints pt 7 ps 0.5 lw 1 lc rgb orange title "explicit", \
     data using 6:7 every ::0::20 with linespoints pt 7 ps 0.4 lw 1 lc rgb green title "implicit", \
     data using 4:5 with points pt 7 ps 0.6 lc rgb blue title "symplectic", \
     r(t)*cos(t), r(t)*sin(t) with lines lw 1.2 lc rgb blue title "its ellipse (1.11)", \
     cos(t), sin(t) with lines lw 1.2 dt 2 lc rgb ink title "exact: a circle"
