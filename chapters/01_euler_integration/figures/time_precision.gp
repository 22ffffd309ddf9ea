# Measured time against error: ours as lines and full dots, Boost.odeint as open rings.
size_x = 860; size_y = 780
load folder.'/style.gp'
set logscale xy
set format x "10^{%L}"; set format y "10^{%L}"
set ytics 1e3; set yrange [1e-13:20]
rows(problem, name, whose) = sprintf("< grep '^%s,%s,%s,' %s", problem, name, whose, data)
problems = "kepler_1_period kepler_10_periods pendulum projectile"
heads = "'Kepler e = 0.6, one period' 'Kepler e = 0.6, ten periods' 'pendulum from 90°, 10 s' 'projectile with drag, 3 s'"
# which of the six methods take the force: Verlet and Yoshida none that depends on the velocity
some = "'1 2 3 4 5 6' '1 2 3 4 5 6' '1 2 3 4 5 6' '1 2 5 6'"
units = "'semi-axes' 'semi-axes' 'rad' 'm'"
set multiplot layout 2,2 margins 0.09,0.98,0.16,0.95 spacing 0.10,0.13
do for [p=1:4] {
  set title word(heads, p) offset 0,-0.5
  set ylabel "error [".word(units, p)."]" offset 1,0
  set xlabel (p > 2 ? "processor time [µs]" : "")
  if (p == 3) { set key at screen 0.5, 0.045 center maxrows 3 maxcols 3 } else { unset key }
  plot for [i in word(some, p)] rows(word(problems, p), word(methods, int(i)), 'ours') using 4:5 with linespoints lw 1 pt 7 ps 0.45 lc rgb word(colours, int(i)) title word(titles, int(i)), \
       for [i in word(some, p)] rows(word(problems, p), word(methods, int(i)), 'odeint') using 4:5 with points pt 6 ps 0.9 lc rgb word(colours, int(i)) notitle, \
       NaN with points pt 6 ps 0.9 lc rgb ink title "the same in Boost.odeint"
}
unset multiplot
