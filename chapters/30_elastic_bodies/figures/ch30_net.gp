# Left: error of a sheet's sag against the time of a step, elements beside springs. Right: a beam of tetrahedra beside Bullet's.
set terminal svg size 820,740 dynamic enhanced font 'DejaVu Sans,19' linewidth 1.4
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot
set size 0.5,0.6
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
unset key
sheet = "xpbd vbd projective springs_newton linear_direct corotational_direct corotational_cg"
sheet_names = "'XPBD' 'VBD' 'projective' 'springs, Newton' 'linear law, factor' 'corotational, factor' 'corotational, CG'"
sheet_colours = "#EE7733 #CC3311 #AA3377 #808080 #66CCEE #4477AA #228833"
beam = "corotational_euler_direct corotational_midpoint_direct corotational_midpoint_cg bullet_corotational_1 bullet_corotational_10"
beam_names = "'corotational, Euler' 'corotational, midpoint' 'the same by CG' 'Bullet, one iteration' 'Bullet, up to ten'"
beam_colours = "#66CCEE #4477AA #228833 #EE7733 #CC3311"
set origin 0,0.4
set xlabel 'time of a step [µs]' tc rgb '#808080'
set ylabel 'error of the sag' tc rgb '#808080'
set xtics 100; set ytics 100
set xrange [10:1e6]
set yrange [1e-9:10]
set title 'a sheet, 320 triangles' tc rgb '#808080'
plot for [m = 1:7] data.'/net_'.word(sheet, m) using 1:2 with linespoints lw 1.3 pt 7 ps 0.6 lc rgb word(sheet_colours, m)
set origin 0.5,0.4
set xlabel 'time of half a second [ms]' tc rgb '#808080'
set ylabel 'error of the tip' tc rgb '#808080'
set xtics 10
set xrange [5:20000]
set yrange [1e-7:1]
set title 'a beam, 480 tetrahedra' tc rgb '#808080'
plot for [m = 1:5] data.'/beam_'.word(beam, m) using 1:2 with linespoints lw 1.3 pt 7 ps 0.6 lc rgb word(beam_colours, m)
# the lower row is the key
unset title; unset xlabel; unset ylabel; unset tics; unset border; unset logscale
set xrange [0:1]; set yrange [0:1]
set size 0.5,0.4
set key center center tc rgb '#808080' samplen 1.2 Left reverse
set origin 0,0
plot for [m = 1:7] NaN with linespoints lw 1.3 pt 7 ps 0.7 lc rgb word(sheet_colours, m) title word(sheet_names, m)
set origin 0.5,0
plot for [m = 1:5] NaN with linespoints lw 1.3 pt 7 ps 0.7 lc rgb word(beam_colours, m) title word(beam_names, m)
unset multiplot
