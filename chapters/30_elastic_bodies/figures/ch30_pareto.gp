# Error of the tip of a strip against the time of half a second, for laws, rules and solvers.
set terminal svg size 820,640 dynamic enhanced font 'DejaVu Sans,19' linewidth 1.4
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot
set size 0.5,0.7
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xrange [0.2:300]
set xlabel 'time of half a second [ms]' tc rgb '#808080'
set ylabel 'error over the way of the tip' tc rgb '#808080'
set yrange [5e-5:1.5]
set ytics 10; set xtics 10
unset key
methods = "linear_euler_direct linear_midpoint_direct linear_midpoint_cg corotational_euler_direct corotational_midpoint_direct corotational_midpoint_cg neo_hookean_midpoint_direct linear_modal_exact"
names = "'linear, Euler' 'linear, midpoint' 'the same by CG' 'corotational, Euler' 'corotational, midpoint' 'the same by CG' 'neo-Hookean, midpoint' 'twenty vibrations'"
colours = "#EE7733 #CC3311 #AA3377 #66CCEE #4477AA #BBCC33 #228833 #808080"
do for [p = 1:2] {
    scene = word("light heavy", p)
    set title (p == 1 ? 'falls by a hundredth' : 'falls by nearly half') tc rgb '#808080'
    set origin 0.5 * (p - 1),0.3
    if (p == 2) { unset ylabel }
    plot for [m = 1:8] data.'/'.scene.'_'.word(methods, m) using 1:2 with linespoints lw 1.3 pt 7 ps 0.6 lc rgb word(colours, m)
}
# the lower row is the key
unset title; unset xlabel; unset ylabel; unset tics; unset border; unset logscale
set xrange [0:1]; set yrange [0:1]
set size 1,0.3; set origin 0,0
set key center center maxrows 4 tc rgb '#808080' samplen 1.2 Left reverse
plot for [m = 1:8] NaN with linespoints lw 1.3 pt 7 ps 0.7 lc rgb word(colours, m) title word(names, m)
unset multiplot
