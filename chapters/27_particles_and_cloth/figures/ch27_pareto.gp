# Error of the position against time of a step, by sub-steps, for every method on four scenes.
set terminal svg size 820,760 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 2,2
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'time of a step [µs]' tc rgb '#808080'
set ylabel 'way to the reference [m]' tc rgb '#808080'
set xrange [5:1e5]; set yrange [1e-5:2]
methods = "small threads xpbd particles projective implicit newton midpoint explicit exact"
colours = "#4477AA #CC3311 #66CCEE #228833 #CCBB44 #EE7733 #AA3377 #332288 #808080 #88CCAA"
do for [p = 1:4] {
    scene = word("sheet strip flag ball", p)
    if (p == 1) { set title 'sheet on two corners' tc rgb '#808080' }
    if (p == 2) { set title 'strip' tc rgb '#808080' }
    if (p == 3) { set title 'flag' tc rgb '#808080' }
    if (p == 4) { set title 'sheet on a ball' tc rgb '#808080' }
    if (p == 4) { set key at graph 0.03, graph 0.62 left top tc rgb '#808080' samplen 0.8 spacing 0.85 font ',11' Left reverse } else { unset key }
    plot for [m = 1:(p == 4 ? 10 : 9)] data.'/'.scene.'_'.word(methods, m) using 1:2 with linespoints lw 1.2 pt 7 ps 0.45 lc rgb word(colours, m) title word(methods, m)
}
unset multiplot
