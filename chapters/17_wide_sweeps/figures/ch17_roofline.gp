# Gflop/s against flops a byte: what memory and arithmetic allow, and what each way of sweeping reaches.
set terminal svg size 720,460 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set xlabel 'flops a byte' tc rgb '#808080'
set ylabel 'Gflop/s' tc rgb '#808080'
set xrange [0.003:10]
set yrange [1:300]
set key outside top center horizontal tc rgb '#808080' samplen 1.5
band(n) = system(sprintf("awk 'NR == %d { print $2 }' '%s/bandwidth'", n, data)) + 0
peak(way) = system(sprintf("awk '$1 == \"%s\" { print $2 }' '%s/flops'", way, data)) + 0
min(a, b) = a < b ? a : b
ways = "given rows bundles doubles floats"
colours = "#4477AA #66CCEE #228833 #EE7733 #AA3377"
one = peak('one'); doubles = peak('doubles'); floats = peak('floats')
names = "'first cache' 'second cache' 'third cache' memory"
do for [k = 1:4] { set label k word(names, k) at (k < 4 ? 1.2 : 1.9) / band(k), 1.35 rotate by 42 tc rgb '#808080' font ',11' }
set label 5 'one number at a time' at 1.2, one * 1.2 tc rgb '#808080' font ',11'
set label 6 'doubles' at 1.2, doubles * 1.2 tc rgb '#808080' font ',11'
set label 7 'floats' at 1.2, floats * 1.2 tc rgb '#808080' font ',11'
plot for [k = 1:4] min(band(k) * x, floats) with lines lw 1 lc rgb '#808080' notitle, \
     one with lines lw 1 dt 3 lc rgb '#808080' notitle, \
     doubles with lines lw 1 dt 3 lc rgb '#808080' notitle, \
     for [m = 1:5] data.'/roof_'.word(ways, m) using 1:2 with points pt 7 ps 0.7 lc rgb word(colours, m) title word(ways, m)
