# The pair by hand of section 10.B: radius, margin, skin and distance in metres.
radius = 0.1; margin = 0.02; skin = 0.01; apart = 0.25
touch = 2 * radius + margin
list = touch + 2 * skin
set terminal svg size 760,520 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
unset border; unset tics; unset key
set size ratio -1
set xrange [-0.32:0.44]; set yrange [-0.26:0.29]
set style fill transparent solid 0.12 border lc rgb '#4477AA'
do for [k = 0:1] {
    set object circle at k * apart,0 size radius fc rgb '#4477AA' fs transparent solid 0.12 border lc rgb '#4477AA'
    set object circle at k * apart,0 size skin fc rgb '#EE7733' fs empty border lc rgb '#EE7733' lw 1.8
    set object circle at k * apart,0 size 0.0025 fc rgb '#808080' fs solid
}
set object circle at 0,0 size touch fc rgb '#CC3311' fs empty border lc rgb '#CC3311' lw 1.5
set object circle at 0,0 size list fc rgb '#228833' fs empty border lc rgb '#228833' lw 1.5
set arrow from 0,0 to apart,0 nohead lc rgb '#808080'
set label sprintf('%.2f m', apart) at 0.5 * apart,0.015 center tc rgb '#808080'
set label 'skin' at 0,-0.03 center tc rgb '#EE7733'
set label sprintf('contact below %.2f m', touch) at 0,touch - 0.04 center tc rgb '#CC3311'
set label sprintf('listed below %.2f m', list) at 0,list + 0.016 center tc rgb '#228833'
plot NaN
