# Error against what it costs, for every way on four problems. `column` and `cost` say which cost.
load style
set terminal svg size 820,820 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set multiplot layout 2,2 margins 0.1,0.98,0.23,0.94 spacing 0.13,0.16
set logscale xy
unset key
set datafile separator whitespace
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel cost tc rgb '#808080'
set ylabel 'error [mm]' tc rgb '#808080'
set yrange [1e-2:2e4]
ways = "none baumgarte relaxation split_impulse projection small_baumgarte small_relaxation small_projection"
names = "none Baumgarte relaxation 'split impulse' projection 'small steps, Baumgarte' 'small steps, relaxation' 'small steps, projection'"
colours = "#808080 #EE7733 #228833 #AA3377 #CCBB44 #4477AA #66CCEE #CC3311"
do for [w = 1:8] { set label w '• '.word(names, w) at screen 0.1 + 0.3 * ((w - 1) / 3), 0.105 - 0.033 * ((w - 1) % 3) left tc rgb word(colours, w) }
do for [p = 1:4] {
    problem = word("chain column swing ten_discs", p)
    if (p == 1) { set title 'hanging chain: 20 links, end of 10 kg' tc rgb '#808080' }
    if (p == 2) { set title 'column of 20' tc rgb '#808080'; unset label }
    if (p == 3) { set title 'swinging chain of 10: its end after 1 s' tc rgb '#808080' }
    if (p == 4) { set title 'ten discs' tc rgb '#808080' }
    plot for [w = 1:8] data.'/'.problem.'_'.word(ways, w) using column:3 with linespoints lw 1.2 pt 7 ps 0.35 lc rgb word(colours, w)
}
unset multiplot
