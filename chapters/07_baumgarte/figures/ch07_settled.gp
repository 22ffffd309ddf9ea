# Where the bead settles beside its wire.
load style
set logscale y
set xlabel 'β' tc rgb '#808080'
set ylabel 'settled distance from the wire [mm]' tc rgb '#808080'
set xrange [0:2]; set yrange [0.02:100]
settled(b, s) = sqrt(1 + 2*s*s / (b + sqrt(b*b + 4*(b - b*b/4)*s*s))) - 1
set samples 400
unset key
set label 1 'h = 0.05 s' at 1.95,1.2 right tc rgb '#EE7733'
set label 2 'h = 0.02 s' at 1.95,0.19 right tc rgb '#228833'
set label 3 'h = 0.01 s' at 1.95,0.045 right tc rgb '#4477AA'
plot for [i = 1:3] [0.02:2] 1000*settled(x, word("0.05 0.02 0.01", i) + 0) with lines lc rgb '#808080', \
     for [i = 1:3] data.'/settled_'.word("0.05 0.02 0.01", i) using 1:(1000*$2) with points pt 7 ps 0.6 lc rgb word("#EE7733 #228833 #4477AA", i)
