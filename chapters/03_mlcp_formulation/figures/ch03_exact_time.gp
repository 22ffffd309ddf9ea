# Run time of the exact ways against the number of rows. Behind an exponent a space is not broken: some viewers swallow a plain one.
load folder.'/style.gp'
set logscale xy
set format y '10^{%L}'
set xlabel 'rows' tc rgb ink
set ylabel 'run time [µs]' tc rgb ink
set xrange [1.7:15000]; set yrange [0.2:1e6]
set key right bottom
plot data.'/enumerate_boxed' using 1:($3/1000) with linespoints pt 9 ps 0.7 lw 1.2 lc rgb red title 'enumeration, 3^n sets', \
     data.'/enumerate_contacts' using 1:($3/1000) with linespoints pt 5 ps 0.6 lw 1.2 lc rgb orange title 'enumeration, 2^n sets', \
     data.'/enumerate_guess' using 1:($3/1000) with linespoints pt 4 ps 0.6 lw 1.2 lc rgb purple title 'enumeration, right guess', \
     data.'/schur' using 1:($3/1000) with linespoints pt 7 ps 0.6 lw 1.2 lc rgb green title 'Schur, 4 contacts, 2^4 sets', \
     data.'/direct' using 1:($3/1000) with linespoints pt 11 ps 0.7 lw 1.2 lc rgb blue title 'direct, no contact'
