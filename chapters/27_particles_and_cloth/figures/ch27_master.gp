# Height over width of a strip against its load, by each model of bending, and the elastica; left its weight, right a load at
# its end.
set terminal svg size 820,480 dynamic enhanced font 'DejaVu Sans,18' linewidth 1.4
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set multiplot layout 1,2
set logscale xy
set xrange [0.08:12.5]; set yrange [0.01:4]
set format '%g'
models = "lines angles angles_rise across"
names = "'lines and twists' 'angles, alternate' 'angles, rise' 'springs across'"
colours = "#4477AA #EE7733 #CC3311 #AA3377"
set ylabel 'height / width of its end' tc rgb '#808080'
do for [side in "weight end"] {
    set xlabel (side eq 'weight' ? 'weight q L³/EI' : 'load P L²/EI at the end') tc rgb '#808080'
    if (side eq 'weight') { set key bottom right tc rgb '#808080' samplen 0.5 font ',12.5' } else { unset key }
    plot data.'/'.side.'_elastica' using 1:2 with lines smooth mcsplines lw 1.2 lc rgb '#808080' title 'elastica', \
         for [m = 1:4] data.'/'.side.'_'.word(models, m) using 1:2 with points pt (4 + m) ps 0.8 lc rgb word(colours, m) title word(names, m)
}
unset multiplot
