# gnuplot -e "folder='FOLDER'" plots.gp: draws FOLDER/NAME.svg from the tables that `write_report --plots` put there.
# No apostrophes in what follows: within blocks gnuplot would not expand @draw after one.
# Each picture has two halves with a table each: a column for n, one for each line, their titles on top.
set datafile missing "?"
set logscale xy
set format x "10^{%L}"
set grid xtics ytics linecolor rgb "#dddddd" linetype 1 linewidth 0.5
set border 3 linecolor rgb "#777777"
set tics nomirror textcolor rgb "#333333"
set xlabel "balls" offset 0, 0.6 textcolor rgb "#333333"
set bmargin 7
set key below horizontal maxcols 4 samplen 2 noenhanced textcolor rgb "#333333" font ",11"
set title font ",13" textcolor rgb "#111111"

# Okabe and Ito's colours, which most colour-blind people can tell apart, and a shape of point for each.
array colour[7] = ["#000000", "#D55E00", "#0072B2", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"]
array shape[7] = [7, 5, 9, 11, 13, 4, 6]

columns(file) = int(system("head -n 1 '".file."' | grep -o '\"' | wc -l")) / 2
rows(file) = int(system("wc -l < '".file."'")) - 1

half(name) = folder."/".name.".dat"
draw = 'plot for [i = 1:columns(file)] file using 1:(column(i + 1)) with linespoints title columnheader(i + 1) \
  linecolor rgb colour[i] pointtype shape[i] pointsize 0.7 linewidth 1.6'
drawable(a, b) = columns(half(a)) > 0 && columns(half(b)) > 0 && rows(half(a)) > 1 && rows(half(b)) > 1

set terminal svg size 1040, 440 font "sans-serif,12" background rgb "white"

if (drawable("scaling_van_der_waals", "scaling_solvent_accessible")) {
  set output folder."/scaling.svg"
  set multiplot layout 1, 2
  set ylabel "ns per ball" textcolor rgb "#333333"
  file = half("scaling_van_der_waals")
  set title "Van der Waals balls"
  @draw
  file = half("scaling_solvent_accessible")
  set title "Solvent-accessible balls"
  @draw
  unset multiplot
}

if (drawable("peers_van_der_waals", "peers_solvent_accessible")) {
  set output folder."/peers.svg"
  set multiplot layout 1, 2
  set ylabel "time over that of the library" textcolor rgb "#333333"
  set arrow 1 from graph 0, first 1 to graph 1, first 1 nohead linecolor rgb "#777777" dashtype 2
  set yrange [*<0.8:*]
  file = half("peers_van_der_waals")
  set title "Van der Waals balls"
  @draw
  file = half("peers_solvent_accessible")
  set title "Solvent-accessible balls"
  @draw
  unset multiplot
  unset arrow 1
  set yrange [*:*]
}

if (drawable("dense_random", "dense_ensemble")) {
  set output folder."/dense.svg"
  set multiplot layout 1, 2
  set xlabel "neighbours a ball"
  set ylabel "ns per ball" textcolor rgb "#333333"
  file = half("dense_random")
  set title "Balls at random places"
  @draw
  file = half("dense_ensemble")
  set title "Copies of 60 atoms of crambin, each moved by 0.5"
  @draw
  unset multiplot
  set xlabel "balls"
}

if (drawable("searches_point_atom", "searches_ball_atom")) {
  set output folder."/searches.svg"
  set multiplot layout 1, 2
  set ylabel "ns per query" textcolor rgb "#333333"
  file = half("searches_point_atom")
  set title "Points near atoms"
  @draw
  file = half("searches_ball_atom")
  set title "Balls near atoms"
  @draw
  unset multiplot
}

if (drawable("alternatives_ball_atom", "alternatives_memory")) {
  set output folder."/alternatives.svg"
  set multiplot layout 1, 2
  set ylabel "ns per query" textcolor rgb "#333333"
  file = half("alternatives_ball_atom")
  set title "Balls near atoms"
  @draw
  set ylabel "bytes per ball" textcolor rgb "#333333"
  file = half("alternatives_memory")
  set title "Memory"
  @draw
  unset multiplot
}

if (drawable("section_2_figure_4", "section_2_decompositions")) {
  set output folder."/figure_4.svg"
  set multiplot layout 1, 2
  set ylabel "cells" textcolor rgb "#333333"
  file = half("section_2_figure_4")
  set title "Figure 4"
  @draw
  file = half("section_2_decompositions")
  set title "Molecules"
  @draw
  unset multiplot
}
