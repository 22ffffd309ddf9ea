# Work (`column` 3, called `what`) against error on the four problems.
size_x = 860; size_y = 780
load folder.'/style.gp'
set logscale xy
set format x "10^{%L}"; set format y "10^{%L}"
set ytics 1e3; set yrange [1e-13:20]
rows(problem, name) = sprintf("< grep '^%s,%s,' %s", problem, name, data)
problems = "kepler_1_period kepler_10_periods pendulum projectile"
heads = "'Kepler e = 0.6, one period' 'Kepler e = 0.6, ten periods' 'pendulum from 90°, 10 s' 'projectile with drag, 3 s'"
# which of the six methods take the force: Verlet and Yoshida none that depends on the velocity
some = "'1 2 3 4 5 6' '1 2 3 4 5 6' '1 2 3 4 5 6' '1 2 5 6'"
units = "'semi-axes' 'semi-axes' 'rad' 'm'"
set multiplot layout 2,2 margins 0.09,0.98,0.16,0.95 spacing 0.10,0.13
do for [p=1:4] {
  set title word(heads, p) offset 0,-0.5
  set ylabel "error [".word(units, p)."]" offset 1,0
  set xlabel (p > 2 ? what : "")
  if (p == 3) { set key at screen 0.5, 0.035 center maxrows 2 maxcols 3 } else { unset key }
  plot for [i in word(some, p)] rows(word(problems, p), word(methods, int(i))) using 3:4 with linespoints lw 1 pt points[int(i)] ps 0.6 lc rgb word(colours, int(i)) title word(titles, int(i))
}
unset multiplot
