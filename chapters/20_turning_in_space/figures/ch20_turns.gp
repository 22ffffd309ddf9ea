# Two quarter turns of a book in both orders: about its edge x and then about its own y, and the other way round (section 20.2).
# Seen with x towards the reader, y to the right, z up.
set terminal svg size 640,420 dynamic enhanced font 'DejaVu Sans,18' linewidth 1.2
set output out
unset border; unset tics; unset key
set size ratio -1
set xrange [-1.7:9.5]; set yrange [-4.85:2.2]
grey = '#808080'; blue = '#4477AA'; red = '#CC3311'; green = '#228833'
U(x, y, z) = y - 0.5 * x
V(x, y, z) = z - 0.4 * x
# a box around (a, b) in the picture with half edges along x, y, z: its front, its top and its right
corner(a, b, x, y, z) = sprintf('%g,%g', a + U(x, y, z), b + V(x, y, z))
face(p, q, r, s, much) = 'set object polygon from '.p.' to '.q.' to '.r.' to '.s.' to '.p.' fc rgb "'.blue.'" fs transparent solid '.much.' border lc rgb "'.blue.'"; '
box(a, b, x, y, z) = face(corner(a, b, x, -y, -z), corner(a, b, x, y, -z), corner(a, b, x, y, z), corner(a, b, x, -y, z), '0.35') \
    . face(corner(a, b, x, -y, z), corner(a, b, x, y, z), corner(a, b, -x, y, z), corner(a, b, -x, -y, z), '0.15') \
    . face(corner(a, b, x, y, -z), corner(a, b, -x, y, -z), corner(a, b, -x, y, z), corner(a, b, x, y, z), '0.55')
edge(a, b, x, y, z, colour, name) = sprintf("set arrow from %g,%g to %g,%g filled front size 0.18,20 lw 2.2 lc rgb '%s'; set label '%s' at %g,%g center front tc rgb '%s'; ", \
    a, b, a + U(x, y, z), b + V(x, y, z), colour, name, a + 1.2 * U(x, y, z), b + 1.2 * V(x, y, z), colour)
# x, y and z are the edges of the book, and point where the arguments say
eval box(0, 0, 0.6, 0.9, 0.15)
eval edge(0, 0, 1.7, 0, 0, red, 'x').edge(0, 0, 0, 1.4, 0, green, 'y').edge(0, 0, 0, 0, 1.3, grey, 'z')
eval box(3.9, 0, 0.6, 0.15, 0.9)
eval edge(3.9, 0, 1.7, 0, 0, red, 'x').edge(3.9, 0, 0, 0, 1.5, green, 'y').edge(3.9, 0, 0, -1.2, 0, grey, 'z')
eval box(7.8, 0, 0.15, 0.6, 0.9)
eval edge(7.8, 0, 0, 1.2, 0, red, 'x').edge(7.8, 0, 0, 0, 1.5, green, 'y').edge(7.8, 0, 1.7, 0, 0, grey, 'z')
eval box(0, -3.3, 0.6, 0.9, 0.15)
eval edge(0, -3.3, 1.7, 0, 0, red, 'x').edge(0, -3.3, 0, 1.4, 0, green, 'y').edge(0, -3.3, 0, 0, 1.3, grey, 'z')
eval box(3.9, -3.3, 0.15, 0.9, 0.6)
eval edge(3.9, -3.3, 0, 0, -1.2, red, 'x').edge(3.9, -3.3, 0, 1.4, 0, green, 'y').edge(3.9, -3.3, 1.7, 0, 0, grey, 'z')
eval box(7.8, -3.3, 0.9, 0.15, 0.6)
eval edge(7.8, -3.3, 0, 0, -1.2, red, 'x').edge(7.8, -3.3, 1.9, 0, 0, green, 'y').edge(7.8, -3.3, 0, -1.2, 0, grey, 'z')
set label 'about x' at 1.95,1.75 center tc rgb red
set label 'about its y' at 5.85,1.75 center tc rgb green
set label 'about y' at 1.95,-1.6 center tc rgb green
set label 'about its x' at 5.85,-1.6 center tc rgb red
plot NaN
