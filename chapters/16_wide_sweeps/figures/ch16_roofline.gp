# Gflop/s against flops a byte: what memory and arithmetic allow, and what each way of sweeping reaches.
set terminal svg size 720,460 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set xlabel 'flops a byte' tc rgb '#808080'
set ylabel 'Gflop/s' tc rgb '#808080'
set xrange [0.05:10]
set yrange [1:300]
set key outside top center horizontal tc rgb '#808080' samplen 1.5
band(n) = real(system(sprintf("awk 'NR == %d { print $2 }' '%s/bandwidth'", n, data)))
peak(way) = real(system(sprintf("awk '$1 == \"%s\" { print $2 }' '%s/flops'", way, data)))
min(a, b) = a < b ? a : b
ways = "given rows bundles doubles floats"
colours = "#4477AA #66CCEE #228833 #EE7733 #AA3377"
near = band(1); far = band(4); second = band(2)
one = peak('one'); doubles = peak('doubles'); floats = peak('floats')
set label 1 'first cache' at 0.055, 0.055 * near * 1.25 tc rgb '#808080' font ',11'
set label 2 'memory' at 0.12, 0.12 * far * 0.7 tc rgb '#808080' font ',11'
set label 3 'one number at a time' at 1.6, one * 1.2 tc rgb '#808080' font ',11'
set label 4 'doubles' at 4, doubles * 1.2 tc rgb '#808080' font ',11'
set label 5 'floats' at 4, floats * 1.2 tc rgb '#808080' font ',11'
plot min(near * x, floats) with lines lw 1 lc rgb '#808080' notitle, \
     min(second * x, doubles) with lines lw 1 dt 2 lc rgb '#808080' notitle, \
     min(far * x, one) with lines lw 1 dt 3 lc rgb '#808080' notitle, \
     for [m = 1:5] data.'/roof_'.word(ways, m) using 1:2 with points pt 7 ps 0.7 lc rgb word(colours, m) title word(ways, m)
