# Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
#
# This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Anisotropic_hde_remeshing developers

# pictures of growth.csv in the folder `results`

set datafile separator ','
set terminal svg size 640,420 font 'sans,13' background 'white'
set logscale x
set format x '%.0s%c'
set xlabel 'faces of the input, halved'
set grid
set key top left
set yrange [0:*]
data = results . '/growth.csv'

set output results . '/time.svg'
set ylabel 'microseconds a face'
plot data skip 1 using 1:3 with linespoints lw 2 pt 7 title 'anisotropic\_hde\_remeshing, 2 cores', \
     data skip 1 using 1:4 with linespoints lw 2 pt 5 title 'isotropic\_remeshing, 1 core'

set output results . '/memory.svg'
set ylabel 'kilobytes a face'
plot data skip 1 using 1:6 with linespoints lw 2 pt 7 title 'anisotropic\_hde\_remeshing', \
     data skip 1 using 1:7 with linespoints lw 2 pt 5 title 'isotropic\_remeshing'

set output results . '/error.svg'
set ylabel 'faces to the zero set, rms over D'
set logscale y
set yrange [*:*]
set format y '10^{%T}'
plot data skip 1 using 1:8 with linespoints lw 2 pt 7 title 'anisotropic\_hde\_remeshing', \
     data skip 1 using 1:9 with linespoints lw 2 pt 5 title 'isotropic\_remeshing'
