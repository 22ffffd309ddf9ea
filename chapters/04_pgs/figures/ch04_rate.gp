# Sweeps for one more digit, theory and measurement.
set terminal svg size 720,460 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format y '10^{%L}'
set xlabel 'N, rows in the line' tc rgb '#808080'
set ylabel 'sweeps for one more digit' tc rgb '#808080'
set xrange [1.8:50]; set yrange [1:3e6]
set xtics (2, 3, 5, 10, 20, 40)
unset key
set samples 200
# tan t tan (N-1)t = 1/R, by bisection between 0 and pi / 2(N-1)
f(N, R, lo, hi, k) = k == 0 ? (lo + hi) / 2 : tan((lo + hi) / 2) * tan((N - 1) * (lo + hi) / 2) < 1. / R ? f(N, R, (lo + hi) / 2, hi, k - 1) : f(N, R, lo, (lo + hi) / 2, k - 1)
theta(N, R) = f(N, R, 0., pi / (2 * (N - 1)), 60)
digits(N, R) = -log(10) / (2 * log(cos(theta(N, R))))
set label 1 'R = 1' at 6,9 left tc rgb '#4477AA'
set label 2 'R = 10' at 3.1,110 left tc rgb '#228833'
set label 3 'R = 100' at 6,450 left tc rgb '#EE7733'
set label 4 'R = 1000' at 6,4.5e3 left tc rgb '#CC3311'
plot digits(x, 1) with lines lw 1.5 lc rgb '#4477AA', digits(x, 10) with lines lw 1.5 lc rgb '#228833', \
     digits(x, 100) with lines lw 1.5 lc rgb '#EE7733', digits(x, 1000) with lines lw 1.5 lc rgb '#CC3311', \
     data.'/rate_1' using 1:(-log(10) / log($2)) with points pt 7 ps 0.7 lc rgb '#4477AA', \
     data.'/rate_10' using 1:(-log(10) / log($2)) with points pt 7 ps 0.7 lc rgb '#228833', \
     data.'/rate_100' using 1:(-log(10) / log($2)) with points pt 7 ps 0.7 lc rgb '#EE7733', \
     data.'/rate_1000' using 1:(-log(10) / log($2)) with points pt 7 ps 0.7 lc rgb '#CC3311'
