# Errors over thousands of Kepler periods at 1200 force evaluations a period.
size_x = 860; size_y = 430
load folder.'/style.gp'
set logscale xy
set format y "10^{%L}"; set format x "10^{%L}"
set xrange [0.8:6000]
set xlabel "periods"
rows(name) = sprintf("< grep '^%s,' %s", name, data)
set multiplot layout 1,2 margins 0.10,0.98,0.27,0.97 spacing 0.13,0.1
set ylabel "largest error in position [semi-axes]"
set yrange [1e-9:10]; set ytics 100
unset key
set label 1 "∝ t" at 300, 0.008 textcolor rgb ink; set label 2 "∝ t²" at 60, 3e-7 textcolor rgb ink
plot for [i=1:6] rows(word(methods,i)) using 3:4 with linespoints lw 1 pt points[i] ps 0.6 lc rgb word(colours,i) title word(titles,i)
unset label 1; unset label 2
set ylabel "largest relative error in energy"
set yrange [1e-10:10]
set key at screen 0.5, 0.06 center maxrows 2 maxcols 3
plot for [i=1:6] rows(word(methods,i)) using 3:5 with linespoints lw 1 pt points[i] ps 0.6 lc rgb word(colours,i) title word(titles,i)
unset multiplot
