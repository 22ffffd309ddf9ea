# Time against n for four programs' exact solvers, all in one process.
set terminal svg size 860,740 dynamic enhanced font 'DejaVu Sans,13' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 2,2
set logscale xy
set format y '10^{%L}'
set xlabel 'rows n' tc rgb '#808080'
set ylabel 'time [µs]' tc rgb '#808080'
set yrange [0.4:6e7]; set xrange [7:3500]
set key tc rgb '#808080' samplen 1 font ',11' Left reverse top left
do for [p = 1:4] {
    problem = word("spd column_hit chain pyramid_hit", p)
    if (p == 1) { set title 'random, positive definite' tc rgb '#808080' }
    if (p == 2) { set title 'column of boxes, hit' tc rgb '#808080'; unset key }
    if (p == 3) { set title 'chain on hills' tc rgb '#808080' }
    if (p == 4) { set title 'pyramid of boxes, hit' tc rgb '#808080'
        set label 1 'hollow: residual above 10^{-8}' at 9,2e7 left tc rgb '#808080' font ',11' }
    plot data.'/versus_'.problem.'_siconos' with linespoints pt 7 ps 0.6 lc rgb '#228833' title "Siconos' Lemke", \
         data.'/versus_'.problem.'_bullet' with linespoints pt 7 ps 0.6 lc rgb '#EE7733' title "Bullet's Dantzig", \
         data.'/versus_'.problem.'_ode' with linespoints pt 7 ps 0.6 lc rgb '#AA3377' title "ODE's Dantzig", \
         data.'/versus_'.problem.'_ours' with linespoints pt 7 ps 0.7 lc rgb '#4477AA' title 'this book', \
         data.'/versus_'.problem.'_siconos_wrong' with points pt 6 ps 0.9 lc rgb '#228833' notitle, \
         data.'/versus_'.problem.'_bullet_wrong' with points pt 6 ps 0.9 lc rgb '#EE7733' notitle, \
         data.'/versus_'.problem.'_ode_wrong' with points pt 6 ps 0.9 lc rgb '#AA3377' notitle, \
         data.'/versus_'.problem.'_polished' with points pt 1 ps 0.8 lc rgb '#AA3377' notitle
}
unset multiplot
