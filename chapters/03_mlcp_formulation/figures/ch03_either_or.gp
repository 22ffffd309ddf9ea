# Impulse and remaining velocity of a bouncing disc, a dot for each step: all on the corner.
load folder.'/style.gp'
set datafile separator comma
set xlabel 'impulse λ [N s]' tc rgb ink
set ylabel 'w = J u + b [m/s]' tc rgb ink
set xrange [-0.8:7.6]; set yrange [-0.6:6.6]
set key off
set arrow 1 from 0,0 to 0,6.4 nohead lw 5 lc rgb blue back
set arrow 2 from 0,0 to 7.4,0 nohead lw 5 lc rgb blue back
set label 1 'idle: λ = 0, w ≥ 0' at 0.3,5.2 tc rgb blue
set label 2 'at work: w = 0, λ ≥ 0' at 3.4,0.5 tc rgb blue
set label 3 'both: never' at 3.6,3.2 tc rgb ink
plot data.'/bounce.csv' skip 1 using ($3 > 0 ? $4 : NaN):5 with points pt 7 ps 0.9 lc rgb orange
