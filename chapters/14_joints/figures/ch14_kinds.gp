# The kinds of section 14.2: body a grey, body b blue, what holds them red, what is left free orange.
set terminal svg size 600,600 dynamic enhanced font 'DejaVu Sans,19' linewidth 1.2
set output out
unset border; unset tics; unset key
set size ratio -1
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set xrange [-1.1:6.1]; set yrange [-6.75:0.9]
a = '#808080'; b = '#4477AA'; held = '#CC3311'; free = '#EE7733'
cell(k) = (x = 2.5 * (k % 3), y = -1.95 * (k / 3), 0)
name(text) = sprintf("set label '%s' at %g,%g center tc rgb '#808080'", text, x, y - 0.78)
box(p, q, w, h, colour) = sprintf("set object polygon from %g,%g to %g,%g to %g,%g to %g,%g to %g,%g fc rgb '%s' fs transparent solid 0.2 border lc rgb '%s'", \
    x + p - w, y + q - h, x + p + w, y + q - h, x + p + w, y + q + h, x + p - w, y + q + h, x + p - w, y + q - h, colour, colour)
disc(p, q, r, colour) = sprintf("set object circle at %g,%g size %g fc rgb '%s' fs transparent solid 0.2 border lc rgb '%s'", \
    x + p, y + q, r, colour, colour)
dot(p, q) = sprintf("set object circle at %g,%g size 0.055 fc rgb '%s' fs solid noborder", x + p, y + q, held)
line(p, q, s, t, colour) = sprintf("set arrow from %g,%g to %g,%g nohead lw 2 lc rgb '%s'", x + p, y + q, x + s, y + t, colour)
ways(p, q, s, t) = sprintf("set arrow from %g,%g to %g,%g heads filled size 0.12,22 lw 2 lc rgb '%s'", x + p, y + q, x + s, y + t, free)
at(p, q, r, v, w) = line(p + r * cos(v * pi / 180), q + r * sin(v * pi / 180), p + r * cos(w * pi / 180), q + r * sin(w * pi / 180), free)
part(p, q, r, from, to, n) = at(p, q, r, from + (to - from) * n / 6.0, from + (to - from) * (n + 1) / 6.0)
arc(p, q, r, from, to) = part(p, q, r, from, to, 0) . '; ' . part(p, q, r, from, to, 1) . '; ' . part(p, q, r, from, to, 2) \
    . '; ' . part(p, q, r, from, to, 3) . '; ' . part(p, q, r, from, to, 4) . '; ' . part(p, q, r, from, to, 5)
tip(p, q, r, at, turn) = sprintf("set arrow from %g,%g to %g,%g filled size 0.12,22 lw 2 lc rgb '%s'", \
    x + p + r * cos((at - turn) * pi / 180), y + q + r * sin((at - turn) * pi / 180), x + p + r * cos(at * pi / 180), y + q + r * sin(at * pi / 180), free)
# a spring from (p, q) to (s, t): zigzags across the way
side(n) = n % 2 ? 0.09 : -0.09
piece(p, q, s, t, n) = line( \
    p + (s - p) * n / 8.0 - (n > 0 ? (t - q) * side(n) / sqrt((s - p)**2 + (t - q)**2) : 0), \
    q + (t - q) * n / 8.0 + (n > 0 ? (s - p) * side(n) / sqrt((s - p)**2 + (t - q)**2) : 0), \
    p + (s - p) * (n + 1) / 8.0 - (n < 7 ? (t - q) * side(n + 1) / sqrt((s - p)**2 + (t - q)**2) : 0), \
    q + (t - q) * (n + 1) / 8.0 + (n < 7 ? (s - p) * side(n + 1) / sqrt((s - p)**2 + (t - q)**2) : 0), held)

dummy = cell(0); eval name('distance'); eval box(-0.7, 0, 0.25, 0.25, a); eval box(0.7, 0.2, 0.25, 0.25, b)
eval line(-0.7, 0, 0.7, 0.2, held); eval dot(-0.7, 0); eval dot(0.7, 0.2)
eval arc(-0.7, 0, 1.41, -12, 2); eval tip(-0.7, 0, 1.41, -13, -5)

