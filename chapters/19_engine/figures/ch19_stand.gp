# What should stand: time against how far it has moved, from benchmark/engines.csv (section 19.8). Each engine as it comes:
# one step of 1/60 s, Box2D 3 four sub-steps.
set terminal svg size 640,430 dynamic enhanced font 'DejaVu Sans,16' linewidth 1.2
set output out
set datafile separator ','
table = folder.'/../benchmark/engines.csv'
worlds = ' pyramid_10 pyramid_20 pyramid_40 house_4 column_20 column_40 column_80 heavy_1000_on_10 piles_1000 boxes_100m '
shown(world, who, steps, wanted, count) = strstrt(worlds, ' '.world.' ') && who eq wanted && steps == count
fallen(moved) = moved > 1 ? 1 : moved < 1e-15 ? 1e-15 : moved
set border 3 lc rgb '#808080'
set tics nomirror textcolor rgb '#808080'
set key top horizontal outside center textcolor rgb '#808080' samplen 1
set logscale xy
set format y '10^{%T}'
set xrange [0.1:700]; set yrange [4e-16:3]
set ytics 1e-15,1000,1; set mytics 1
set xlabel 'time of four seconds [ms]' textcolor rgb '#808080'
set ylabel 'moved [m]' textcolor rgb '#808080'
spent(who, count) = shown(stringcolumn(1), stringcolumn(2), column(3), who, count) ? column(4) : NaN
plot table skip 1 using (spent('this book', 1)):(fallen(column(10))) with points pt 7 ps 0.8 lc rgb '#4477AA' title 'this book', \
     table skip 1 using (spent('Box2D 3', 4)):(fallen(column(10))) with points pt 5 ps 0.7 lc rgb '#EE7733' title 'Box2D 3', \
     table skip 1 using (spent('Box2D 2.4', 1)):(fallen(column(10))) with points pt 9 ps 0.8 lc rgb '#228833' title 'Box2D 2.4', \
     table skip 1 using (spent('Chipmunk', 1)):(fallen(column(10))) with points pt 13 ps 0.7 lc rgb '#AA3377' title 'Chipmunk'
