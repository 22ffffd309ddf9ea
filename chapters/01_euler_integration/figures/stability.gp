# The largest |eigenvalue| of one step on a spring: dots from the code, lines from theory.
load folder.'/style.gp'
set xrange [0:3.2]; set yrange [0:2.6]
set xlabel "hω"; set ylabel "largest |eigenvalue| of a step"
set key top left
set samples 1000
explicit(z) = sqrt(1 + z*z)
implicit(z) = 1/sqrt(1 + z*z)
symplectic(z) = z <= 2 ? 1 : z*z/2 - 1 + sqrt((z*z/2 - 1)**2 - 1)
rk(z) = sqrt(1 - z**6/72 + z**8/576)
dp(z) = sqrt((1 - z**2/2 + z**4/24 - z**6/600)**2 + (z - z**3/6 + z**5/120)**2)
# Yoshida: the trace of the product of three drift-kick-drift matrices.
w = 1/(2 - 2**(1./3)); v = 1 - 2*w
c(p) = 1 - p*p/2           # the diagonal of one such step of length p
b(p) = p*(1 - p*p/4)       # what u gives to x
d(p) = -p                  # what x gives to u
half(z) = c(w*z)*(c(v*z)*c(w*z) + b(v*z)*d(w*z)) + b(w*z)*(d(v*z)*c(w*z) + c(v*z)*d(w*z))
yoshida(z) = abs(half(z)) <= 1 ? 1 : abs(half(z)) + sqrt(half(z)**2 - 1)
set arrow from 2, graph 0 to 2, graph 1 nohead dt 3 lc rgb ink
set label "hω = 2" at 2.03, 0.2 textcolor rgb ink
dots(name) = sprintf("< grep '^%s,' %s", name, data)
plot explicit(x) with lines lw 1.2 lc rgb orange notitle, \
     implicit(x) with lines lw 1.2 lc rgb ink notitle, \
     symplectic(x) with lines lw 1.2 lc rgb blue notitle, \
     rk(x) with lines lw 1.2 lc rgb yellow notitle, \
     dp(x) with lines lw 1.2 lc rgb red notitle, \
     yoshida(x) with lines lw 1.2 lc rgb purple notitle, \
     dots('explicit_euler') using 2:3 with points pt 7 ps 0.6 lc rgb orange title "explicit Euler", \
     dots('symplectic_euler') using 2:3 with points pt 7 ps 0.6 lc rgb blue title "symplectic Euler", \
     dots('verlet') using 2:3 with points pt 6 ps 1 lc rgb green title "Verlet", \
     dots('yoshida4') using 2:3 with points pt 5 ps 0.5 lc rgb purple title "Yoshida 4", \
     dots('rk4') using 2:3 with points pt 11 ps 0.7 lc rgb yellow title "RK4", \
     dots('dormand_prince') using 2:3 with points pt 13 ps 0.7 lc rgb red title "Dormand-Prince", \
     dots('implicit_euler') using 2:3 with points pt 9 ps 0.6 lc rgb ink title "implicit Euler"
