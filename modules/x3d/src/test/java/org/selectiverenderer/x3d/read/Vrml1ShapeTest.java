package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.lines;

import org.junit.jupiter.api.Test;

/** Shapes of VRML 1.0 with their coordinates, colours, normals, textures and texts. */
class Vrml1ShapeTest {
  @Test
  void facesTakeCoordinatesColoursNormalsAndHints() {
    assertThat(
            lines(
                """
                Separator {
                  DEF Points Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] }
                  Material { diffuseColor [ 1 0 0, 0 1 0 ] }
                  MaterialBinding { value PER_FACE_INDEXED }
                  Normal { vector [ 0 0 1, 0 0 -1 ] }
                  NormalBinding { value PER_FACE_INDEXED }
                  ShapeHints { vertexOrdering CLOCKWISE shapeType SOLID faceType UNKNOWN_FACE_TYPE }
                  IndexedFaceSet { coordIndex [ 0, 1, 2, -1, 0, 2, 3, -1 ] materialIndex [ 1, 0 ]
                                   normalIndex [ 0, 1 ] }
                }
                """))
        .containsExactly(
            "Shape",
            " Appearance",
            "  Material",
            " IndexedFaceSet coordIndex=0, 1, 2, -1, 0, 2, 3, -1 colorIndex=1, 0 "
                + "colorPerVertex=false normalIndex=0, 1 normalPerVertex=false ccw=false "
                + "convex=false creaseAngle=0.5",
            "  Coordinate DEF=Points point=0 0 0, 1 0 0, 1 1 0, 0 1 0",
            "  Color color=1 0 0, 0 1 0",
            "  Normal vector=0 0 1, 0 0 -1");
  }

  @Test
  void facesOfUnknownOrderAreSeenFromBothSides() {
    assertThat(
            lines(
                "Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] } IndexedFaceSet { coordIndex [ 0 1 2"
                    + " -1 ] }"))
        .contains(" IndexedFaceSet coordIndex=0 1 2 -1 solid=false creaseAngle=0.5");
  }

  @Test
  void coloursInTheOrderOfVerticesGetIndices() {
    assertThat(
            lines(
                """
                Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] }
                Material { diffuseColor [ 1 0 0, 0 1 0, 0 0 1 ] }
                MaterialBinding { value PER_VERTEX }
                IndexedFaceSet { coordIndex [ 0 1 2 -1 0 2 3 ] }
                """))
        .contains(
            " IndexedFaceSet coordIndex=0 1 2 -1 0 2 3 colorIndex=0 1 2 -1 0 1 2 solid=false "
                + "creaseAngle=0.5");
  }

  @Test
  void aSegmentOfItsOwnColourBecomesALine() {
    assertThat(
            lines(
                """
                Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] }
                Material { diffuseColor [ 1 0 0, 0 1 0 ] }
                MaterialBinding { value PER_PART }
                IndexedLineSet { coordIndex [ 0 1 2 -1 ] }
                """))
        .contains(" IndexedLineSet coordIndex=0 1 -1 1 2 -1 colorPerVertex=false");
  }

  @Test
  void linesAndPointsHaveTheDiffuseColourUnlit() {
    assertThat(
            lines(
                """
                Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] }
                Material { diffuseColor 1 0 0 }
                PointSet { startIndex 1 numPoints 2 }
                IndexedLineSet { coordIndex [ 0 1 2 -1 ] }
                """))
        .containsExactly(
            "Shape",
            " Appearance DEF=Appearance_1",
            "  Material emissiveColor=1 0 0",
            " PointSet",
            "  Coordinate point=1 0 0 1 1 0",
            "Shape",
            " Appearance USE=Appearance_1",
            " IndexedLineSet coordIndex=0 1 2 -1",
            "  Coordinate point=0 0 0, 1 0 0, 1 1 0");
  }

  @Test
  void coloursThatOnlyEmitAreNotLit() {
    assertThat(
            lines(
                """
                Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] }
                Material { ambientColor [] diffuseColor [] specularColor []
                           emissiveColor [ 1 0 0, 0 1 0, 0 0 1 ] }
                MaterialBinding { value PER_VERTEX_INDEXED }
                IndexedFaceSet { coordIndex [ 0 1 2 -1 ] }
                """))
        .containsExactly(
            "Shape",
            " Appearance",
            " IndexedFaceSet coordIndex=0 1 2 -1 solid=false creaseAngle=0.5",
            "  Coordinate point=0 0 0, 1 0 0, 1 1 0",
            "  Color color=1 0 0, 0 1 0, 0 0 1");
  }

  @Test
  void partsOfPrimitivesHaveTheirOwnMaterials() {
    assertThat(
            lines(
                """
                Material { diffuseColor [ 1 0 0, 0 1 0, 0 0 1 ] }
                MaterialBinding { value PER_PART }
                Cylinder { parts (SIDES | TOP) }
                """))
        .containsExactly(
            "Group",
            " Shape",
            "  Appearance",
            "   Material diffuseColor=1 0 0",
            "  Cylinder top=false bottom=false solid=false",
            " Shape",
            "  Appearance",
            "   Material diffuseColor=0 1 0",
            "  Cylinder side=false bottom=false solid=false");
    assertThat(
            lines(
                """
                Material { diffuseColor [ 1 0 0, 0 1 0, 0 0 1, 1 1 0, 0 1 1, 1 0 1 ] }
                MaterialBinding { value PER_PART }
                Cube { width 2 }
                """))
        .anyMatch(
            line -> line.startsWith(" IndexedFaceSet") && line.contains("colorPerVertex=false"))
        .contains("  Color color=1 0 0, 0 1 0, 0 0 1, 1 1 0, 0 1 1, 1 0 1");
  }

  @Test
  void texturesAndTheirCoordinatesAreKept() {
    assertThat(
            lines(
                """
                Texture2 { filename "wood.jpg" wrapS CLAMP }
                Texture2Transform { scaleFactor 2 2 }
                TextureCoordinate2 { point [ 0 0, 1 0, 1 1 ] }
                Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] }
                IndexedFaceSet { coordIndex [ 0 1 2 -1 ] textureCoordIndex [ 2 1 0 -1 ] }
                Texture2 { image 1 1 3 0xff0000 }
                Texture2Transform {}
                Cube {}
                """))
        .containsExactly(
            "Shape",
            " Appearance",
            "  Material",
            "  ImageTexture url=\"wood.jpg\" repeatS=false",
            "  TextureTransform scale=2 2",
            " IndexedFaceSet coordIndex=0 1 2 -1 texCoordIndex=2 1 0 -1 solid=false creaseAngle=0.5",
            "  Coordinate point=0 0 0, 1 0 0, 1 1 0",
            "  TextureCoordinate point=0 0, 1 0, 1 1",
            "Shape",
            " Appearance",
            "  Material",
            "  PixelTexture image=1 1 3 0xff0000",
            " Box");
  }

  @Test
  void aTextIsAsHighAsItsFontStyleSays() {
    assertThat(
            lines(
                "FontStyle { size 2 family TYPEWRITER style (BOLD | ITALIC) } AsciiText { string ["
                    + " \"one\", \"two\" ] justification CENTER spacing 1.5 }"))
        .contains(
            " Text string=\"one\", \"two\"",
            "  FontStyle size=2 family=\"TYPEWRITER\" style=BOLDITALIC spacing=1.5 "
                + "justify=\"MIDDLE\" \"FIRST\"");
    assertThat(lines("AsciiText { string \"one\" }"))
        .contains(" Text string=\"one\"", "  FontStyle size=10");
  }
}
