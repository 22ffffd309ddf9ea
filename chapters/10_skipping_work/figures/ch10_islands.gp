# The eight bodies by hand of section 10.5: place, number, island (0 = cannot move), and the rows between them.
# The islands are those that a test checks against join_by_rows().
$bodies << EOD
0.45 -0.55 0 1
-0.95 0.35 1 2
-0.50 -0.35 2 0
0.95 -0.35 3 1
-0.05 0.40 4 3
0.50 0.15 5 0
1.35 0.10 6 1
1.10 0.60 7 4
EOD
array colour[4] = ['#4477AA', '#EE7733', '#228833', '#AA3377']
set terminal svg size 760,400 dynamic enhanced font 'DejaVu Sans,15' linewidth 1.2
set output out
unset border; unset tics; unset key
set size ratio -1
set xrange [-1.6:1.6]; set yrange [-0.8:0.9]
row(a, b, c) = sprintf("set arrow from %s to %s nohead lw 2.2 lc rgb '%s'", a, b, c)
eval row('0.45,-0.55', '0.95,-0.35', colour[1])
eval row('0.95,-0.35', '1.35,0.10', colour[1])
eval row('-0.95,0.35', '-0.50,-0.35', colour[2]).' dt 2'
eval row('-0.50,-0.35', '-0.05,0.40', colour[3]).' dt 2'
eval row('-0.05,0.40', '0.50,0.15', colour[3]).' dt 2'
eval row('-1.45,0.35', '-0.95,0.35', colour[2]).' dt 2'
set arrow from -1.45,-0.1 to -1.45,0.8 nohead lw 4 lc rgb '#808080'
set label 'wall' at -1.4,0.75 left tc rgb '#808080'
do for [k = 0:7] {
    x = real(word($bodies[k + 1], 1)); y = real(word($bodies[k + 1], 2)); i = int(word($bodies[k + 1], 4))
    if (i == 0) {
        set object rectangle center x,y size 0.24,0.24 front fc rgb '#808080' fs transparent solid 0.8 border lc rgb '#808080'
    } else {
        set object circle at x,y size 0.13 front fc rgb colour[i] fs transparent solid 0.8 border lc rgb colour[i]
    }
    set label sprintf('%d', k) at x,y + 0.2 center front tc rgb '#808080' font ',17'
}
plot NaN
