# Speed of each wave over that of the exact wave, C = 0.8: curves by the closed forms, dots from the steps.
set terminal svg size 720,440 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator ','
set xlabel 'k Δx / π   (1: two intervals long)' tc rgb '#808080'
set ylabel 'speed / speed of the exact wave' tc rgb '#808080'
set key bottom left tc rgb '#808080' samplen 1.5 Left reverse
set xrange [0:1]
set yrange [0.5:1.03]
C = 0.8
leap(x) = x == 0 ? 1 : 2*asin(C*sin(pi*x/2))/(C*pi*x)
trap(x) = x == 0 ? 1 : 2*atan(C*sin(pi*x/2))/(C*pi*x)
d = data.'/dispersion'
plot 1 lw 1.4 lc rgb '#228833' notitle, leap(x) lw 1.4 lc rgb '#4477AA' notitle, trap(x) lw 1.4 lc rgb '#CC3311' notitle, \
     d using "kdx":"sines" with points pt 7 ps 0.5 lc rgb '#228833' title 'sines', \
     d using "kdx":"leapfrog" with points pt 7 ps 0.5 lc rgb '#4477AA' title 'leapfrog', \
     d using "kdx":"trapezoidal" with points pt 7 ps 0.5 lc rgb '#CC3311' title 'trapezoidal'
