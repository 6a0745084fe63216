#compdef hardsphere
# Completion for zsh, written by: hardsphere completion zsh
local -a names common own
if (( CURRENT == 2 )); then
  names=(
    'model:how well the balls behave'
    'boundary:the boundary of the union'
    'measure:area and volume, in total, by ball, residue or chain, and their gradients'
    'voids:the cavities in the union and the balls around them'
    'contacts:which balls, residues or chains touch and by how much, each ball'\''s share'
    'complex:the dual complex'
    'cells:free space as simple cells'
    'path:how a probe gets from one point to another'
    'gate:the widest probe that gets to a point or to the outside, and what stops it'
    'pores:pores for every probe at once'
    'clash:a molecule against another one, turned and moved'
    'query:which balls contain a point or meet a ball'
    'mesh:the surface as triangles'
    'map:what is seen from a direction'
    'pick:the ball that is seen at a point'
    'draw:a picture with hidden parts removed'
    'completion:what makes a shell complete commands and options'
    'help:more about a command'
  )
  _describe command names
  return
fi
common=(
    '*--format=[what FILE is, whatever its extension]:FORMAT:(xyzr pdb pqr xyz cif gro sdf mol2 pdbqt)'
    '*--radii=[radii by element, for files without radii]:bondi|chem3d:(bondi chem3d protor naccess list)'
    '*--radius=[add or replace radii of single elements, whatever the residue]:EL=R,..:'
    '*--probe=[add P to every radius]:P:'
    '*--json[print JSON instead of a table]'
    '*--no-water[leave out such atoms]'
    '*--no-hetatm[leave out such atoms]'
    '*--no-hydrogens[leave out such atoms]'
    '*--only=[read only the atoms that S names, or all but them]:S:'
    '*--hide=[read only the atoms that S names, or all but them]:S:'
    '*--index=[groups of atoms, as in GROMACS'\''s index files (.ndx), numbered as in FILE]:FILE:_files'
    '*--model=[read model N of the file, counted from 1]:N:'
    '*--models=[read all models as one set of balls, as of files that have one for each copy of an]:merged:(merged)'
    '*--altloc=[which location counts of atoms that .pdb and .cif files have at several]:first|occupancy|LETTER:(first occupancy)'
    '*--chains=[of .cif files]:auth|label:(auth label)'
    '*--assembly=[make the biological assembly N that a .pdb or .cif file states (REMARK 350,]:N:_files'
    '*--threads=[let N threads work on files, on frames of a trajectory or on a large molecule]:N:'
    '--help[more about the command]'
    '*:file:_files'
)
case $words[2] in
  model) own=(
  ) ;;
  boundary) own=(
    '*--shells[list them in any case, in JSON too]'
    '*--csv[print the counts, or with --shells the list, as comma-separated values and nothing else]'
    '*--box=[the box, or AX,0,0,BX,BY,0,CX,CY,CZ if it is skew]:AX,BY,CZ:(file p1)'
  ) ;;
  measure) own=(
    '*--surface=[measure the solvent-excluded surface instead, the smooth one that the probe leaves where]:ses:(sas ses)'
    '*--outer[of that surface what a probe reaches from outside]'
    '*--per-ball[also the free area of every ball]'
    '*--gradient[also the derivatives of area and volume by every centre and radius]'
    '*--curvature[also the integrated mean and Gaussian curvature of the boundary]'
    '*--weights=[also the sum of weight x free area]:FILE:_files'
    '*--polar[also the areas of nitrogen and oxygen, of carbon, sulfur and selenium, and of all others]'
    '*--by=[also sums over residues or chains, except for .xyz and .xyzr, or over the groups of]:residue|chain|group:(residue chain group)'
    '*--of=[measure only the atoms that S names, as for --only]:S:'
    '*--relative[with --by residue and a probe]'
    '*--interface=[also what chain A and chain B bury between them]:A,B:'
    '*--csv[print the balls, or with --by the sums, as comma-separated values and nothing else]'
    '*--pdb-out=[write the .pdb file again with the free area of each atom in columns 61-66]:FILE:_files'
    '*--trajectory=[go through the frames of a {frames} file instead, each with the]:RUN:_files'
    '*--frames=[only the frames A to B, counted from 1, in steps of S]:A:'
    '*--begin=[only the frames from time T, or up to it, as the trajectory has times]:T:'
    '*--end=[only the frames from time T, or up to it, as the trajectory has times]:T:'
    '*--interval=[of these the first one, and from its time on the first one in each interval of DT]:DT:'
    '*--mean[with --trajectory]'
    '*--box=[the box, or AX,0,0,BX,BY,0,CX,CY,CZ if it is skew]:AX,BY,CZ:(file p1)'
  ) ;;
  voids) own=(
    '*--min-volume=[only those of volume V or more]:V:'
    '*--balls[also the balls around each]'
    '*--csv[print the list as comma-separated values and nothing else]'
  ) ;;
  contacts) own=(
    '*--by=[sums over the contacts between residues or chains, instead of those between balls]:residue|chain:(residue chain)'
    '*--cells[also volume, free area and contact area of every ball'\''s share]'
    '*--least=[list only contacts, or sums, of area A or more]:A:'
    '*--csv[print the list as comma-separated values and nothing else]'
    '*--map=[also a picture of the list]:OUT.svg:_files'
    '*--dark[that picture before a dark page, with lighter squares for larger areas]'
    '*--trajectory=[for every frame a row of numbers, or with --json a line with the list]:RUN:_files'
    '*--frames=[for every frame a row of numbers, or with --json a line with the list]:A:'
    '*--begin=[for every frame a row of numbers, or with --json a line with the list]:T:'
    '*--end=[for every frame a row of numbers, or with --json a line with the list]:T:'
    '*--interval=[for every frame a row of numbers, or with --json a line with the list]:DT:'
    '*--box=[the box, or AX,0,0,BX,BY,0,CX,CY,CZ if it is skew]:AX,BY,CZ:(file p1)'
  ) ;;
  complex) own=(
  ) ;;
  cells) own=(
  ) ;;
  path) own=(
    '*--from=[]:X Y Z:'
    '*--to=[]:X Y Z:'
  ) ;;
  gate) own=(
    '*--from=[begin where the void K of hardsphere voids has most room, with the same --probe P,]:void:'
    '*--to=[]:X Y Z|void:'
  ) ;;
  pores) own=(
    '*--probe=[only what is wider than a probe of radius P]:P:'
    '*--least=[list only maxima whose class lives for D or more, radius less death, and pockets that]:D:'
    '*--gates[list gates instead]'
    '*--regions[area and volume of free space that a probe of radius P gets to from outside, or with --box]'
    '*--pockets=[list pockets]:W:'
    '*--balls[also the balls around each pocket, and each bottleneck of a tunnel]'
    '*--tunnels-from=[list tunnels from a point to the outside, the widest first, with the radius along each]:X Y Z|atom:'
    '*--tunnels-to=[instead to this point, or with --box to that copy of it which is best]:X Y Z|atom:'
    '*--cheapest[tunnels of the least cost first, the integral of 1/radius^2 along straight lines through]'
    '*--tunnels=[so many, each without the bottlenecks of those before it]:N:'
    '*--points=[also a .pdb or .cif file for viewers with what is listed]:OUT:_files'
    '*--tunnels-out=[also the tunnels as mmcif_tunnels.dic, of ChannelsDB, has them]:OUT.cif:_files'
    '*--profile=[also a chart of the tunnels]:OUT.svg:_files'
    '*--tree=[also a chart of the classes]:OUT.svg:_files'
    '*--csv[print maxima, gates, regions, pockets or points of tunnels as comma-separated values and]'
    '*--box=[the box, or AX,0,0,BX,BY,0,CX,CY,CZ if it is skew]:AX,BY,CZ:(file p1)'
  ) ;;
  clash) own=(
    '*--rotate=[turn the second one by X, then Y, then Z degrees about axes through the mean of its]:X,Y,Z:'
    '*--translate=[then move it]:X,Y,Z:'
  ) ;;
  query) own=(
    '*--point=[]:X Y Z:'
    '*--ball=[]:X Y Z R:'
  ) ;;
  mesh) own=(
    '*-o+[the file to write]:OUT:_files'
    '*--output=[the file to write]:OUT:_files'
    '*--edge=[how long edges are, about]:L:'
    '*--surface=[van der Waals, which is without --probe]:vdw|sas|ses:(vdw sas ses)'
    '*--triangles=[what OUT is]:ply|obj|stl|vert|svg:(ply obj stl vert svg)'
    '*--view=[from where .svg shows them, as for draw]:X,Y,Z:'
    '*--up=[from where .svg shows them, as for draw]:X,Y,Z:'
    '*--rotate=[from where .svg shows them, as for draw]:X,Y,Z:'
    '*--cut[in .svg leave out what lies before the middle of the largest void, or else of all]'
    '*--dark[in .svg before a dark page]'
    '*--pockets=[in .svg show pockets instead, as pores has them]:W:'
    '*--least=[only pockets that are wider than their widest mouth by D]:D:'
  ) ;;
  map) own=(
    '*--view=[from where to look]:X,Y,Z:'
    '*--up=[from where to look]:X,Y,Z:'
    '*--rotate=[from where to look]:X,Y,Z:'
    '*--per-ball[list the balls that are seen]'
  ) ;;
  pick) own=(
    '*--at=[the point]:X,Y:'
    '*--view=[from where to look]:X,Y,Z:'
    '*--up=[from where to look]:X,Y,Z:'
    '*--rotate=[from where to look]:X,Y,Z:'
  ) ;;
  draw) own=(
    '*-o+[the file to write]:OUT:_files'
    '*--output=[the file to write]:OUT:_files'
    '*--picture=[what OUT is]:svg|eps|pdf:(svg eps pdf)'
    '*--view=[the direction towards the viewer]:X,Y,Z:'
    '*--up=[the direction that appears upwards]:X,Y,Z:'
    '*--rotate=[then turn the balls by X, then Y, then Z degrees about the axes to the right, upwards]:X,Y,Z:'
    '*--spin=[N pictures of a whole turn about the upright axis, in one frame and scale]:N:'
    '*--look=[several options by one name]:paper|goodsell|slide|print:(paper goodsell slide print)'
    '*--style=[one colour a ball, light from the viewer, or light from the upper left]:flat|headlight|soft:(flat headlight soft)'
    '*--palette=[muted colours or Jmol'\''s by element, or a tint for each chain and ligands and ions by]:soft|jmol|chain:(soft jmol chain)'
    '*--colour=[what colours stand for]:WHAT:(element chain residue area bfactor charge plddt)'
    '*--range=[which numbers are blue and red]:LOW,HIGH:'
    '*--highlight=[mute the colours of all atoms but those that S names, as for --only]:S:'
    '*--occlusion=[darken buried balls, from 0, not at all, to 1]:S:'
    '*--fog=[fade far balls to the background, from 0, not at all, to 1]:F:'
    '*--outline=[the width of lines along silhouettes and intersections, 0]:W:'
    '*--outline-colour=[their colour]:RRGGBB:'
    '*--ink[contours as wide as what lies behind them is far]'
    '*--ink-width=[contours with other widths, where they are widest]:W:'
    '*--ink-colour=[contours in another colour, or in three, likewise]:RRGGBB:'
    '*--classes[in .svg an id for each atom, and classes for its element, residue and chain, such as el-C]'
    '*--tooltips[in .svg show names of atoms beside the pointer]'
    '*--width=[the size of the picture, one follows from the other]:W:'
    '*--height=[the size of the picture, one follows from the other]:H:'
    '*--unit=[of width, height, outline and ink-width]:px|mm:(px mm)'
    '*--margin=[around the balls, as a part of their larger side]:M:'
    '*--scale=[for pictures side by side and movies]:S:'
    '*--centre=[with --scale]:X,Y,Z:'
    '*--crop=[only this part of the picture, W wide and H high, X from its left and Y from its upper edge,]:X,Y,W,H:'
    '*--background=[default FFFFFF]:RRGGBB|none:(none)'
    '*--fog-colour=[with --background none]:RRGGBB:'
    '*--label=[names, each where most room is in what is seen of it, or beside the molecule with a line]:atom|residue|chain:(atom residue chain)'
    '*--scale-bar[a length to compare with]'
    '*--legend[which colour stands for which element, chain, kind of residue or number]'
    '*--title=[the title in the file]:TEXT:_files'
    '*--water[draw water too]'
    '*--pieces=[cut balls by farther ones, or by all others, which leaves seams]:g|h|visible:(g h visible)'
    '*--all-balls[paint hidden balls too]'
    '*--as=[small balls, and sticks for bonds, in halves of the balls'\'' colours]:ball-and-stick:(balls ball-and-stick)'
    '*--ball-size=[radii of these balls, as a part of those of the atoms]:S:'
    '*--stick=[the radius of the sticks]:R:'
  ) ;;
  completion) _values shell bash zsh; return ;;
  help) _values command model boundary measure voids contacts complex cells path gate pores clash query mesh map pick draw ; return ;;
esac
(( CURRENT-- ))
shift words
_arguments -S $own $common
