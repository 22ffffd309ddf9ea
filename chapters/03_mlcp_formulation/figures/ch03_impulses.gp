# The function of (3.13) over the impulses of the two contacts, for q = (-2, -1): its lowest point in the quadrant.
load folder.'/style.gp'
set terminal svg size 720,460 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set size ratio -1
set xlabel 'λ_1 [N s] (floor)' tc rgb ink
set ylabel 'λ_2 [N s] (ramp)' tc rgb ink
set xrange [-0.6:5.6]; set yrange [-2.3:1.7]
set key off
set parametric; set trange [0:2*pi]; set samples 400
set object 1 rectangle from 0,0 to 5.6,1.7 fs solid 0.15 noborder fc rgb blue behind
set arrow 1 from 2,0 to 2,0.6 filled size 0.1,18 lw 2 lc rgb green front
set label 1 'w = (0, 0.6)' at 2.08,0.62 tc rgb green front
set label 2 'answer (2, 0)' at 0.48,-0.2 tc rgb blue front
set label 3 'λ ≥ 0' at 4.4,1.4 tc rgb blue front
set label 4 'lowest point without' at 3.42,-1.5 tc rgb orange front
set label 5 'bounds: λ_2 pulls' at 3.42,-1.75 tc rgb orange front
x(r, t) = 10.0/3 + sqrt(r)*(cos(t)/sqrt(1.8) + sin(t)/sqrt(0.2))
y(r, t) = -5.0/3 + sqrt(r)*(cos(t)/sqrt(1.8) - sin(t)/sqrt(0.2))
plot for [i=1:9] x(i*i*0.05 - 0.03, t), y(i*i*0.05 - 0.03, t) with lines lw 0.8 dt 2 lc rgb ink, \
     x(0.5, t), y(0.5, t) with lines lw 2 lc rgb red, \
     '-' using 1:2 with points pt 7 ps 0.8 lc rgb orange, \
     '-' using 1:2 with points pt 7 ps 0.9 lc rgb blue
3.3333333 -1.6666667
e
2 0
e
