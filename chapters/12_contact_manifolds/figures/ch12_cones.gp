# Two corners that are nearest to each other: the cone of normals of each, and the way between them in both (section 12.4).
set terminal svg size 600,400 dynamic enhanced font 'DejaVu Sans,15' linewidth 1.2
set output out
unset border; unset tics; unset key
set size ratio -1
set xrange [-1.2:2.1]; set yrange [-0.75:1.45]
set object polygon from 0,0 to -1.1,0 to -1.1,-0.7 to 0,-0.7 to 0,0 fc rgb '#4477AA' fs transparent solid 0.2 border lc rgb '#4477AA'
set object polygon from 0.9,0.5 to 1.9,0.8 to 1.7,1.4 to 0.72,1.4 to 0.9,0.5 fc rgb '#4477AA' fs transparent solid 0.2 border lc rgb '#4477AA'
ray(x, y, colour) = sprintf("set arrow from 0,0 to %g,%g filled size 0.08,20 lw 1.6 dt 2 lc rgb '%s'", x, y, colour)
eval ray(0, 0.9, '#228833')
eval ray(0.9, 0, '#228833')
eval ray(0.88, 0.176, '#EE7733')
eval ray(-0.26, 0.86, '#EE7733')
set arrow from 0,0 to 0.9,0.5 filled size 0.08,20 lw 2.4 lc rgb '#CC3311'
set label 'v' at -0.1,-0.1 center tc rgb '#808080' font ',17'
set label 'w' at 1.0,0.4 center tc rgb '#808080' font ',17'
set label 'd' at 0.45,0.35 center tc rgb '#808080' font ',17'
set label 'a' at -0.6,-0.4 center tc rgb '#808080' font ',17'
set label 'b' at 1.25,1.1 center tc rgb '#808080' font ',17'
plot NaN
