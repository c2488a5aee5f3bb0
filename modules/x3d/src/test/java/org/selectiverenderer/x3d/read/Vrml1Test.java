package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.source.SceneEncoding;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.tessellate.TransformMatrix;
import org.selectiverenderer.x3d.write.SceneFormat;

/** VRML 1.0, whose nodes change a state, as the X3D elements that show the same. */
class Vrml1Test {
  private final ReaderFixture fixture = new ReaderFixture();

  /** A scene whose content starts at the second line. */
  private X3dFile scene(String content) {
    return fixture.read("#VRML V1.0 ascii\n" + content);
  }

  private static XmlDocument document(String content) {
    byte[] bytes = ("#VRML V1.0 ascii\n" + content).getBytes(StandardCharsets.UTF_8);
    try {
      return new X3dReader(NodeCatalogue.load())
          .document("s.wrl", new ByteArrayInputStream(bytes), bytes.length);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  /** The elements within the scene as XML would have them, a line each. */
  private static List<String> lines(String content) {
    List<String> lines = new ArrayList<>();
    for (DocumentElement element : document(content).elements()) {
      StringBuilder line = new StringBuilder();
      int depth = 0;
      for (var at = element.parent(); at.isPresent(); at = at.get().parent()) {
        depth++;
      }
      line.append(" ".repeat(Math.max(0, depth - 2))).append(element.name());
      element
          .attributes()
          .forEach(a -> line.append(' ').append(a.name()).append('=').append(a.text()));
      if (depth > 1) {
        lines.add(line.toString());
      }
    }
    return lines;
  }

  private void assertProblems(String content, String... expected) {
    scene(content);
    fixture.assertMessages(expected);
  }

  @Test
  void theEncodingIsSeenFromTheFirstLine() {
    assertThat(document("Cube {}").encoding()).isEqualTo(SceneEncoding.VRML1);
    assertThat(document("Cube {}").encoding().title()).isEqualTo("VRML 1.0");
    DocumentElement root = document("Cube {}").root().orElseThrow();
    assertThat(root.text("version")).contains("4.0");
    assertThat(root.text("profile")).contains("Immersive");
  }

  @Test
  void aTransformationMovesWhatFollowsUpToTheEndOfTheSeparator() {
    assertThat(
            lines(
                """
                Separator {
                  Translation { translation 1 2 3 } Cube { width 4 }
                  Translation { translation 0 1.5 0 } Sphere { radius 2 }
                }
                Cone {}
                """))
        .containsExactly(
            "Transform translation=1 2 3",
            " Shape",
            "  Appearance",
            "   Material",
            "  Box size=4 2 2",
            " Transform translation=0 1.5 0",
            "  Shape",
            "   Appearance",
            "    Material",
            "   Sphere radius=2",
            "Shape",
            " Appearance",
            "  Material",
            " Cone");
  }

  @Test
  void translationRotationAndScaleInThisOrderAreOneTransform() {
    assertThat(
            lines(
                "Separator { Translation { translation 1 0 0 } Rotation { rotation 0 1 0 1.57 }"
                    + " Scale { scaleFactor 1 2 1 } Cylinder { height 3 } }"))
        .startsWith(
            "Transform translation=1 0 0 rotation=0 1 0 1.57 scale=1 2 1", " Shape", "  Appearance")
        .endsWith("  Cylinder height=3");
  }

  @Test
  void otherOrdersOfTransformationsBecomeOneMatrix() {
    assertThat(
            lines(
                "Separator { Rotation { rotation 0 0 1 1.5707963 } Translation { translation 1 0 0"
                    + " } Sphere {} }"))
        .startsWith("Transform translation=0 1 0 rotation=0 0 1 1.5707963");
    assertThat(
            lines(
                "Separator { MatrixTransform { matrix 2 0 0 0 0 3 0 0 0 0 4 0 5 6 7 1 } Sphere {}"
                    + " }"))
        .startsWith("Transform translation=5 6 7 scale=2 3 4");
    assertThat(
            lines(
                "Separator { Transform { translation 1 2 3 center 1 0 0 scaleOrientation 0 1 0 1"
                    + " scaleFactor 1 2 3 } Sphere {} }"))
        .startsWith(
            "Transform translation=1 2 3 center=1 0 0 scaleOrientation=0 1 0 1 scale=1 2 3");
  }

  @Test
  void aMatrixThatShearsKeepsItsShear() {
    X3dFile file =
        scene("Separator { MatrixTransform { matrix 1 0 0 0 1 1 0 0 0 0 1 0 0 0 0 1 } Cube {} }");
    fixture.assertClean();
    ParsedNode transform = file.nodes().get(0);
    Vector3d moved =
        TransformMatrix.of(transform, new Matrix4d()).transformPosition(new Vector3d(0, 1, 0));
    assertThat(moved.distance(1, 1, 0)).isLessThan(1e-5);
  }

  @Test
  void aTransformSeparatorKeepsTheMaterialAndAGroupKeepsAll() {
    assertThat(
            lines(
                """
                TransformSeparator { Translation { translation 1 0 0 } Material { diffuseColor 1 0 0 } }
                Group { Translation { translation 0 2 0 } }
                Sphere {}
                """))
        .containsExactly(
            "Transform translation=0 2 0",
            " Shape",
            "  Appearance",
            "   Material diffuseColor=1 0 0",
            "  Sphere");
  }

  @Test
  void aMaterialCountsForWhatFollowsAndIsSharedByItsName() {
    assertThat(
            lines(
                "Material { diffuseColor 1 0 0 shininess 0.5 transparency .25 } Cube {} Sphere {}"))
        .containsExactly(
            "Shape",
            " Appearance DEF=Appearance_1",
            "  Material diffuseColor=1 0 0 shininess=0.5 transparency=.25",
            " Box",
            "Shape",
            " Appearance USE=Appearance_1",
            " Sphere");
  }

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

  @Test
  void theCamerasOfASwitchAreViewpointsOfWhichTheChosenOneIsFirst() {
    assertThat(
            lines(
                """
                DEF Cameras Switch {
                  whichChild 1
                  DEF Front PerspectiveCamera { position 0 0 9 heightAngle 0.5 }
                  DEF Top OrthographicCamera { position 0 9 0 orientation 1 0 0 -1.57 height 6 }
                }
                Cube {}
                """))
        .containsSequence(
            "OrthoViewpoint DEF=Top description=Top position=0 9 0 orientation=1 0 0 -1.57 "
                + "fieldOfView=-3 -3 3 3",
            "Viewpoint DEF=Front description=Front position=0 0 9 fieldOfView=0.5");
  }

  @Test
  void aLightShinesOnWhatFollowsOnly() {
    assertThat(
            lines(
                """
                Separator {
                  Cube {}
                  Translation { translation 1 0 0 }
                  PointLight { location 0 5 0 intensity 0.5 }
                  Sphere {}
                }
                DirectionalLight { direction 0 -1 0 on FALSE }
                """))
        .containsExactly(
            "Group",
            " Shape",
            "  Appearance",
            "   Material",
            "  Box",
            " Transform translation=1 0 0",
            "  PointLight location=0 5 0 intensity=0.5 global=false radius=1000000",
            "  Shape",
            "   Appearance",
            "    Material",
            "   Sphere",
            "Group",
            " DirectionalLight direction=0 -1 0 on=false");
  }

  @Test
  void aSpotLightKeepsItsCone() {
    assertThat(lines("SpotLight { cutOffAngle 0.6 }"))
        .containsExactly("SpotLight cutOffAngle=0.6 beamWidth=0.6 global=false radius=1000000");
  }

  @Test
  void aSwitchKeepsItsChoicesAndItsChosenPropertiesCount() {
    assertThat(
            lines(
                """
                DEF Version Switch {
                  whichChild 1
                  Cube {}
                  Separator { Sphere {} Cone {} }
                }
                """))
        .containsExactly(
            "Switch DEF=Version whichChoice=1",
            " Shape",
            "  Appearance",
            "   Material",
            "  Box",
            " Group",
            "  Shape",
            "   Appearance",
            "    Material",
            "   Sphere",
            "  Shape",
            "   Appearance",
            "    Material",
            "   Cone");
    assertThat(
            lines(
                "Switch { whichChild 0 Material { diffuseColor 1 0 0 } Material { diffuseColor 0 1"
                    + " 0 } } Cube {}"))
        .containsExactly("Shape", " Appearance", "  Material diffuseColor=1 0 0", " Box");
    assertThat(lines("Switch { whichChild -3 Cube {} Sphere {} }")).contains("  Box", "  Sphere");
  }

  @Test
  void levelsInlinesAndAnchorsAreThoseOfX3d() {
    assertThat(
            lines(
                """
                LOD { range [ 10, 20 ] center 1 0 0 Cube {} Info {} WWWInline { name "far.wrl" } }
                WWWAnchor { name "next.wrl#Front" description "on" Cube {} }
                """))
        .containsExactly(
            "LOD range=10, 20 center=1 0 0",
            " Shape",
            "  Appearance",
            "   Material",
            "  Box",
            " Group",
            " Inline url=\"far.wrl\"",
            "Anchor url=\"next.wrl#Front\" description=on",
            " Shape",
            "  Appearance",
            "   Material",
            "  Box");
  }

  @Test
  void informationOfViewersIsRead() {
    assertThat(
            lines(
                "DEF BackgroundColor Info { string \"0.1 0.2 0.3\" } DEF Viewer Info { string"
                    + " \"examiner\" } Info { string \"made by hand\" }"))
        .containsExactly(
            "Background DEF=BackgroundColor skyColor=0.1 0.2 0.3",
            "NavigationInfo DEF=Viewer type=\"EXAMINE\" \"ANY\"",
            "WorldInfo info=\"made by hand\"");
  }

  @Test
  void anObjectIsUsedAgainWhereItLooksTheSame() {
    assertThat(
            lines(
                """
                DEF Wheel Separator { Material { diffuseColor 1 0 0 } Cylinder {} }
                Separator { Translation { translation 2 0 0 } Material {} USE Wheel }
                """))
        .containsExactly(
            "Group DEF=Wheel",
            " Shape",
            "  Appearance",
            "   Material diffuseColor=1 0 0",
            "  Cylinder",
            "Transform translation=2 0 0",
            " Group USE=Wheel");
  }

  @Test
  void anObjectIsCopiedWhereAnotherMaterialCounts() {
    assertThat(
            lines(
                """
                DEF Ball Sphere {}
                Material { diffuseColor 1 0 0 }
                USE Ball
                """))
        .containsExactly(
            "Shape DEF=Ball",
            " Appearance",
            "  Material",
            " Sphere",
            "Shape DEF=Ball_2",
            " Appearance",
            "  Material diffuseColor=1 0 0",
            " Sphere");
  }

  @Test
  void aCoordinateIsWrittenOnce() {
    assertThat(
            lines(
                """
                Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] }
                IndexedFaceSet { coordIndex [ 0 1 2 -1 ] }
                IndexedFaceSet { coordIndex [ 2 1 0 -1 ] }
                """))
        .contains(
            "  Coordinate DEF=Coordinate_1 point=0 0 0, 1 0 0, 1 1 0",
            "  Coordinate USE=Coordinate_1");
  }

  @Test
  void commentsStayBeforeWhatTheyPreceded() {
    assertThat(document("# one\nCube {}\n# two\nSphere {}").comments())
        .extracting(comment -> comment.text() + " before " + comment.before())
        .containsExactly(" one before Shape", " two before Shape");
  }

  @Test
  void whatIsNotOfVrml1IsToldOnceForEachType() {
    assertProblems(
        """
        Separator {
          Blob { fields [ SFFloat size, MFString names ] size 3 names [ "a", "b" ] Cube {} }
          Blob { size 4 }
          Big { fields [ SFFloat width, MFString isA ] isA [ "Huge", "Cube" ] width 4 }
          Cube { colour 3 depth 2 }
          USE Nothing
        }
        """,
        "test.x3d:7:3: no node before this one has the name 'Nothing'; the USE is left out",
        "test.x3d:3:3: the node type 'Blob' is not one of VRML 1.0; such nodes are left out",
        "test.x3d:6:10: a Cube of VRML 1.0 has no field 'colour'; it is left out");
    assertThat(lines("Big { fields [ SFFloat width ] isA [ \"Huge\", \"Cube\" ] width 4 }"))
        .contains(" Box size=4 2 2");
  }

  @Test
  void faultsOfValuesAreToldAtTheirPlaces() {
    assertProblems(
        "Separator {\n  Material { diffuseColor 1 x 0 } Cube {}\n}",
        "test.x3d:3:27: diffuseColor: 3 numbers are needed, not 1; the default is used",
        "test.x3d:3:29: a Material of VRML 1.0 has no field 'x'; it is left out");
    scene("Coordinate3 { point [ 0 0 0, 1 0 abc ] }\nIndexedFaceSet { coordIndex [ 0 1 7 -1 ] }");
    assertThat(fixture.problems.list())
        .extracting(Problem::toString)
        .anyMatch(line -> line.startsWith("test.x3d:2:34:"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "Separator { Cube {} Sphere {          | 2:29: the file is cut off here",
        "Separator { Cube {} Sphere { radius ] | 2:37:",
        "Separator { Cube {} 3 } Sphere {}     | 2:23: the value of the field '3' is expected",
        "Separator { Cube {} AsciiText { string \"a } | 2:40: the string that begins here",
        "Separator { Cube {} Coordinate3 { point [ 1 2 | 2:41: the list that begins here",
        "Separator { Cube {} Cone { parts (SIDES | 2:34:",
        "Separator { Cube {} DEF | 2:24:",
        "Separator { Cube {} } } | 2:23:",
      })
  void aBrokenTextKeepsWhatWasBefore(String text, String problem) {
    X3dFile file = scene(text);
    assertThat(file.nodes()).isNotEmpty();
    assertThat(fixture.problems.list())
        .singleElement()
        .satisfies(told -> assertThat(told.toString()).startsWith("test.x3d:" + problem))
        .satisfies(told -> assertThat(told.message()).endsWith("; the part before it is kept"));
  }

  @Test
  void partsOfPointsCountAsCopies() {
    String points = "Coordinate3 { point [ " + "0 0 0, ".repeat(20_000) + "] }";
    scene("Separator { " + points + "PointSet { startIndex 1 } ".repeat(400) + "}");
    assertThat(fixture.problems.list())
        .singleElement()
        .satisfies(told -> assertThat(told.message()).contains("these copies have more than"));
  }

  @Test
  void aFieldOfOneValueIsNotCopiedWholeForEachUse() {
    X3dFile file =
        scene(
            "Separator { DEF T Translation { translation 1 2 3 "
                + " ".repeat(1_000_000)
                + "} "
                + "Separator { USE T Cube { } } ".repeat(300)
                + "}");
    assertThat(file.nodes()).isNotEmpty();
    fixture.assertClean();
  }

  private static byte[] room() throws IOException {
    try (InputStream in = Vrml1Test.class.getResourceAsStream("vrml1-room.wrl")) {
      return Objects.requireNonNull(in).readAllBytes();
    }
  }

  @Test
  void aRoomOfAllNodeTypesIsReadAndConvertedWithoutProblems() throws IOException {
    X3dFile file = fixture.read(room());
    fixture.assertClean();
    assertThat(file.named()).containsKeys("Table", "Lamp", "Door", "Sign");
    XmlDocument room =
        new X3dReader(NodeCatalogue.load())
            .document("room.wrl", new ByteArrayInputStream(room()), 0);
    for (SceneFormat format : SceneFormat.values()) {
      ProblemCollector problems = new ProblemCollector();
      X3dFile again = fixture.read(format.text(room, NodeCatalogue.load(), problems));
      assertThat(problems.list()).isEmpty();
      fixture.assertClean();
      assertThat(again.named().keySet()).isEqualTo(file.named().keySet());
    }
  }

  @Test
  void aRoomCutAtAnyByteOrChangedIsReadAsFarAsItGoes() throws IOException {
    byte[] good = room();
    for (int length = 17; length < good.length; length += 37) {
      fixture.read(Arrays.copyOf(good, length));
    }
    Random random = new Random(5);
    for (int round = 0; round < 300; round++) {
      byte[] bytes = good.clone();
      for (int i = random.nextInt(4); i >= 0; i--) {
        int at = 17 + random.nextInt(bytes.length - 17);
        bytes[at] = (byte) "{}[]()#\"|, -1xA".charAt(random.nextInt(15));
      }
      fixture.read(bytes);
      assertThat(fixture.problems.list())
          .allSatisfy(told -> assertThat(told.message()).isNotBlank());
    }
  }

  @Test
  void nestingIsLimited() {
    X3dFile file = scene("Cube {} " + "Separator { Cube {} ".repeat(5000));
    assertThat(file.nodes()).isNotEmpty();
    assertThat(fixture.problems.list())
        .singleElement()
        .satisfies(told -> assertThat(told.message()).contains("nested more than 100 deep"));
  }

  @Test
  void objectsThatUseOneAnotherAreLimited() {
    StringBuilder bomb = new StringBuilder("DEF A0 Separator { Sphere {} }\n");
    for (int i = 1; i < 60; i++) {
      bomb.append("DEF A%d Separator { USE A%d ".formatted(i, i - 1));
      bomb.append("Material { shininess 0.%d } USE A%d }\n".formatted(i, i - 1));
    }
    X3dFile file = scene(bomb.toString());
    assertThat(file.nodes()).isNotEmpty();
    assertThat(fixture.problems.list())
        .singleElement()
        .satisfies(told -> assertThat(told.message()).contains("more than 10000"));
    scene(bomb.toString().replace("Sphere {}", ""));
    fixture.assertClean();
  }

  @Test
  void copiesOfLongListsAreLimited() {
    ReaderFixture large = new ReaderFixture(ReadLimits.standard());
    String text =
        "#VRML V1.0 ascii\nCoordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] }\nDEF Long IndexedFaceSet {"
            + " coordIndex [ "
            + "0 1 2 -1 ".repeat(20_000)
            + "] }\n"
            + "Material {} USE Long\n".repeat(2000);
    X3dFile file = large.read(text);
    assertThat(file.nodes()).isNotEmpty();
    assertThat(large.problems.list())
        .singleElement()
        .satisfies(told -> assertThat(told.message()).contains("16,777,216 characters"));
  }

  @Test
  void numbersBeyondAllMeasureStayNumbers() {
    assertThat(
            lines(
                "Separator { Scale { scaleFactor 1e38 1 1 } Scale { scaleFactor 1e38 1 1 } Texture2"
                    + " { image 1 1 1 0 } Texture2Transform { scaleFactor 1e-38 1e38 center 1e38"
                    + " 1e38 } Cube {} }"))
        .allSatisfy(line -> assertThat(line).doesNotContain("Inf").doesNotContain("NaN"))
        .contains(" Shape");
  }

  @Test
  void aNodeWithinItselfIsNoNode() {
    X3dFile file = scene("DEF A Separator { Cube {} USE A }");
    assertThat(file.nodes()).hasSize(1);
    fixture.assertOnly(
        "test.x3d:2:27: no node before this one has the name 'A'; the USE is left out");
  }

  @Test
  void aConvertedSceneIsReadWithoutProblems() {
    String text =
        SceneFormat.XML.text(
            document(
                "Separator { Translation { translation 1 2 3 } DEF A Cube {} Rotation { rotation 1 0"
                    + " 0 1 } USE A AsciiText { string \"x\" } SpotLight {} }"),
            NodeCatalogue.load(),
            new ProblemCollector());
    fixture.read(text);
    fixture.assertClean();
  }
}
