# What all plots of this chapter share. `out` and `data` come from draw.sh.
set terminal svg size 720,440 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set key tc rgb '#808080' samplen 2 Left reverse
ink = '#808080'; blue = '#4477AA'; orange = '#EE7733'; green = '#228833'; red = '#CC3311'; purple = '#AA3377'
