#include "core/base/shown_message.h"
#include "core/io/plantgl/bgeom.h"
#include "core/io/plantgl/geom.h"
#include "tests/core/io/plantgl/bgeom_writer.h"
#include "tests/core/io/samples.h"

#include <cmath>
#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Points = std::vector<Eigen::Vector3d>;

Imported<RawPoints> importGeom(const std::string& text) {
  std::istringstream in(text);
  return readGeom(in, "oak.geom");
}

std::string refusalOfGeom(const std::string& text) {
  return test::errorOf([&] { return importGeom(text); });
}

/// Where an object of this type and these fields puts (1, 2, 3).
Eigen::Vector3d placed(const std::string& type, const std::string& fields) {
  const Points points =
      importGeom(type + " a { " + fields + " Geometry PointSet { PointList [ <1,2,3> ] } }")
          .value.positions;
  return points.size() == 1 ? points[0] : Eigen::Vector3d::Constant(NAN);
}

TEST(ReadGeom, EqualsTheSameSceneInBinary) {
  const Imported<RawPoints> points = importGeom(test::geomFile());
  std::istringstream in(test::bgeomFile());
  const Imported<RawPoints> twin = readBgeom(in, "oak.geom");
  EXPECT_EQ(points.value.positions, twin.value.positions);
  EXPECT_EQ(points.value.colors, twin.value.colors);
  EXPECT_EQ(points.notes, twin.notes);
  EXPECT_EQ(points.value.positions, (Points{{11, 2, 3}, {14, 5, 6}, {1, 2, 3}, {4, 5, 6}}));
}

TEST(ReadGeom, TakesNumbersAndVectorsInAllTheirForms) {
  EXPECT_EQ(importGeom("PointSet a {PointList[<-1.5e2,+.25,3.>,OY,<0,-0,1E1>]}").value.positions,
            (Points{{-150, 0.25, 3}, {0, 1, 0}, {0, 0, 10}}));
  EXPECT_EQ(importGeom("PointSet a { PointList [ ] }\r\n").value.positions, Points());
}

TEST(ReadGeom, TakesColorsInAllTheirForms) {
  const RawPoints points =
      importGeom(
          "PointSet a { PointList [OX, OX, OX, OX] ColorList [Cyan, 7, <1,2,3>, <4,5,6,255>] }")
          .value;
  EXPECT_THAT(points.colors,
              ElementsAre(Color{0, 255, 255}, Color{7, 7, 7}, Color{1, 2, 3}, Color{4, 5, 6}));
}

TEST(ReadGeom, DropsColorsThatDoNotMatchThePoints) {
  const Imported<RawPoints> points =
      importGeom("PointSet a { PointList [OX, OY] ColorList [Red] }");
  EXPECT_EQ(points.value.positions.size(), 2U);
  EXPECT_THAT(points.value.colors, IsEmpty());
  EXPECT_THAT(eachInEnglish(points.notes),
              ElementsAre(HasSubstr("1 point set has another number of colors")));
}

// A point at x is first scaled, then moved, then scaled again: 2 (3 x + 10).
TEST(ReadGeom, PlacesFromTheInsideOut) {
  EXPECT_EQ(
      importGeom("Scaled a { Scale <2,1,5> Geometry Translated { Translation <10,0,-1> "
                 "Geometry Scaled { Scale <3,1,1> Geometry PointSet { PointList [<1,1,1>] } } } }")
          .value.positions,
      (Points{{26, 1, 0}}));
}

// Angles are in degrees. By the roll about x, (1, 2, 3) comes to (1, -3, 2), then by the azimuth
// about z to (3, 1, 2).
TEST(ReadGeom, TurnsPointsAsTheBinarySceneDoes) {
  EXPECT_TRUE(placed("AxisRotated", "Angle 90").isApprox(Eigen::Vector3d(-2, 1, 3)));
  EXPECT_TRUE(placed("AxisRotated", "Axis <5,0,0> Angle -90").isApprox(Eigen::Vector3d(1, 3, -2)));
  EXPECT_TRUE(placed("AxisRotated", "Axis <0,0,0> Angle 90").isApprox(Eigen::Vector3d(1, 2, 3)));
  EXPECT_TRUE(placed("EulerRotated", "Azimuth 90 Roll 90").isApprox(Eigen::Vector3d(3, 1, 2)));
  EXPECT_TRUE(placed("EulerRotated", "Elevation 90").isApprox(Eigen::Vector3d(3, 2, -1)));
  EXPECT_TRUE(placed("Oriented", "Primary OY Secondary OZ").isApprox(Eigen::Vector3d(3, 1, 2)));
}

TEST(ReadGeom, LeavesOutPointsThatTheSceneBendsOrTurnsInNoClearWay) {
  const Imported<RawPoints> points =
      importGeom("PointSet a { PointList [OX, OY] } Tapered b { TopRadius 2 Primitive a } "
                 "Oriented c { Primary <1,1,0> Geometry PointSet { PointList [OX] } } "
                 "PointSet d { PointList [<4,5,6>] }");
  EXPECT_EQ(points.value.positions, (Points{{4, 5, 6}}));
  EXPECT_THAT(eachInEnglish(points.notes),
              ElementsAre(HasSubstr("passed over: 'Tapered'"),
                          HasSubstr("3 points in objects that the scene bends")));
}

