package org.selectiverenderer.authoring.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.editing.FindingSuppression;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

class PointWeldingTest {
  /** Two triangles of a square, whose points 1 and 2 are repeated as 4 and 3. */
  private static final String SQUARE = "0 0 0, 1 0 0, 0 1 0, 0.0000001 1 0, 1 0 0, 1 1 0";

  private static SceneDocument document(String content) throws IOException {
    String text = "<X3D version='4.0'><Scene>\r\n  " + content + "\r\n</Scene></X3D>\r\n";
    return SceneDocument.of("mesh.x3d", text.getBytes(StandardCharsets.UTF_8));
  }

  private static DocumentElement faces(SceneDocument document) {
    DocumentElement[] found = new DocumentElement[1];
    document
        .tree()
        .orElseThrow()
        .root()
        .visit(
            element -> {
              if (found[0] == null && GeometryRepair.INDEXED.contains(element.name())) {
                found[0] = element;
              }
            });
    return found[0];
  }

  private static String welded(String content) throws IOException {
    SceneDocument document = document(content);
    String before = document.text().toString();
    document.perform(new GeometryRepair(document).edit(GeometryRepair.Kind.WELD, faces(document)));
    String after = document.text().toString();
    assertThat(document.history().names()).hasSize(1);
    assertThat(new RepeatedPointsCheck().check(document.snapshot())).isEmpty();
    document.history().undo();
    assertThat(document.text().toString()).isEqualTo(before);
    return after.substring(after.indexOf("\r\n  ") + 4, after.lastIndexOf("\r\n</Scene>"));
  }

  @Test
  void equalPointsBecomeOneAndOtherIndicesStay() throws IOException {
    assertThat(
            welded(
                "<IndexedFaceSet coordIndex='0 1 2 -1,  3 4  5 -1' texCoordIndex='0 1 2 -1 3 4 5'>"
                    + "<Coordinate DEF='C' point='"
                    + SQUARE
                    + "'/><TextureCoordinate point='0 0 1 0 0 1 .5 .5 1 0 1 1'/></IndexedFaceSet>"))
        .isEqualTo(
            "<IndexedFaceSet coordIndex='0 1 2 -1,  2 1  3 -1' texCoordIndex='0 1 2 -1 3 4 5'>"
                + "<Coordinate DEF='C' point='0 0 0, 1 0 0, 0 1 0, 1 1 0'/><TextureCoordinate"
                + " point='0 0 1 0 0 1 .5 .5 1 0 1 1'/></IndexedFaceSet>");
  }

  @Test
  void pointsWithOtherNormalsColoursOrTexturesStayApart() throws IOException {
    assertThat(
            welded(
                "<IndexedTriangleSet index='0 1 2 3 4 5'><Coordinate point='"
                    + SQUARE
                    + "'/><Normal vector='0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1'/>"
                    + "<Color color='1 0 0 1 0 0 1 0 0 1 0 0 0 1 0 1 0 0'/></IndexedTriangleSet>"))
        .isEqualTo(
            "<IndexedTriangleSet index='0 1 2 2 3 4'>"
                + "<Coordinate point='0 0 0, 1 0 0, 0 1 0, 1 0 0, 1 1 0'/>"
                + "<Normal vector='0 0 1 0 0 1 0 0 1 0 0 1 0 0 1'/>"
                + "<Color color='1 0 0 1 0 0 1 0 0 0 1 0 1 0 0'/></IndexedTriangleSet>");
  }

