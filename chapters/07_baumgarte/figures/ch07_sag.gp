# How far a hanging chain sags: many sweeps, or many small steps.
load style
set logscale xy
set xlabel 'sweeps in a step of 1/60 s' tc rgb '#808080'
set ylabel 'largest error of a link [mm]' tc rgb '#808080'
set xrange [0.9:140]; set yrange [1e-3:2e4]
set format y '10^{%L}'
set xtics (1, 2, 4, 8, 16, 32, 64, 128)
set key bottom left Left reverse
names = "'n sweeps, Baumgarte' 'n small steps of one sweep, Baumgarte' 'n sweeps, split impulse'"
plot for [i = 1:3] data.'/sag_'.word("sweeps small split", i) using 1:(1000*$3) with lines lc rgb '#808080' notitle, \
     for [i = 1:3] data.'/sag_'.word("sweeps small split", i) using 1:(1000*$2) with points pt 7 ps 0.7 lc rgb word("#EE7733 #4477AA #AA3377", i) title word(names, i)
