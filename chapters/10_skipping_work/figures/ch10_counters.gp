# Counters of the rain over time.
set terminal svg size 820,620 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator ','
set multiplot layout 2,1
set xrange [0:14]
set key at graph 0.99,0.7 right top tc rgb '#808080' samplen 1 font ',12' Left reverse
set ylabel 'bodies' tc rgb '#808080'
set yrange [0:2500]
plot data.'/rain_no_sleep.csv' every 4::1 using 2:3 with lines lw 1.5 lc rgb '#EE7733' title 'awake, when none may sleep', \
     data.'/rain_skipping.csv' every 4::1 using 2:3 with lines lw 2 lc rgb '#4477AA' title 'awake', \
     data.'/rain_skipping.csv' every 4::1 using 2:4 with lines lw 1.5 lc rgb '#228833' title 'islands'
set logscale y
set yrange [1:3e5]
set key at graph 0.99,0.45 right top
set format y '10^{%L}'
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'in each step' tc rgb '#808080'
plot data.'/rain_no_sleep.csv' every 4::1 using 2:8 with lines lw 1 lc rgb '#EE7733' title 'row visits, when none may sleep', \
     data.'/rain_skipping.csv' every 4::1 using 2:($8 > 0 ? $8 : 1/0) with lines lw 1.5 lc rgb '#4477AA' title 'row visits', \
     data.'/rain_skipping.csv' every 4::1 using 2:($9 > 0 ? $9 : 1/0) with lines lw 1.5 lc rgb '#AA3377' title 'distances computed'
unset multiplot
