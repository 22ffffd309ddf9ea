# Error against time [µs] for every method on four problems.
set terminal svg size 820,720 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 2,2
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xlabel 'time [µs]' tc rgb '#808080'
set ylabel 'largest error / largest λ' tc rgb '#808080'
set yrange [1e-12:3]
set key tc rgb '#808080' samplen 0.8 font ',11' Left reverse
methods = "jacobi gauss_seidel symmetric sor cg"
names = "Jacobi Gauss-Seidel symmetric SOR CG"
colours = "#AA3377 #4477AA #228833 #EE7733 #CC3311"
do for [p = 1:4] {
    problem = word("column chain mass_ratio ten_discs", p)
    if (p == 1) { set title 'column: 20 equal discs' tc rgb '#808080' }
    if (p == 2) { set title 'chain: 40 links, end of 100 kg' tc rgb '#808080' }
    if (p == 3) { set title '1000 kg on 1 kg' tc rgb '#808080' }
    if (p == 4) { set title 'the ten discs, 22 rows' tc rgb '#808080' }
    if (p == 2) { set key at graph 1.09, graph 0.42 } else { unset key }
    plot for [m = 1:(p == 4 ? 4 : 5)] data.'/'.problem.'_'.word(methods, m) using ($4/1000):3 with linespoints lw 1.2 pt 7 ps 0.35 lc rgb word(colours, m) title word(names, m)
}
unset multiplot
