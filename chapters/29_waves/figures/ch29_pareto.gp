# Error of a bell on a string after a period against the time of the whole run, a curve for each method.
set terminal svg size 720,460 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'time of the run [µs]' tc rgb '#808080'
set ylabel 'largest error [m]' tc rgb '#808080'
set key outside top center horizontal maxcols 3 tc rgb '#808080' samplen 1 font ',12'
methods = "leapfrog_half leapfrog_one trapezoidal_one trapezoidal_four implicit sines"
titles = "'leapfrog, C = ½' 'leapfrog, C = 1' 'trapezoidal, C = 1' 'trapezoidal, C = 4' 'implicit Euler, C = 1' 'sines, one step'"
colours = "#4477AA #66CCEE #CC3311 #EE7733 #AA3377 #228833"
plot for [m = 1:6] data.'/'.word(methods, m) using 1:2 with linespoints lw 1.2 pt 7 ps 0.5 lc rgb word(colours, m) title word(titles, m)
