# Energy of a spring under three Euler methods: dots are runs, lines are (1.9), (1.15) and (1.11).
size_y = 480
load folder.'/style.gp'
set logscale y
set xrange [0:400]; set yrange [0.01:100]
set xlabel "steps n, hω = 0.1"; set ylabel "energy / energy at the start"
set key above maxrows 2
h = 0.1
set samples 800
# (1.11) with x = cos(nα + δ) on its ellipse, cos α = 1 − h²/2: the energy swings within 1 ± h/2.
plot (1 + h*h)**x with lines lw 1.2 lc rgb orange title "(1 + h²ω²)^n", \
     data using 1:2 every 10 with points pt 7 ps 0.5 lc rgb orange title "explicit Euler", \
     data using 1:3 every 4 with points pt 7 ps 0.35 lc rgb blue title "symplectic Euler", \
     1/(1 + h/2)*1 with lines lw 1.2 dt 2 lc rgb blue title "its bounds, 1/(1 ± hω/2)", \
     1/(1 - h/2) with lines lw 1.2 dt 2 lc rgb blue notitle, \
     (1 + h*h)**(-x) with lines lw 1.2 lc rgb green title "(1 + h²ω²)^{−n}", \
     data using 1:4 every 10 with points pt 7 ps 0.5 lc rgb green title "implicit Euler"
