# The impulse of the floor on a rod against the sweeps of a step, for two coefficients of friction.
set terminal svg size 720,360 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator ','
set xlabel 'sweeps' tc rgb '#808080'
set ylabel 'λ_n [N s]' tc rgb '#808080'
set key outside top center horizontal tc rgb '#808080' samplen 1.5
set xrange [0.5:16.5]
set yrange [-0.02:0.7]
c = 0.625
answer(mu) = c / (1 + 0.75 * mu)
set arrow from graph 0, first answer(1.6) to graph 1, first answer(1.6) nohead lc rgb '#CC3311' dt 3
set arrow from graph 0, first answer(1.2) to graph 1, first answer(1.2) nohead lc rgb '#4477AA' dt 3
plot data.'/mu1.6' using 1:2 with linespoints pt 7 ps 0.7 lw 1.6 lc rgb '#CC3311' title 'μ = 1.6', \
     data.'/mu1.2' using 1:2 with linespoints pt 7 ps 0.7 lw 1.6 lc rgb '#4477AA' title 'μ = 1.2'
