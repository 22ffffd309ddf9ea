# One step of ∫ u ds for u = cos t, from 0.4 s to 1.2 s: the area below the curve, and what three methods take for it.
size_x = 760; size_y = 270
load folder.'/style.gp'
from = 0.4; to = 1.2
set xrange [0.15:1.45]; set yrange [0:1.18]
set xtics ("t" from, "t + h" to) scale 0; set ytics 0,0.5,1; set format y "%.1f"
unset grid
set samples 400
set multiplot layout 1,3
u(t) = cos(t)
do for [k = 1:3] {
  left = k == 2 ? u(to) : u(from)
  right = k == 1 ? u(from) : u(to)
  name = word("'value at the start' 'value at the end' 'mean of both'", k)
  colour = word(orange.' '.blue.' '.green, k)
  area = (left + right) / 2 * (to - from)
  set title name textcolor rgb colour
  set ylabel (k == 1 ? "u [m/s]" : "")
  set label 1 sprintf("%.3f m", area) at 0.8,0.13 center textcolor rgb ink
  top(t) = left + (right - left) * (t - from) / (to - from)
  plot [t=from:to] '+' using 1:(top($1)) with filledcurves x1 fs transparent solid 0.3 noborder lc rgb colour notitle, \
       '+' using ($1):(top($1)) with lines lw 1.5 lc rgb colour notitle, \
       [t=0.15:1.45] u(t) with lines lw 1.5 lc rgb ink notitle
}
unset multiplot
