# The letters of (11.1) to (11.3): a particle of a body in its own axes and where it is, and its velocity (section 11.2).
set terminal svg size 640,400 dynamic enhanced font 'DejaVu Sans,18' linewidth 1.2
set output out
unset border; unset tics; unset key
set size ratio -1
set xrange [-0.35:4.4]; set yrange [-0.3:2.6]
grey = '#808080'; blue = '#4477AA'; red = '#CC3311'; green = '#228833'; orange = '#EE7733'
theta = 35 * pi / 180
c = cos(theta); s = sin(theta)
# the box, and the particle at (ax, ay) from the centroid, when the angle is zero and when it is theta
hx = 1.15; hy = 0.62; ax = 1.0; ay = 0.45
ox = 2.55; oy = 1.1
X(x, y) = ox + c * x - s * y
Y(x, y) = oy + s * x + c * y
set object polygon from ox-hx,oy-hy to ox+hx,oy-hy to ox+hx,oy+hy to ox-hx,oy+hy to ox-hx,oy-hy fs empty border lc rgb grey dt 2
set object polygon from X(-hx,-hy),Y(-hx,-hy) to X(hx,-hy),Y(hx,-hy) to X(hx,hy),Y(hx,hy) to X(-hx,hy),Y(-hx,hy) to X(-hx,-hy),Y(-hx,-hy) fc rgb blue fs transparent solid 0.2 border lc rgb blue
# the place of the centroid in the room
set arrow from 0,0 to ox,oy filled size 0.1,20 lw 1.6 lc rgb grey
set arrow from -0.2,0 to 0.75,0 filled size 0.08,20 lw 1 lc rgb grey
set arrow from 0,-0.2 to 0,0.75 filled size 0.08,20 lw 1 lc rgb grey
# the particle from the centroid, before and after
set arrow from ox,oy to ox+ax,oy+ay filled size 0.1,20 lw 1.6 dt 2 lc rgb orange
set arrow from ox,oy to X(ax,ay),Y(ax,ay) filled size 0.1,20 lw 2.2 lc rgb red
# r turned by a quarter, on the particle, at 0.7 of its length: where it goes if the body turns
rx = 0.7 * (c * ax - s * ay); ry = 0.7 * (s * ax + c * ay)
set arrow from X(ax,ay),Y(ax,ay) to X(ax,ay)-ry,Y(ax,ay)+rx filled size 0.1,20 lw 2.2 lc rgb green
set object circle at ox,oy size 0.045 fc rgb grey fs solid
set object circle at X(ax,ay),Y(ax,ay) size 0.045 fc rgb red fs solid
# the angle, from the dashed arrow to the red one
from = atan2(ay, ax)
set object circle at ox,oy size 0.6 arc [from * 180 / pi : (from + theta) * 180 / pi] nowedge fs empty border lc rgb grey lw 1.4
set label 'θ' at ox+0.74*cos(from+theta/2),oy+0.74*sin(from+theta/2) center tc rgb grey font ',20'
set label 'x' at 1.15,0.68 center tc rgb grey font ',22'
set label 'r̄' at ox+0.72,oy+0.1 center tc rgb orange font ',22'
set label 'r' at ox+0.12,oy+0.6 center tc rgb red font ',22'
set label 'p' at X(ax,ay)+0.17,Y(ax,ay)+0.06 center tc rgb grey font ',22'
set label 'r^{⊥}' at X(ax,ay)-ry-0.17,Y(ax,ay)+rx center tc rgb green font ',22'
plot NaN
