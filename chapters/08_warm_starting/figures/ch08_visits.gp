# Error against row visits, three scenes.
set terminal svg size 980,400 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 1,3
set xlabel 'row visits a step / rows' tc rgb '#808080'
set ylabel 'largest error [mm]' tc rgb '#808080'
set logscale xy
set xrange [1.5:300]; set yrange [1e-3:400]
set format y '10^{%L}'
shown(y) = y > 390 ? 390 : y < 0.00102 ? 0.00102 : y
unset key
do for [scene in "column swing triangle"] {
    if (scene eq 'swing') { set key bottom left tc rgb '#808080' samplen 1 spacing 1.1 } else { unset key }
    set title scene eq 'column' ? 'column of 20' : scene eq 'swing' ? 'swinging chain of 10, 10 kg' : 'triangle, base 10' tc rgb '#808080'
    plot data.'/'.scene.'_cold' using 1:(shown($2)) with linespoints pt 7 ps 0.5 lc rgb '#CC3311' title 'cold', \
         data.'/'.scene.'_previous' using 1:(shown($2)) with linespoints pt 7 ps 0.5 lc rgb '#4477AA' title 'previous', \
         data.'/'.scene.'_best_multiple' using 1:(shown($2)) with linespoints pt 7 ps 0.5 lc rgb '#228833' title 'best multiple', \
         data.'/'.scene.'_substeps' using 1:(shown($2)) with linespoints pt 7 ps 0.5 lc rgb '#AA3377' title 'small steps'
}
unset multiplot
