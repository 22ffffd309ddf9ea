# Time against n for three programs' Lemke, all in one process.
set terminal svg size 900,380 dynamic enhanced font 'DejaVu Sans,13' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 1,3
set logscale xy
set format y '10^{%L}'
set xlabel 'rows n' tc rgb '#808080'
set ylabel 'time [µs]' tc rgb '#808080'
set yrange [3:1e7]; set xrange [20:450]
set xtics (30, 100, 300)
set key tc rgb '#808080' samplen 1 font ',11' Left reverse top left
do for [p = 1:3] {
    problem = word("spd column friction", p)
    if (p == 1) { set title 'random, positive definite' tc rgb '#808080' }
    if (p == 2) { set title 'column of boxes' tc rgb '#808080' }
    if (p == 3) { set title 'boxes with friction' tc rgb '#808080'; set xtics (40, 80, 160, 320) }
    if (p == 3) { set label 1 'hollow: wrong answer' at 24,2e6 left tc rgb '#808080' font ',11'; unset key }
    if (p == 2) { unset key }
    plot data.'/versus_'.problem.'_bullet' with linespoints pt 7 ps 0.6 lc rgb '#EE7733' title 'Bullet', \
         data.'/versus_'.problem.'_siconos' with linespoints pt 7 ps 0.6 lc rgb '#228833' title 'Siconos', \
         data.'/versus_'.problem.'_lemke' with linespoints pt 7 ps 0.6 lc rgb '#4477AA' title 'this book', \
         data.'/versus_'.problem.'_bullet_wrong' with points pt 6 ps 0.8 lc rgb '#EE7733' notitle, \
         data.'/versus_'.problem.'_siconos_wrong' with points pt 6 ps 0.8 lc rgb '#228833' notitle
}
unset multiplot
