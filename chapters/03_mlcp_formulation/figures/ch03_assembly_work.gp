# Multiplications for A of a chain of N links: pair by pair, and by full matrices. Lines: (3.20).
load folder.'/style.gp'
set logscale xy
set format y '10^{%L}'
set xlabel 'links N' tc rgb ink
set ylabel 'multiplications for A' tc rgb ink
set xrange [7:5000]; set yrange [20:1e11]
set key left top
set samples 200
plot 2*x*x*(x + 1) + 2*x*(x+1) with lines lw 1.5 lc rgb orange title 'full matrices: 2N²(N + 1) + 2N(N + 1)', \
     data.'/assembly_dense' using 1:2 with points pt 5 ps 0.6 lc rgb orange title 'counted', \
     6*x - 2 with lines lw 1.5 lc rgb blue title 'pairs that share a disc: 6N − 2', \
     data.'/assembly_sparse' using 1:2 with points pt 7 ps 0.6 lc rgb blue title 'counted'
