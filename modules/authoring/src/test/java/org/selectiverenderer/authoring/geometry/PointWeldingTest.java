package org.selectiverenderer.authoring.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.source.DocumentElement;

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
                + " welded, the file is smaller and looks the same");
    assertThat(GeometryRepair.ofMessage(found.get(0).message(), faces(document)))
        .contains(GeometryRepair.Kind.WELD);
  }
}
