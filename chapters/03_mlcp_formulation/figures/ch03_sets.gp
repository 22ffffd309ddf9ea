# How many sets of cases a step of the ten discs takes, from the set of the last step on, against all 2^c of them.
load folder.'/style.gp'
set datafile separator comma
set logscale y 10
set format y '10^{%L}'
set xlabel 'time [s]' tc rgb ink
set ylabel 'sets of cases in a step' tc rgb ink
set xrange [0:2.5]; set yrange [0.7:1e7]
set key left top
plot data.'/ten.csv' skip 1 using 2:(2**$3) with lines lw 1 lc rgb orange title 'all there are: 2^c for c contacts', \
     data.'/ten.csv' skip 1 using 2:($5 > 0 ? $5 : NaN) with points pt 7 ps 0.3 lc rgb blue title 'tried'
