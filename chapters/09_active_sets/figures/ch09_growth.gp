# Time of assembly and of the solve against n, with the lines fitted from n = 800 on.
told(text, p) = sprintf("%s: n^{%.2f}", text, p)
line(a, b, x) = exp(a + b * log(x))
fitted(name, column) = sprintf("< awk '$1 >= 799' %s/growth_%s", data, name)
array A[5]; array B[5]
names = "column_upright column_hit chain column_hit column_topples"
do for [k = 1:5] {
    stats fitted(word(names, k), 2) using (log($1)):(log(k == 4 ? $3 : $2)) nooutput
    A[k] = STATS_intercept; B[k] = STATS_slope
}
set terminal svg size 860,480 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format y '10^{%L}'
set xlabel 'rows n' tc rgb '#808080'
set ylabel 'time [µs]' tc rgb '#808080'
set xrange [80:40000]; set yrange [1:1e7]
set key tc rgb '#808080' samplen 1 font ',12' Left reverse top left
plot data.'/growth_column_topples' using 1:2 with points pt 13 ps 0.9 lc rgb '#AA3377' title told('column that topples', B[5]), \
     data.'/growth_column_hit' using 1:2 with points pt 7 ps 0.8 lc rgb '#4477AA' title told('column, hit', B[2]), \
     data.'/growth_chain' using 1:2 with points pt 5 ps 0.7 lc rgb '#228833' title told('chain on hills', B[3]), \
     data.'/growth_column_upright' using 1:2 with points pt 9 ps 0.8 lc rgb '#EE7733' title told('upright column at rest', B[1]), \
     data.'/growth_column_hit' using 1:3 with points pt 6 ps 0.8 lc rgb '#808080' title told('assembly of A, column', B[4]), \
     [x=800:26000] line(A[5], B[5], x) with lines lw 1 lc rgb '#AA3377' notitle, \
     [x=800:26000] line(A[2], B[2], x) with lines lw 1 lc rgb '#4477AA' notitle, \
     [x=800:26000] line(A[3], B[3], x) with lines lw 1 lc rgb '#228833' notitle, \
     [x=800:26000] line(A[1], B[1], x) with lines lw 1 lc rgb '#EE7733' notitle, \
     [x=800:26000] line(A[4], B[4], x) with lines lw 1 lc rgb '#808080' notitle
