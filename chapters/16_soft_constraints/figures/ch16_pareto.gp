# Error against time of a step, by sub-steps 1 … 16, for every method on four scenes.
set terminal svg size 820,760 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 2,2
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'time of a step [µs]' tc rgb '#808080'
set ylabel 'largest error [m]' tc rgb '#808080'
set yrange [5e-10:3]
methods = "hard soft preloaded xpbd bodies exact trees"
colours = "#4477AA #66CCEE #228833 #EE7733 #CC3311 #AA3377 #808080"
do for [p = 1:4] {
    scene = word("pyramid house chain dolls", p)
    if (p == 1) { set title 'pyramid of 10: moved' tc rgb '#808080' }
    if (p == 2) { set title 'house of cards: moved' tc rgb '#808080' }
    if (p == 3) { set title 'chain, 100 times a link: gap' tc rgb '#808080' }
    if (p == 4) { set title 'two dolls on stairs: gap or overlap' tc rgb '#808080' }
    if (p == 3) { set key bottom left tc rgb '#808080' samplen 0.8 font ',11' Left reverse } else { unset key }
    plot for [m = 1:(p == 3 ? 7 : 6)] data.'/'.scene.'_'.word(methods, m) using 1:2 with linespoints lw 1.2 pt 7 ps 0.45 lc rgb word(colours, m) title word(methods, m)
}
unset multiplot
