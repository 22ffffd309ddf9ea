# Two periods of a Kepler orbit, e = 0.6, h = 0.02 s: tables of the program itself.
size_x = 720; size_y = 420
load folder.'/style.gp'
set size ratio -1
set xrange [-3.4:1.4]; set yrange [-1.5:1.5]
set xlabel "x [m]"; set ylabel "y [m]"
set key outside right top
set parametric; set trange [0:2*pi]; set samples 300
set object 1 circle at 0,0 size 0.07 fillstyle solid fillcolor rgb yellow front
plot data.'/explicit_euler.csv' using 3:4 skip 1 with lines lw 1.2 lc rgb orange title "explicit Euler", \
     data.'/symplectic_euler.csv' using 3:4 skip 1 with lines lw 1.2 lc rgb blue title "symplectic Euler", \
     data.'/rk4.csv' using 3:4 every 12 skip 1 with points pt 7 ps 0.5 lc rgb red title "RK4", \
     cos(t) - 0.6, 0.8*sin(t) with lines lw 1.2 dt 2 lc rgb ink title "exact"
