%
(Bracket: a shoulder along two sides with a round corner, and a slot in the shape of a bow)
(Blank 100 x 60 x 20 mm, its corner at X0 Y0, its top at Z0: --blank 100,60,20)
(Cutter: square end of 12 mm with four teeth: --tool square-12-4)
N10 G21 G90 G17
N20 T1 M6
N30 S2000 M3
N40 G0 X-10 Y-2
N50 G0 Z5
N60 G0 Z-3 M8
(The axis is 2 mm outside: a shoulder 4 mm wide and 3 mm deep)
N70 G1 X90 F300
N80 G3 X102 Y10 I0 J12
N90 G1 Y70
N100 G0 Z5
(A slot 2 mm deep, which begins where the shoulder has left nothing)
N110 G0 X25 Y-10
N120 G0 Z-2
N130 G1 Y30 F250
N140 G2 X55 Y30 I15 J0
N150 G1 Y-10
N160 G0 Z5
N170 M9
N180 M5
N190 M30
%
