EulerRotated a { Azimuth 78 Elevation 45 Roll 30 Geometry PointSet { PointList [ OX, OY ] } }
AxisRotated b { Axis <1,0,0> Angle -15 Geometry a }
Oriented c { Primary OY Secondary OZ Geometry Scaled { Scale <1,2,3> Geometry b } }
Tapered d { BaseRadius 1 TopRadius 2 Primitive c }
Extrusion e { Axis Polyline { PointList [OX, OY] } CrossSection Polyline2D p { PointList [<0, :cos(3*Pi)/2>] } }
Inline i { Translation <9,9,9> Scene { PointSet f { PointList [OX] } Shape g { Geometry f } } }
:echo all of it
