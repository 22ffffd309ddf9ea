# The bead's distance from its wire: without repayment, and with.
load style
set xlabel 'time [s]' tc rgb '#808080'
set ylabel 'distance from the wire [mm]' tc rgb '#808080'
set xrange [0:10]; set yrange [0:50]
unset key
set label 1 'b = 0: drift by (7.3)' at 6.3,38 right tc rgb '#EE7733'
set label 2 'β = 0.2' at 9.9,2.8 right tc rgb '#4477AA'
plot data.'/bead_none' using 2:(1000*$4) every ::1 with lines lc rgb '#808080', \
     data.'/bead_none' using 2:(1000*$3) every 40::1 with points pt 7 ps 0.6 lc rgb '#EE7733', \
     data.'/bead_baumgarte' using 2:(1000*$4) every ::1 with lines lc rgb '#808080', \
     data.'/bead_baumgarte' using 2:(1000*$3) every 40::1 with points pt 7 ps 0.6 lc rgb '#4477AA'
