# Error against the time of a second, all scenes, ways and engines: a panel each, from 30 to 3840 steps a second.
set terminal svg size 860,2150 dynamic enhanced font 'DejaVu Sans,21' linewidth 1.5
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set logscale xy
set format x '10^{%L}'; set format y '10^{%L}'
set xtics 100 offset 0,0.3; set ytics 1e4 offset 0.5,0; set mxtics 1; set mytics 1
set xrange [10:1e7]; set yrange [3e-14:3]
unset key
ways = 'spring end_spring acceleration single impulses positions coordinates'
engines = "ODE Bullet Bullet_s_trees Simbody MuJoCo"
colours = '#EE7733 #AA7700 #CC3311 #33AACC #4477AA #228833 #AA3377'
peer_colours = '#EE6677 #997700 #AA3377 #009988 #808080'
scenes = 'pendulum double_pendulum slider-crank heavy_chain block_on_a_slope bouncing_ball stack_of_five Painleve_s_rod Newton_s_cradle doll'
titles = '"a pendulum [m]" "a double pendulum [rad]" "a slider-crank [m]" "a heavy chain [m]" "a block on a slope [m]" "a bouncing ball [m]" "a stack of five [m]" "Painlevé''s rod [m/s]" "Newton''s cradle [m/s]" "a doll [m]"'
is_there(f) = int(system('[ -s "'.f.'" ] && echo 1 || echo 0'))
set multiplot layout 6,2 margins 0.12,0.98,0.01,0.98 spacing 0.13,0.055
do for [i=1:10] {
    scene = word(scenes, i)
    set title word(titles, i) tc rgb '#808080' offset 0,-0.7
    unset xlabel; unset ylabel
    if (i > 8) { set xlabel 'time of a second [µs]' tc rgb '#808080' offset 0,0.8 }
    if (i % 2 == 1) { set ylabel 'error' tc rgb '#808080' offset 2.4,0 }
    file(name) = data.'/all_'.scene.'_'.name
    or_none(name) = is_there(file(name)) ? file(name) : data.'/none'
    plot for [k=1:7] or_none(word(ways, k)) using 1:2 with linespoints lw 1.5 pt 7 ps 0.5 lc rgb word(colours, k), \
         for [k=1:5] or_none(word(engines, k)) using 1:2 with linespoints lw 1.5 dt (4,3) pt 6 ps 0.5 lc rgb word(peer_colours, k)
}
# the last two places are the key
unset title; unset xlabel; unset ylabel; unset tics; unset border; unset logscale
set xrange [0:1]; set yrange [0:1]
set key at graph -0.15,0.9 left top Left reverse tc rgb '#808080' samplen 1.5 spacing 1.1
way_titles = '"spring" "end spring" "acceleration" "single impulses" "impulses" "positions" "coordinates"'
plot for [k=1:7] NaN with linespoints lw 1.5 pt 7 ps 0.6 lc rgb word(colours, k) title word(way_titles, k)
peer_titles = '"ODE: impulses" "Bullet: impulses" "Bullet''s trees: coord." "Simbody: coordinates" "MuJoCo: coord., soft"'
plot for [k=1:5] NaN with linespoints lw 1.5 dt (4,3) pt 6 ps 0.6 lc rgb word(peer_colours, k) title word(peer_titles, k)
unset multiplot
