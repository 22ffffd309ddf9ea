# Largest error of 1000 steps against the time of one, a point for each scene: two presets, Box2D, Chipmunk.
set terminal svg size 900,760 dynamic enhanced font 'DejaVu Sans,13' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format y '10^{%L}'
set xlabel 'time of a step [µs]' tc rgb '#808080' offset 0,0.4
set ylabel 'largest error of a length or a gap [mm]' tc rgb '#808080'
set yrange [3e-5:3e7]
set ytics 1e-4,100
set key off
set multiplot layout 2,2
kinds = "hanging swinging column triangle"
titles = "'hanging chains of 10, 50, 200' 'swinging chains of 10, 50, 200' 'columns of 10, 20, 50' 'triangles on 10, 20, 40'"
do for [p = 1:4] {
    kind = word(kinds, p)
    set title word(titles, p) tc rgb '#808080'
    if (p <= 2) { set xrange [0.7:100]; set xtics (1, 3, 10, 30, 100) }
    if (p == 3) { set xrange [1.2:100] }
    if (p == 4) { set xrange [8:3000]; set xtics (10, 30, 100, 300, 1000, 3000) }
    if (p == 2) { set key bottom right tc rgb '#808080' samplen 1 font ',11' Left reverse }
    else { set key off }
    plot data.'/engines_'.kind.'_chipmunk' with points pt 13 ps 0.9 lc rgb '#228833' title 'Chipmunk', \
         data.'/engines_'.kind.'_box2d' with points pt 7 ps 0.8 lc rgb '#EE7733' title 'Box2D', \
         data.'/engines_'.kind.'_quick' with points pt 5 ps 0.8 lc rgb '#4477AA' title 'quick: 8 small steps', \
         data.'/engines_'.kind.'_careful' with points pt 9 ps 0.9 lc rgb '#AA3377' title 'careful: 16', \
         data.'/engines_'.kind.'_disorder' with points pt 6 ps 1.6 lc rgb '#808080' title 'discs changed places'
}
unset multiplot
