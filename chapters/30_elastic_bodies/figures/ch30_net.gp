# Left: error of a sheet's sag against the time of a step, elements beside springs. Right: a beam of tetrahedra beside Bullet's.
set terminal svg size 820,460 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 1,2
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set key bottom left tc rgb '#808080' samplen 0.8 font ',11' Left reverse
set xlabel 'time of a step [µs]' tc rgb '#808080'
set ylabel 'error of the sag' tc rgb '#808080'
set xrange [10:1e6]
set yrange [1e-9:10]
set title 'a sheet, 320 triangles' tc rgb '#808080'
plot data.'/net_xpbd' using 1:2 with linespoints lw 1.2 pt 7 ps 0.5 lc rgb '#EE7733' title 'XPBD', \
     data.'/net_vbd' using 1:2 with linespoints lw 1.2 pt 5 ps 0.5 lc rgb '#CC3311' title 'VBD', \
     data.'/net_projective' using 1:2 with linespoints lw 1.2 pt 9 ps 0.6 lc rgb '#AA3377' title 'projective', \
     data.'/net_springs_newton' using 1:2 with points pt 13 ps 0.6 lc rgb '#808080' title 'springs, Newton', \
     data.'/net_linear_direct' using 1:2 with linespoints lw 1.2 pt 7 ps 0.5 lc rgb '#66CCEE' title 'linear law, factor', \
     data.'/net_corotational_direct' using 1:2 with linespoints lw 1.2 pt 7 ps 0.5 lc rgb '#4477AA' title 'corotational, factor', \
     data.'/net_corotational_cg' using 1:2 with linespoints lw 1.2 pt 7 ps 0.5 lc rgb '#228833' title 'corotational, CG'
set xlabel 'time of half a second [ms]' tc rgb '#808080'
set ylabel 'error of the tip' tc rgb '#808080'
set xrange [5:20000]
set yrange [1e-7:1]
set title 'a beam, 480 tetrahedra' tc rgb '#808080'
plot data.'/beam_corotational_euler_direct' using 1:2 with linespoints lw 1.2 pt 7 ps 0.5 lc rgb '#66CCEE' title 'corotational, Euler', \
     data.'/beam_corotational_midpoint_direct' using 1:2 with linespoints lw 1.2 pt 7 ps 0.5 lc rgb '#4477AA' title 'corotational, midpoint', \
     data.'/beam_corotational_midpoint_cg' using 1:2 with linespoints lw 1.2 pt 7 ps 0.5 lc rgb '#228833' title 'the same by CG', \
     data.'/beam_bullet_corotational_1' using 1:2 with linespoints lw 1.2 pt 5 ps 0.5 lc rgb '#EE7733' title 'Bullet, one iteration', \
     data.'/beam_bullet_corotational_10' using 1:2 with linespoints lw 1.2 pt 9 ps 0.6 lc rgb '#CC3311' title 'Bullet, up to ten'
unset multiplot
