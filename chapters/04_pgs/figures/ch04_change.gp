# Error, residual and change against sweeps.
set terminal svg size 720,460 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator comma
set logscale y
set format y '10^{%L}'
set xlabel 'sweeps' tc rgb '#808080'
set ylabel 'error / largest λ,   residual and change [m/s]' tc rgb '#808080'
set xrange [1:600]; set yrange [1e-6:2]
set key at graph 0.98, graph 0.42 right tc rgb '#808080' samplen 1.5 spacing 1.1
plot data.'/sweeps_gauss_seidel' using 1:4 every 12::1 with points pt 7 ps 0.5 lc rgb '#4477AA' title 'ω = 1: error', \
     data.'/sweeps_gauss_seidel' using 1:6 every 12::1 with points pt 7 ps 0.5 lc rgb '#EE7733' title 'residual', \
     data.'/sweeps_gauss_seidel' using 1:7 every 12::1 with points pt 7 ps 0.5 lc rgb '#228833' title 'change', \
     data.'/sweeps_under' using 1:4 every 12::7 with points pt 6 ps 0.6 lc rgb '#4477AA' title 'ω = 0.05: error', \
     data.'/sweeps_under' using 1:6 every 12::7 with points pt 6 ps 0.6 lc rgb '#EE7733' title 'residual', \
     data.'/sweeps_under' using 1:(0.05 * $7) every 12::7 with points pt 6 ps 0.6 lc rgb '#228833' title 'A_{ii} |Δλ|'