  @Test
  void theLastPointsGoToo() throws IOException {
    assertThat(
            welded(
                "<IndexedQuadSet normalPerVertex='false' index='0 1 2 3 4 5 2 1'><Coordinate"
                    + " point='0 0 0 1 0 0 1 1 0 0 1 0 0 0 0 1 0 0'/></IndexedQuadSet>"))
        .isEqualTo(
            "<IndexedQuadSet normalPerVertex='false' index='0 1 2 3 0 1 2 1'><Coordinate"
                + " point='0 0 0 1 0 0 1 1 0 0 1 0'/></IndexedQuadSet>");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "<IndexedFaceSet creaseAngle='1' coordIndex='0 1 2 -1 3 4 5'><Coordinate point='%s'/>"
            + "</IndexedFaceSet>",
        "<IndexedTriangleSet index='0 1 2 3 4 5'><Coordinate point='%s'/></IndexedTriangleSet>",
        "<IndexedFaceSet coordIndex='0 1 2 -1 3 4 5'><Coordinate DEF='C' point='%s'/>"
            + "</IndexedFaceSet><PointSet><Coordinate USE='C'/></PointSet>",
        "<Coordinate DEF='C' point='%s'/><IndexedFaceSet coordIndex='0 1 2'><Coordinate USE='C'/>"
            + "</IndexedFaceSet>",
        "<IndexedFaceSet coordIndex='0 1 2 -1 3 4 5'><Coordinate DEF='C' point='%s'/>"
            + "</IndexedFaceSet><ROUTE fromNode='I' fromField='value_changed' toNode='C'"
            + " toField='point'/>",
        "<IndexedFaceSet coordIndex='0 1 2 -1 3 4 5'><Coordinate point='%s'/>"
            + "<FogCoordinate depth='0 1 2 3 4 5'/></IndexedFaceSet>",
        "<IndexedFaceSet coordIndex='0 1 2 -1 3 4 9'><Coordinate point='%s'/></IndexedFaceSet>",
        "<IndexedFaceSet coordIndex='0 1 2'><Coordinate point='0 0 0 1 0 0 0 1 0'/>"
            + "</IndexedFaceSet>",
        "<IndexedFaceSet coordIndex='0 1 2'/>",
        "<ProtoDeclare name='P'><ProtoInterface><field accessType='initializeOnly' type='MFInt32'"
            + " name='f'/></ProtoInterface><ProtoBody><IndexedFaceSet coordIndex='0 1 2 -1 3 4 5'>"
            + "<IS><connect nodeField='coordIndex' protoField='f'/></IS><Coordinate point='%s'/>"
            + "</IndexedFaceSet></ProtoBody></ProtoDeclare>",
        "<IndexedFaceSet DEF='F' coordIndex='0 1 2 -1 3 4 5'><Coordinate point='%s'/>"
            + "</IndexedFaceSet><ROUTE fromNode='I' fromField='faces' toNode='F'"
            + " toField='set_coordIndex'/>",
        "<IndexedFaceSet DEF='F' coordIndex='0 1 2 -1 3 4 5'><Coordinate point='%s'/>"
            + "</IndexedFaceSet><EXPORT localDEF='F'/>",
        "<IndexedFaceSet coordIndex='0 1 2 -1 3 4 5'><Coordinate point='%s'/>"
            + "<Color DEF='F' color='1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 0 0'/>"
            + "</IndexedFaceSet><ROUTE fromNode='I' fromField='colours' toNode='F'"
            + " toField='color'/>",
      })
  void whatWouldChangeThePictureOrOtherNodesIsRefusedAndNotFound(String content)
      throws IOException {
    SceneDocument document = document(content.formatted(SQUARE));
    GeometryRepair repair = new GeometryRepair(document);
    assertThatThrownBy(() -> repair.edit(GeometryRepair.Kind.WELD, faces(document)))
        .isInstanceOf(EditRejectedException.class);
    assertThat(new RepeatedPointsCheck().check(document.snapshot())).isEmpty();
  }

  @Test
  void aRouteToTheSameNameInAnotherScopeIsNoHindrance() throws IOException {
    SceneDocument document =
        document(
            "<ProtoDeclare name='P'><ProtoBody><IndexedFaceSet DEF='F'/><ROUTE fromNode='I'"
                + " fromField='f' toNode='F' toField='set_coordIndex'/></ProtoBody></ProtoDeclare>"
                + "<IndexedFaceSet DEF='F' coordIndex='0 1 2 -1 3 4 5'><Coordinate point='"
                + SQUARE
                + "'/></IndexedFaceSet>");
    DocumentElement outer =
        document
            .tree()
            .orElseThrow()
            .named("F", document.tree().orElseThrow().root())
            .orElseThrow();
    document.perform(new GeometryRepair(document).edit(GeometryRepair.Kind.WELD, outer));
    assertThat(document.text()).asString().contains("coordIndex='0 1 2 -1 2 1 3'");
  }

  @Test
  void whatAPrototypeSetsIsNamedInTheRefusal() throws IOException {
    SceneDocument document =
        document(
            "<IndexedFaceSet coordIndex='0 1 2 -1 3 4 5'><Coordinate point='"
                + SQUARE
                + "'><IS><connect nodeField='point' protoField='p'/></IS></Coordinate>"
                + "</IndexedFaceSet>");
    assertThatThrownBy(
            () -> new GeometryRepair(document).edit(GeometryRepair.Kind.WELD, faces(document)))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("fields of the prototype")
        .hasMessageNotContaining("routes");
  }

  @Test
  void aPointWithoutAFaceDoesNotWidenTheTolerance() throws IOException {
    String chair =
        "<IndexedFaceSet coordIndex='0 1 2 -1 0 2 3 -1'><Coordinate"
            + " point='0 0 0 0.4 0 0 0.4 0.4 0 0 0.4 0 1e6 1e6 1e6'/></IndexedFaceSet>";
    SceneDocument document = document(chair);
    assertThat(new RepeatedPointsCheck().check(document.snapshot())).isEmpty();
    assertThatThrownBy(
            () -> new GeometryRepair(document).edit(GeometryRepair.Kind.WELD, faces(document)))
        .hasMessageContaining("nothing to do");
  }

  /** A watch on a tower 2 km high: its edges are shorter than a millionth of the whole. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "<IndexedFaceSet coordIndex='0 1 2 -1 3 4 5 6 -1'><Coordinate point='%s'/></IndexedFaceSet>",
        "<IndexedQuadSet normalPerVertex='false' index='0 1 2 0 3 4 5 6'><Coordinate point='%s'/>"
            + "</IndexedQuadSet>",
        "<IndexedTriangleSet normalPerVertex='false' index='0 1 2 3 4 5 3 5 6'><Coordinate"
            + " point='%s'/></IndexedTriangleSet>",
      })
  void noEdgeIsWeldedAway(String content) throws IOException {
    SceneDocument document =
        document(
            content.formatted(
                "0 0 0 2000 0 0 0 2000 0 0 0 0.01 0.001 0 0.01 0.001 0.001 0.01 0 0.001 0.01"));
    assertThat(new RepeatedPointsCheck().check(document.snapshot())).isEmpty();
  }

  @Test
  void repeatedPointsAreFoundWithTheToleranceAndWhereTheyAre() throws IOException {
    SceneDocument document =
        document(
            "<IndexedFaceSet DEF='Top' coordIndex='0 1 2 -1 3 4 5'><Coordinate point='"
                + SQUARE
                + "'/></IndexedFaceSet>");
    List<Problem> found = new RepeatedPointsCheck().check(document.snapshot());
    assertThat(found).hasSize(1);
    assertThat(found.get(0).severity()).isEqualTo(Problem.Severity.INFO);
    assertThat(found.get(0).location()).isEqualTo(document.location(faces(document).start()));
    assertThat(found.get(0).message())
        .isEqualTo(
            "2 of 6 points of IndexedFaceSet Top repeat another within 0.000001414;"
                + " welded, the file is smaller and looks the same [SR208]");
    assertThat(GeometryRepair.of("SR208", faces(document))).contains(GeometryRepair.Kind.WELD);
  }

  @Test
  void aSmallToleranceHasFourDigits() throws IOException {
    SceneDocument document =
        document(
            "<IndexedFaceSet coordIndex='0 1 2 -1 3 4 5'><Coordinate point='0 0 0 1e-5 0 0 0 1e-5"
                + " 0 0 1e-5 0 1e-5 0 0 1e-5 1e-5 0'/></IndexedFaceSet>");
    assertThat(new RepeatedPointsCheck().check(document.snapshot()))
        .singleElement()
        .satisfies(found -> assertThat(found.message()).contains("within 1.414E-11;"));
  }

  private static String mesh(String def) {
    return "<Shape><IndexedFaceSet DEF='"
        + def
        + "' coordIndex='0 1 2 -1 3 4 5'><Coordinate point='"
        + SQUARE
        + "'/></IndexedFaceSet></Shape>\r\n  ";
  }

  @Test
  void manyMeshesAreOneFindingOfTheScene() throws IOException {
    SceneDocument document = document(mesh("A") + mesh("B") + mesh("C") + mesh("D"));
    assertThat(new RepeatedPointsCheck().check(document.snapshot()))
        .singleElement()
        .satisfies(
            found -> {
              assertThat(found.location().line()).isZero();
              assertThat(found.message())
                  .startsWith("4 meshes hold 8 repeated points, first IndexedFaceSet A in line 2;")
                  .endsWith("[SR208]");
            });
    assertThat(new RepeatedPointsCheck().check(document(mesh("A") + mesh("B")).snapshot()))
        .hasSize(3);
    assertThat(GeometryRepair.of("SR208", document.tree().orElseThrow().root()))
        .contains(GeometryRepair.Kind.WELD_ALL);
  }

  @Test
  void allAreWeldedInOneStepButThoseThatAreAcceptedOrShared() throws IOException {
    String accepted = "<!-- validate-ignore SR208: wanted: so -->\r\n  " + mesh("A");
    String group = "<!--validate-ignore SR1 SR2--><Group>" + mesh("B") + "</Group>";
    String shared =
        mesh("E").replace("<Coordinate ", "<Coordinate DEF='P' ")
            + "<Shape><PointSet><Coordinate USE='P'/></PointSet></Shape>";
    String other = "<!-- validate-ignore SR207: another rule --> " + mesh("C");
    SceneDocument document = document(accepted + group + shared + other + mesh("D"));
    String before = document.text().toString();
    assertThat(new RepeatedPointsCheck().check(document.snapshot()))
        .extracting(Problem::message)
        .hasSize(3)
        .anyMatch(message -> message.startsWith("2 meshes hold 4 repeated points"))
        .anyMatch(message -> message.contains("IndexedFaceSet C"))
        .anyMatch(message -> message.contains("IndexedFaceSet D"));
    DocumentElement root = document.tree().orElseThrow().root();
    GeometryRepair repair = new GeometryRepair(document);
    document.perform(repair.edit(GeometryRepair.Kind.WELD_ALL, root));
    assertThat(document.history().names()).containsExactly("Weld all: 4 points of 2 meshes");
    String after = document.text().toString();
    assertThat(after).contains(accepted + group + shared + "<!-- validate-ignore SR207");
    assertThat(after.split("point='0 0 0, 1 0 0, 0 1 0, 1 1 0'", -1)).hasSize(3);
    assertThat(new RepeatedPointsCheck().check(document.snapshot())).isEmpty();
    assertThatThrownBy(
            () -> repair.edit(GeometryRepair.Kind.WELD_ALL, document.tree().orElseThrow().root()))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("nothing to do");
    document.history().undo();
    assertThat(document.text().toString()).isEqualTo(before);
  }

  @Test
  void aCommentBeforeTheRootAcceptsThoseOfTheWholeScene() throws IOException {
    SceneDocument document = document(mesh("A") + mesh("B") + mesh("C") + mesh("D"));
    document.perform(
        new FindingSuppression(document).suppress("SR208", document.tree().orElseThrow().root()));
    assertThat(new RepeatedPointsCheck().check(document.snapshot())).isEmpty();
  }

  @Test
  void onlyFacesThatChangedAreSearchedAnew() throws IOException {
    SceneDocument document = document(mesh("A") + mesh("B") + mesh("C") + mesh("D"));
    List<String> searched = new ArrayList<>();
    RepeatedPointsCheck check =
        new RepeatedPointsCheck(1_000_000, faces -> searched.add(faces.def().orElseThrow()));
    check.check(document.snapshot());
    assertThat(searched).containsExactly("A", "B", "C", "D");
    searched.clear();
    DocumentElement b = document.tree().orElseThrow().named("B").orElseThrow();
    document.perform(new GeometryRepair(document).edit(GeometryRepair.Kind.WELD, b));
    List<Problem> found = check.check(document.snapshot());
    assertThat(searched).containsExactly("B");
    assertThat(found).anyMatch(problem -> problem.message().startsWith("3 meshes hold 6"));
    // What connects faces with others is looked at each time.
    searched.clear();
    int end = document.text().toString().indexOf("</Scene>");
    document.perform(
        new Edit(
            "Route",
            List.of(
                TextEdit.insert(
                    end,
                    "<ROUTE fromNode='X' fromField='f' toNode='C' toField='set_coordIndex'/>"))));
    assertThat(check.check(document.snapshot()))
        .anyMatch(problem -> problem.message().startsWith("2 meshes hold 4"));
    assertThat(searched).isEmpty();
  }

  @Test
  void aSearchEndsWhenItsThreadIsInterrupted() throws IOException {
    SceneDocument document =
        document(
            "<IndexedFaceSet coordIndex='0 1 2 -1 3 4 5'><Coordinate point='"
                + SQUARE
                + "'/></IndexedFaceSet>");
    DocumentSnapshot snapshot = document.snapshot();
    Thread.currentThread().interrupt();
    try {
      assertThatThrownBy(() -> new RepeatedPointsCheck().check(snapshot))
          .isInstanceOf(CancellationException.class);
    } finally {
      assertThat(Thread.interrupted()).as("left for who runs it").isTrue();
    }
  }

  @Test
  void facesBeyondTheMostTextOfASceneAreNotSearched() throws IOException {
    String faces =
        "<IndexedFaceSet coordIndex='0 1 2 -1 3 4 5'><Coordinate point='"
            + SQUARE
            + "'/></IndexedFaceSet>\n";
    DocumentSnapshot snapshot = document(faces.repeat(3)).snapshot();
    assertThat(new RepeatedPointsCheck(2 * faces.length() + 5, each -> {}).check(snapshot))
        .anyMatch(problem -> problem.message().startsWith("2 meshes"));
    assertThat(new RepeatedPointsCheck().check(snapshot))
        .anyMatch(problem -> problem.message().startsWith("3 meshes"));
  }
}
