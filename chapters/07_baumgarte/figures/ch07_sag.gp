# How far a hanging chain sags: many sweeps, or many small steps.
load style
set logscale xy
set xlabel 'sweeps in a step of 1/60 s' tc rgb '#808080'
set ylabel 'largest error of a link [mm]' tc rgb '#808080'
set xrange [0.9:140]; set yrange [1e-3:2e4]
set format y '10^{%L}'
set xtics (1, 2, 4, 8, 16, 32, 64, 128)
unset key
set label 1 'n sweeps, split impulse' at 12,600 left tc rgb '#AA3377'
set label 2 'n sweeps, Baumgarte' at 30,4.5 left tc rgb '#EE7733'
set label 3 'n small steps of one sweep, Baumgarte' at 10,0.07 right tc rgb '#4477AA'
plot for [i = 1:2] data.'/sag_'.word("sweeps small", i) using 1:(1000*$3) with lines lc rgb '#808080', \
     for [i = 1:3] data.'/sag_'.word("sweeps small split", i) using 1:(1000*$2) with points pt 7 ps 0.7 lc rgb word("#EE7733 #4477AA #AA3377", i)
