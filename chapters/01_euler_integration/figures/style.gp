# What all plots of the chapter share: no ground, grey ink, colours that read on light and dark.
# `out` is the file to write; `size_x`, `size_y` its size in pixels.
if (!exists("size_x")) size_x = 720
if (!exists("size_y")) size_y = 440
set terminal svg size size_x,size_y dynamic enhanced font 'DejaVu Sans,13' linewidth 1
set output out
set datafile separator comma
set border 3 lc rgb '#808080'
set tics nomirror textcolor rgb '#808080'
set xlabel textcolor rgb '#808080'; set ylabel textcolor rgb '#808080'
set title textcolor rgb '#808080'
set key textcolor rgb '#808080' samplen 2 spacing 1.15
set grid lc rgb '#808080' lt 1 lw 0.3
blue = '#4477AA'; orange = '#EE7733'; green = '#228833'; red = '#CC3311'; purple = '#AA3377'; yellow = '#CCBB44'; ink = '#808080'
methods = "explicit_euler symplectic_euler verlet yoshida4 rk4 dormand_prince"
titles = "'explicit Euler' 'symplectic Euler' 'Verlet' 'Yoshida 4' 'RK4' 'Dormand-Prince, adaptive'"
colours = orange." ".blue." ".green." ".purple." ".yellow." ".red
array points[6] = [1, 7, 9, 5, 11, 13]
