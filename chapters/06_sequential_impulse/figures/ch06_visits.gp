# What a visit costs in each order, against the number of rows.
set terminal svg size 820,640 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 2,2
set logscale x
set format x '10^{%L}'
set xlabel 'rows' tc rgb '#808080'
set ylabel 'ns a row visit' tc rgb '#808080'
set xrange [200:15000]; set yrange [0:18]
methods = "given alternating shuffled coloured blocks"
colours = "#4477AA #AA3377 #EE7733 #228833 #CC3311"
do for [p = 1:4] {
    scene = word("column chain triangle walls", p)
    set title scene tc rgb '#808080'
    if (p == 3) { set key top left tc rgb '#808080' samplen 1 font ',11' maxrows 3 } else { unset key }
    if (p < 4) {
        plot 5 with lines dt 2 lc rgb '#808080' notitle, for [k = 1:5] data.'/visit_'.scene using 1:(column(k + 1)) with linespoints lw 1.2 pt 7 ps 0.5 lc rgb word(colours, k) title word(methods, k)
    } else {
        set label 1 'coloured, the world in memory' at 12000,9.8 right tc rgb '#228833' font ',11'
        plot 5 with lines dt 2 lc rgb '#808080' notitle, for [k = 1:5] data.'/visit_'.scene using 1:(column(k + 1)) with linespoints lw 1.2 pt 7 ps 0.5 lc rgb word(colours, k), data.'/visit_'.scene using 1:7 with linespoints dt 3 lw 1.2 pt 6 ps 0.5 lc rgb '#228833'
    }
}
unset multiplot
