# Error of the position against time of a step, by sub-steps, for every method on three scenes.
set terminal svg size 820,900 dynamic enhanced font 'DejaVu Sans,18' linewidth 1.4
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 2,2
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'time of a step [µs]' tc rgb '#808080'
set ylabel 'way to the reference [m]' tc rgb '#808080'
set xrange [5:1e5]; set yrange [1e-6:2]
set xtics 10; set ytics 10
methods = "small threads xpbd particles augmented projective implicit newton midpoint explicit exact"
colours = "#4477AA #CC3311 #66CCEE #228833 #99CC55 #CCBB44 #EE7733 #AA3377 #332288 #808080 #88CCAA"
# Bullet's two kinds of cloth, on the sheet, where they were measured
peers = system("cd '".data."' && ls sheet_bt_soft sheet_bt_deformable_1 2>/dev/null | sed 's/sheet_//' | tr '\\n' ' '")
do for [p = 1:3] {
    scene = word("sheet strip flag", p)
    if (p == 1) { set title 'sheet on two corners' tc rgb '#808080' }
    if (p == 2) { set title 'strip' tc rgb '#808080' }
    if (p == 3) { set title 'flag' tc rgb '#808080' }
    if (p == 3) { set key at graph 1.5, graph 0.95 left top tc rgb '#808080' samplen 0.8 Left reverse } else { unset key }
    if (p == 1 && words(peers) > 0) {
        set key bottom left tc rgb '#808080' samplen 0.8 Left reverse
        plot for [m = 1:11] data.'/'.scene.'_'.word(methods, m) using 1:2 with linespoints lw 1.2 pt 7 ps 0.55 lc rgb word(colours, m) notitle, \
             for [m = 1:words(peers)] data.'/sheet_'.word(peers, m) using 1:2 with linespoints lw 1.2 dt 2 pt (3 + m) ps 0.5 lc rgb '#808080' title (word(peers, m) eq 'bt_soft' ? 'Bullet, rows' : 'Bullet, implicit')
    } else {
        plot for [m = 1:11] data.'/'.scene.'_'.word(methods, m) using 1:2 with linespoints lw 1.2 pt 7 ps 0.55 lc rgb word(colours, m) title word(methods, m)
    }
}
unset multiplot