TEST(ReadGeom, TakesShapesAloneWhereThereAreSome) {
  const std::string scene = "PointSet a { PointList [OX] } Translated b { Translation <1,2,3> "
                            "Geometry a } PointSet c { PointList [OZ] }";
  EXPECT_EQ(importGeom(scene).value.positions, (Points{{2, 2, 3}, {0, 0, 1}})) << "a is in b";
  EXPECT_EQ(importGeom(scene + " Shape { c, Red } Shape s { a }").value.positions,
            (Points{{0, 0, 1}, {1, 0, 0}}));
}

TEST(ReadGeom, LeavesOutShapesOfAnInnerScene) {
  const Imported<RawPoints> points = importGeom(
      "Inline i { Translation <9,9,9> Scene { PointSet a { PointList [OX] } Shape s { Geometry a } "
      "} } Shape t { Geometry PointSet { PointList [OY] } }");
  EXPECT_EQ(points.value.positions, (Points{{0, 1, 0}}));
  EXPECT_THAT(eachInEnglish(points.notes),
              ElementsAre(HasSubstr("passed over: 'Inline'"), HasSubstr("1 point in")));
}

TEST(ReadGeom, PassesOverWhatLeadsToNoPoints) {
  const Imported<RawPoints> points = importGeom(
      "Extrusion e { Axis Polyline { PointList [OX, OY] } CrossSection Polyline2D p { PointList "
      "[<0, :cos(3*Pi)/2>] } Scale [<1,1>] Solid True }\n"
      "Text t { String \"a } b\" }\n:echo points follow\n"
      "Group g { Skeleton Polyline { PointList [OX] } GeometryList [ PointSet { PointList [OZ] } ] "
      "}");
  EXPECT_EQ(points.value.positions, (Points{{0, 0, 1}}));
  EXPECT_THAT(eachInEnglish(points.notes),
              ElementsAre(HasSubstr("passed over: 'Extrusion', 'Polyline', 'Polyline2D', "
                                    "'Text'")));
}

TEST(ReadGeom, RefusesWhatItCannotReadAndNamesTheLine) {
  EXPECT_THAT(refusalOfGeom("\nTeapot { }"), HasSubstr("oak.geom, line 2: expected an object"));
  EXPECT_THAT(refusalOfGeom("PointSet a {\nPointList [\n<1,2>] }"),
              HasSubstr("line 3: expected ',', found '>'"));
  EXPECT_THAT(refusalOfGeom("PointSet a { PointList [<1,two,3>] }"),
              HasSubstr("expected a number"));
  EXPECT_THAT(refusalOfGeom("PointSet a { ColorList [<1,2,256>] }"),
              HasSubstr("not between 0 and 255"));
  EXPECT_THAT(refusalOfGeom("PointSet a { ColorList [Mauve] }"), HasSubstr("expected a color"));
  EXPECT_THAT(refusalOfGeom("Shape s {\nGeometry cloud }"), HasSubstr("line 2: refers to 'cloud'"));
  EXPECT_THAT(refusalOfGeom("(# no end"), HasSubstr("has no end #)"));
  EXPECT_THAT(refusalOfGeom("Text t { String \"no end\n\" }"), HasSubstr("line 1: a quoted text"));
  EXPECT_THAT(refusalOfGeom(":include other.geom"), HasSubstr("':include' is not read"));
  EXPECT_THAT(refusalOfGeom(":define x(a) { a }"), HasSubstr("':define' is not read"));
  EXPECT_THAT(refusalOfGeom("PointSet a { PointList [OX]"),
              HasSubstr("line 1: ends within an object"));
}

TEST(ReadGeom, ReadsOrRefusesAFileCutShortAnywhere) {
  const std::string text = test::geomFile();
  int refused = 0;
  for (std::size_t size = 0; size < text.size(); ++size)
    refused += refusalOfGeom(text.substr(0, size)).empty() ? 0 : 1;
  EXPECT_GT(refused, static_cast<int>(text.size() / 2));
}

TEST(ReadGeom, RefusesDepthsThatNoSceneHas) {
  std::string nested = "Shape { Geometry ";
  std::string skipped = "Tapered a { Primitive ";
  for (int i = 0; i < 100000; ++i) {
    nested += "Translated { Geometry ";
    skipped += "Swung { ";
  }
  EXPECT_THAT(refusalOfGeom(nested), HasSubstr("nested deeper than 64"));
  EXPECT_THAT(refusalOfGeom(skipped), HasSubstr("nested deeper than 64"));
  std::string chain = "PointSet n0 { PointList [OX] }"; // deep through names
  for (int i = 1; i < 100; ++i)
    chain += "\nTranslated n" + std::to_string(i) + " { Geometry n" + std::to_string(i - 1) + " }";
  EXPECT_THAT(refusalOfGeom(chain), HasSubstr("line 66: objects are nested deeper than 64"));
}

// Each of 40 groups holds the one before twice: 2^40 points.
TEST(ReadGeom, RefusesPointsThatGrowByBeingShared) {
  std::string text = "PointSet n0 { PointList [OX] }";
  for (int i = 1; i <= 40; ++i) {
    const std::string before = "n" + std::to_string(i - 1);
    text += " Group n" + std::to_string(i) + " { GeometryList [ " + before + ", " + before + " ] }";
  }
  EXPECT_THAT(refusalOfGeom(text), HasSubstr("repeats its 1 points more than 16 times"));
}

TEST(ReadGeom, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  std::istringstream in(test::geomFile());
  EXPECT_THROW((void)readGeom(in, "oak.geom", Progress(stop.get_token(), {})), Cancelled);
}

} // namespace
} // namespace espalier
