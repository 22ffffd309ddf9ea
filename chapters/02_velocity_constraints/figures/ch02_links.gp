# N links: one factorisation against rounds of row by row.
set terminal svg size 720,460 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set logscale xy
set logscale x 2
set format y '10^{%L}'
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set xlabel 'number of links N' tc rgb '#808080'
set ylabel 'run time [µs]' tc rgb '#808080'
set key left top Left reverse tc rgb '#808080' samplen 2
set xrange [1.7:700]
plot data.'/row-by-row' using 3:($4 / 1000) with linespoints lw 1.2 pt 5 ps 0.6 lc rgb '#EE7733' \
        title 'row by row, until the error is 10^{-9} of the first', \
     data.'/one-shot' using 3:($4 / 1000) with linespoints lw 1.2 pt 7 ps 0.6 lc rgb '#4477AA' \
        title 'one dense factorisation (error below 10^{-13})', \
     6e-5 * x**3 with lines lw 1.2 dt 2 lc rgb '#808080' title 'slope N^3'
