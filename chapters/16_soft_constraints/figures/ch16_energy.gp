# Energy of an undamped spring against time, for three frequencies, in steps of 1/60 s; lines by the closed form.
set terminal svg size 720,420 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator ','
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'part of the energy that is left' tc rgb '#808080'
set key outside top center horizontal tc rgb '#808080' samplen 1.5
set logscale y
set format y '10^{%T}'
set yrange [1e-4:2]
set xrange [0:2]
kept(f, t) = (1 + (2*pi*f/60)**2)**(-60*t)
start(f) = 0.5*(2*pi*f)**2*0.25
plot kept(0.5, x) lw 1.6 lc rgb '#4477AA' notitle, kept(2, x) lw 1.6 lc rgb '#EE7733' notitle, \
     kept(30, x) lw 1.6 lc rgb '#228833' notitle, \
     data.'/spring0.5' using 2:($5/start(0.5)) every 6 with points pt 7 ps 0.6 lc rgb '#4477AA' title '0.5 Hz', \
     data.'/spring2' using 2:($5/start(2)) every 6 with points pt 7 ps 0.6 lc rgb '#EE7733' title '2 Hz', \
     data.'/spring30' using 2:($5/start(30)) with points pt 7 ps 0.6 lc rgb '#228833' title '30 Hz'
