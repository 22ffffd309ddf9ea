# Assembly of A for a chain of N links: run time.
load folder.'/style.gp'
set logscale xy
set format y '10^{%L}'
set xlabel 'links N' tc rgb ink
set ylabel 'run time [µs]' tc rgb ink
set xrange [7:5000]; set yrange [0.05:1e7]
set key left top
plot data.'/assembly_dense' using 1:($3/1000) with linespoints pt 5 ps 0.6 lw 1.2 lc rgb orange title 'full matrices', \
     data.'/assembly_sparse' using 1:($3/1000) with linespoints pt 7 ps 0.6 lw 1.2 lc rgb blue title 'pairs that share a disc', \
     data.'/assembly_dense' using ($1 > 90 ? $1 : NaN):($1**3*3e-5) with lines dt 2 lw 1 lc rgb ink title 'slopes 3 and 1', \
     data.'/assembly_sparse' using ($1 > 90 ? $1 : NaN):($1*1e-2) with lines dt 2 lw 1 lc rgb ink notitle
