# Pivots against the number of rows: the easy families and the exponential ones.
set terminal svg size 760,480 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale y
set xlabel 'rows n' tc rgb '#808080'
set ylabel 'pivots' tc rgb '#808080'
set xrange [0:47]; set yrange [1:8000]
set key right top tc rgb '#808080' samplen 1 font ',12' Left reverse
set label 1 '2^n' at 9.6,1800 right tc rgb '#808080'
set label 2 '2n' at 41,80 left tc rgb '#808080'
set label 3 'n + 1' at 41,41 left tc rgb '#808080'
set label 4 '2' at 41,2 left tc rgb '#808080'
plot [x=0:47] x <= 12.6 ? 2**x : 1/0 with lines lc rgb '#808080' notitle, \
     x <= 40 ? 2*x : 1/0 with lines lc rgb '#808080' notitle, \
     x <= 40 ? x+1 : 1/0 with lines lc rgb '#808080' notitle, \
     x <= 40 ? 2 : 1/0 with lines lc rgb '#808080' notitle, \
     data.'/pivots_murty' with points pt 7 ps 0.9 lc rgb '#CC3311' title 'Murty', \
     data.'/pivots_transposed' with points pt 6 ps 1.2 lc rgb '#EE7733' title 'its transpose, lexicographic', \
     data.'/pivots_fathi' with points pt 2 ps 1.0 lw 2 lc rgb "#4477AA" title 'Fathi, lexicographic', \
     data.'/pivots_transposed_last' with points pt 5 ps 0.6 lc rgb '#EE7733' title 'the transpose, last row first', \
     data.'/pivots_transposed_first' with points pt 9 ps 0.7 lc rgb '#EE7733' title 'the transpose, first row first', \
     data.'/pivots_column' with points pt 7 ps 0.6 lc rgb '#4477AA' title 'column of discs', \
     data.'/pivots_spd' with points pt 13 ps 0.8 lc rgb '#228833' title 'random, positive definite'
