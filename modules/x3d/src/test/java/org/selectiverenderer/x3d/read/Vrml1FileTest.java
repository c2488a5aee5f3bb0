package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.document;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.lines;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.room;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.scene;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SceneEncoding;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneFormat;

/** Whole files of VRML 1.0: their encoding, comments and links, and what is told of them. */
class Vrml1FileTest {
  private final ReaderFixture fixture = new ReaderFixture();

  private void assertProblems(String content, String... expected) {
    scene(fixture, content);
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
    scene(
        fixture,
        "Coordinate3 { point [ 0 0 0, 1 0 abc ] }\nIndexedFaceSet { coordIndex [ 0 1 7 -1 ] }");
    assertThat(fixture.problems.list())
        .extracting(Problem::toString)
        .anyMatch(line -> line.startsWith("test.x3d:2:34:"));
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

  @Test
  void messagesHaveTheArticleThatFitsTheType() {
    assertProblems(
        "OrthographicCamera { width 3 } IndexedFaceSet { points 3 } LOD { far 3 } Cone { top 1 }",
        "test.x3d:2:22: an OrthographicCamera of VRML 1.0 has no field 'width'; it is left out",
        "test.x3d:2:49: an IndexedFaceSet of VRML 1.0 has no field 'points'; it is left out",
        "test.x3d:2:32: no Coordinate3 with points stands before this IndexedFaceSet, which shows"
            + " nothing",
        "test.x3d:2:66: an LOD of VRML 1.0 has no field 'far'; it is left out",
        "test.x3d:2:81: a Cone of VRML 1.0 has no field 'top'; it is left out");
  }
}
