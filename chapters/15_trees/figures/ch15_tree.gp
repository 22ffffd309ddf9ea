# A tree of bodies on the world, numbered with parents before children: what goes up and what goes down (section 15.2).
set terminal svg size 640,350 dynamic enhanced font 'DejaVu Sans,18' linewidth 1.2
set output out
unset border; unset tics; unset key
set size ratio -1
set xrange [-0.7:6.0]; set yrange [-0.3:3.0]
grey = '#808080'; blue = '#4477AA'; red = '#CC3311'; green = '#228833'
set arrow from 1.3,2.75 to 2.9,2.75 nohead lw 4 lc rgb grey
set label 'the world' at 3.0,2.75 left tc rgb grey
joint(a, b, c, d) = sprintf("set arrow from %g,%g to %g,%g nohead lw 2 lc rgb '%s'", a, b, c, d, grey)
eval joint(2.1, 2.75, 2.1, 2.1)
eval joint(2.1, 2.1, 1.1, 1.2)
eval joint(2.1, 2.1, 3.1, 1.2)
eval joint(1.1, 1.2, 0.4, 0.3)
eval joint(1.1, 1.2, 1.8, 0.3)
body(x, y, name) = sprintf("set object circle at %g,%g size 0.24 front fc rgb '#C7D5E5' fs solid border lc rgb '%s'; set label '%s' at %g,%g center front tc rgb '#333333'", x, y, blue, name, x, y)
eval body(2.1, 2.1, '1')
eval body(1.1, 1.2, '2')
eval body(3.1, 1.2, '3')
eval body(0.4, 0.3, '4')
eval body(1.8, 0.3, '5')
set label 'root: parent of 2 and 3' at 2.45,2.1 left tc rgb grey
set label 'leaf' at 3.45,1.2 left tc rgb grey
set label 'leaf' at 0.05,0.3 right tc rgb grey
set label 'leaf' at 2.2,0.3 left tc rgb grey
set arrow from 5.0,0.3 to 5.0,1.6 filled size 0.12,20 lw 2.4 lc rgb green
set arrow from 5.3,1.6 to 5.3,0.3 filled size 0.12,20 lw 2.4 lc rgb red
set label 'up' at 5.0,0.05 right tc rgb green
set label 'G, K, S' at 4.9,0.95 right tc rgb green
set label 'down' at 5.3,0.05 left tc rgb red
set label 'λ, u' at 5.4,0.95 left tc rgb red
plot NaN
