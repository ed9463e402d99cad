# -Geom File-
(# shapes, names
   and colors #)
PointSet cloud {
    PointList [ <1,2,3>, <4.5,-5e0,.6> ]
    ColorList [ <10,20,30,0>, Red ]
}
Material bark { Ambient <81,64,43> Diffuse 2.65 }
Shape leaf { Id 7 Geometry Translated { Translation <10,0,0> Geometry cloud } Appearance bark }
Shape { Geometry Group { GeometryList [ cloud, Sphere { Radius 0.5 } ] } Appearance Red }
Shape s { cloud, bark }
