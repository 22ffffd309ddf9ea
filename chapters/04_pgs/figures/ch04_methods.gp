# Error against sweeps, one curve for each method.
set terminal svg size 720,460 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator comma
set logscale y
set format y '10^{%L}'
set xlabel 'sweeps' tc rgb '#808080'
set ylabel 'largest error / largest λ' tc rgb '#808080'
set xrange [0:600]; set yrange [1e-10:2]
set label 1 'Jacobi' at 560,0.4 right tc rgb '#AA3377'
set label 2 'Gauss-Seidel' at 470,0.012 right tc rgb '#4477AA'
set label 3 'symmetric' at 595,0.078 right tc rgb '#228833'
set label 4 'SOR, ω = 1.8545' at 165,3e-8 left tc rgb '#EE7733'
set label 5 'conjugate gradients: exact after 20' at 85,2e-3 left tc rgb '#CC3311'
unset key
N = 20.; c = cos(pi / (2 * N)); weight = 2 / (N * N * sin(pi / (2 * N))**2)
plot weight * c**x with lines lw 1.5 lc rgb '#AA3377', \
     weight * c**(2 * x) with lines lw 1.5 lc rgb '#4477AA', \
     data.'/sweeps_jacobi' using 1:4 every 15::1 with points pt 7 ps 0.5 lc rgb '#AA3377', \
     data.'/sweeps_gauss_seidel' using 1:4 every 15::1 with points pt 7 ps 0.5 lc rgb '#4477AA', \
     data.'/sweeps_symmetric' using 1:4 every 15::8 with points pt 7 ps 0.5 lc rgb '#228833', \
     data.'/sweeps_sor' using 1:4 every 6::1 with points pt 7 ps 0.5 lc rgb '#EE7733', \
     data.'/sweeps_cg' using 1:4 every ::1 with points pt 7 ps 0.5 lc rgb '#CC3311'
