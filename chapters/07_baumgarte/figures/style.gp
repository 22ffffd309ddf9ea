# What the plots of this chapter share.
set terminal svg size 720,440 dynamic enhanced font 'DejaVu Sans,14' linewidth 1.2
set output out
set border 3 lc rgb '#808080'
set tics nomirror out tc rgb '#808080'
set datafile separator comma
set datafile missing 'NaN'
set key tc rgb '#808080' samplen 1.2 spacing 1.1
