# The bead leaves the wire: radius less one over time, (2.32) as line, the program as dots.
set terminal svg size 720,440 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set datafile separator comma
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'distance from the wire [mm]' tc rgb '#808080'
set key left top Left reverse tc rgb '#808080' samplen 2
set xrange [0:10.2]; set yrange [0:*]
file(h) = data.'/drift_'.h.'.csv'
steps = '0.04 0.02 0.01'
colours = '#CC3311 #EE7733 #4477AA'
plot for [i=1:3] file(word(steps, i)) skip 1 using 2:($4 * 1000) with lines lw 1.5 lc rgb word(colours, i) \
        title 'h = '.word(steps, i).' s, equation (2.32)', \
     for [i=1:3] file(word(steps, i)) skip 1 every 25 using 2:($3 * 1000) with points pt 7 ps 0.45 lc rgb word(colours, i) \
        notitle, \
     NaN with points pt 7 ps 0.45 lc rgb '#808080' title 'dots: measured'
