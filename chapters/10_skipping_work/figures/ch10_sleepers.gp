# Time of a step of a field against the number of its discs: none may sleep, all but a pendulum sleep, all sleep.
set terminal svg size 820,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 1,3
set logscale xy
set format y '10^{%L}'
set xlabel 'discs K' tc rgb '#808080'
set xtics ('0' 0.2, '1' 1, '10' 10, '10^2' 100, '10^3' 1000, '10^4' 10000)
set xrange [0.15:2e4]; set yrange [1e-2:2e4]
set key top left tc rgb '#808080' samplen 1 font ',12' Left reverse
titles = "'none may sleep' 'a pendulum awake, K asleep' 'all asleep'"
kinds = "awake beside sleepers"
do for [p = 1:3] {
    kind = word(kinds, p)
    set title word(titles, p) tc rgb '#808080' font ',14'
    if (p == 1) { set ylabel 'time of a step [µs]' tc rgb '#808080' } else { unset ylabel }
    if (p == 2) { set key } else { unset key }
    if (p == 1) {
        plot data.'/awake_chapter_8' with linespoints pt 7 ps 0.5 lc rgb '#808080' title "chapter 8", \
             data.'/awake_box2d' with linespoints pt 9 ps 0.6 lc rgb '#EE7733' title 'Box2D', \
             data.'/awake_chipmunk' with linespoints pt 5 ps 0.6 lc rgb '#AA3377' title 'Chipmunk', \
             data.'/awake_ours' with linespoints pt 7 ps 0.6 lc rgb '#4477AA' title 'this chapter'
    }
    if (p == 2) {
        plot keyentry with linespoints pt 7 ps 0.5 lc rgb '#808080' title "chapter 8", \
             data.'/beside_box2d' with linespoints pt 9 ps 0.6 lc rgb '#EE7733' title 'Box2D', \
             data.'/beside_chipmunk' with linespoints pt 5 ps 0.6 lc rgb '#AA3377' title 'Chipmunk', \
             data.'/beside_ours' with linespoints pt 7 ps 0.6 lc rgb '#4477AA' title 'this chapter'
    }
    if (p == 3) {
        plot data.'/sleepers_box2d' with linespoints pt 9 ps 0.6 lc rgb '#EE7733' title 'Box2D', \
             data.'/sleepers_chipmunk' with linespoints pt 5 ps 0.6 lc rgb '#AA3377' title 'Chipmunk', \
             data.'/sleepers_ours' with linespoints pt 7 ps 0.6 lc rgb '#4477AA' title 'this chapter'
    }
}
unset multiplot