dummy = cell(1); eval name('rope'); eval box(-0.7, 0.2, 0.25, 0.25, a); eval box(0.7, 0.2, 0.25, 0.25, b)
do for [n = 0:9] { s = -0.7 + 0.14 * n; t = s + 0.14; eval line(s, 0.2 - 0.9 * (0.49 - s * s), t, 0.2 - 0.9 * (0.49 - t * t), held) }
eval dot(-0.7, 0.2); eval dot(0.7, 0.2); eval ways(0.2, 0.62, 0.95, 0.62)

dummy = cell(2); eval name('revolute: a pin'); eval box(-0.45, 0, 0.6, 0.12, a)
eval line(0.05, 0, 0.65, 0.55, b); eval dot(0.05, 0); eval arc(0.05, 0, 0.62, -25, 20); eval tip(0.05, 0, 0.62, -30, -12)

dummy = cell(3); eval name('prismatic: a slider'); eval box(0, -0.25, 0.95, 0.1, a); eval box(-0.2, 0.1, 0.25, 0.25, b)
eval line(-0.95, -0.15, 0.95, -0.15, held); eval ways(0.15, 0.1, 0.85, 0.1)

dummy = cell(4); eval name('weld'); eval box(-0.4, 0, 0.4, 0.25, a); eval box(0.4, 0.15, 0.4, 0.25, b)
eval line(0, -0.1, 0, 0.25, held); eval dot(0, 0.07)

dummy = cell(5); eval name('wheel'); eval box(0, 0.45, 0.7, 0.18, a); eval disc(0, -0.2, 0.33, b)
do for [n = 0:7] { eval piece(0, 0.27, 0, -0.2, n) }
eval dot(0, -0.2); eval ways(0.6, -0.4, 0.6, 0.15); eval arc(0, -0.2, 0.47, 190, 240); eval tip(0, -0.2, 0.47, 245, 12)

dummy = cell(6); eval name('gear'); eval disc(-0.45, 0.1, 0.5, a); eval disc(0.35, 0.1, 0.3, b); eval dot(0.05, 0.1)
eval arc(-0.45, 0.1, 0.35, 60, 120); eval tip(-0.45, 0.1, 0.35, 125, 15); eval arc(0.35, 0.1, 0.17, 40, 130); eval tip(0.35, 0.1, 0.17, 20, -30)

dummy = cell(7); eval name('rack'); eval disc(-0.1, 0.25, 0.35, a); eval box(0, -0.24, 0.9, 0.12, b); eval dot(-0.1, -0.11)
eval arc(-0.1, 0.25, 0.22, 30, 150); eval tip(-0.1, 0.25, 0.22, 20, -25); eval ways(0.4, 0.05, 0.95, 0.05)

dummy = cell(8); eval name('pulley'); eval line(-0.5, 0.55, 0.5, 0.55, held); eval line(-0.5, 0.55, -0.5, 0.1, held); eval line(0.5, 0.55, 0.5, -0.15, held)
eval dot(-0.5, 0.55); eval dot(0.5, 0.55); eval box(-0.5, -0.07, 0.2, 0.17, a); eval box(0.5, -0.32, 0.2, 0.17, b)
eval ways(-0.85, -0.3, -0.85, 0.2); eval ways(0.85, -0.5, 0.85, 0)

dummy = cell(9); eval name('mouse'); eval box(0.45, -0.1, 0.3, 0.25, b); do for [n = 0:7] { eval piece(0.35, 0.05, -0.75, 0.45, n) }
eval dot(0.35, 0.05); eval line(-0.82, 0.38, -0.68, 0.52, a); eval line(-0.82, 0.52, -0.68, 0.38, a)

dummy = cell(10); eval name('friction'); eval box(0, -0.25, 0.9, 0.15, a); eval box(-0.1, 0.13, 0.35, 0.2, b)
eval dot(-0.1, 0.0); eval ways(0.3, 0.15, 0.9, 0.15); eval arc(-0.1, 0.0, 0.5, 60, 120); eval tip(-0.1, 0.0, 0.5, 130, 12)

dummy = cell(11); eval name('motor'); eval box(-0.6, 0, 0.3, 0.25, a); eval box(0.55, 0.25, 0.3, 0.25, b)
do for [n = 0:7] { eval piece(-0.6, 0.1, 0.55, 0.35, n) }
do for [n = 0:7] { eval piece(-0.6, -0.1, 0.55, 0.15, n) }
plot NaN
