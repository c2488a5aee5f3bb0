package org.selectiverenderer.authoring.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.editing.FindingSuppression;
import org.selectiverenderer.x3d.source.DocumentElement;

class GeometryRepairTest {
  private static SceneDocument document(String content) throws IOException {
    String text = "<X3D version='4.0'><Scene>\r\n  " + content + "\r\n</Scene></X3D>\r\n";
    return SceneDocument.of("mesh.x3d", text.getBytes(StandardCharsets.UTF_8));
  }

  private static DocumentElement first(SceneDocument document, String name) {
    DocumentElement[] found = new DocumentElement[1];
    document
        .tree()
        .orElseThrow()
        .root()
        .visit(
            element -> {
              if (found[0] == null && element.name().equals(name)) {
                found[0] = element;
              }
            });
    return found[0];
  }

  private static String repaired(String rule, String name, String content) throws IOException {
    SceneDocument document = document(content);
    String before = document.text().toString();
    DocumentElement element = first(document, name);
    GeometryRepair.Kind kind = GeometryRepair.of(rule, element).orElseThrow();
    document.perform(new GeometryRepair(document).edit(kind, element));
    String after = document.text().toString();
    document.history().undo();
    assertThat(document.text().toString()).isEqualTo(before);
    return after.substring(after.indexOf("\r\n  ") + 4, after.lastIndexOf("\r\n</Scene>"));
  }

  @Test
  void aRouteToTheSameNameInAPrototypeIsNoHindrance() throws IOException {
    String other =
        "<ProtoDeclare name='P'><ProtoBody><Coordinate DEF='C'/><ROUTE fromNode='I' fromField='v'"
            + " toNode='C' toField='point'/></ProtoBody></ProtoDeclare>";
    assertThat(
            repaired(
                "SR203",
                "IndexedFaceSet",
                other
                    + "<IndexedFaceSet coordIndex='0 0 0 -1 0 1 2 -1'>"
                    + "<Coordinate DEF='C' point='0 0 0 1 0 0 0 1 0'/></IndexedFaceSet>"))
        .isEqualTo(
            other
                + "<IndexedFaceSet coordIndex='0 1 2 -1'>"
                + "<Coordinate DEF='C' point='0 0 0 1 0 0 0 1 0'/></IndexedFaceSet>");
  }

  @Test
  void onlyNormalsOfAnotherLengthAreWrittenAnew() throws IOException {
    assertThat(repaired("SR205", "Normal", "<Normal vector='0 0 2,  0.600  0.8 0\n 1 1 0 0 0 0'/>"))
        .isEqualTo("<Normal vector='0 0 1,  0.600  0.8 0\n 0.707107 0.707107 0 0 0 0'/>");
  }

  @Test
  void facesWithoutAreaGoWithTheirNormalsColoursAndTextures() throws IOException {
    assertThat(
            repaired(
                "SR203",
                "IndexedFaceSet",
                "<IndexedFaceSet coordIndex='0 1 1 -1,  0 1 2 -1\n 0 1 3 -1'"
                    + " texCoordIndex='0 1 2 -1, 3 4 5 -1, 6 7 8' colorPerVertex='false'"
                    + " colorIndex='7 8 9'><Coordinate point='0 0 0 1 0 0 0 1 0 2 0 0'/>"
                    + "<Color/></IndexedFaceSet>"))
        .isEqualTo(
            "<IndexedFaceSet coordIndex='0 1 2 -1'"
                + " texCoordIndex='3 4 5 -1' colorPerVertex='false'"
                + " colorIndex='8'><Coordinate point='0 0 0 1 0 0 0 1 0 2 0 0'/>"
                + "<Color/></IndexedFaceSet>");
    assertThat(
            repaired(
                "SR203",
                "IndexedTriangleSet",
                "<IndexedTriangleSet index='0 1 2 0 0 2'>"
                    + "<Coordinate point='0 0 0 1 0 0 0 1 0'/></IndexedTriangleSet>"))
        .contains("index='0 1 2'");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        // colours in the order of the faces
        "<IndexedFaceSet coordIndex='0 0 0 -1 0 1 2 -1' colorPerVertex='false'>"
            + "<Coordinate point='0 0 0 1 0 0 0 1 0'/><Color color='1 0 0 0 1 0'/></IndexedFaceSet>",
        // all of them
        "<IndexedFaceSet coordIndex='0 0 0 -1'><Coordinate point='0 0 0'/></IndexedFaceSet>",
        // moved
        "<Shape><IndexedFaceSet coordIndex='0 0 0 -1 0 1 2 -1'>"
            + "<Coordinate DEF='C' point='0 0 0 1 0 0 0 1 0'/></IndexedFaceSet></Shape>"
            + "<ROUTE fromNode='I' fromField='value_changed' toNode='C' toField='point'/>",
        // of a prototype
        "<ProtoDeclare name='P'><ProtoBody><IndexedFaceSet coordIndex='0 0 0 -1 0 1 2 -1'>"
            + "<Coordinate point='0 0 0 1 0 0 0 1 0'><IS><connect nodeField='point'"
            + " protoField='p'/></IS></Coordinate></IndexedFaceSet></ProtoBody></ProtoDeclare>",
        // without points
        "<IndexedFaceSet coordIndex='0 0 0 -1'/>",
      })
  void aRepairThatWouldChangeThePictureIsRefused(String content) throws IOException {
    SceneDocument document = document(content);
    DocumentElement element = first(document, "IndexedFaceSet");
    GeometryRepair repair = new GeometryRepair(document);
    assertThatThrownBy(() -> repair.edit(GeometryRepair.Kind.REMOVE_EMPTY_FACES, element))
        .isInstanceOf(EditRejectedException.class);
  }

  @Test
  void aRuleIsIgnoredByACommentBeforeTheElement() throws IOException {
    SceneDocument document = document("<Shape><Normal vector='0 0 2'/></Shape>");
    FindingSuppression ignoring = new FindingSuppression(document);
    document.perform(ignoring.suppress("SR205", first(document, "Normal")));
    document.perform(ignoring.suppress("SR206", first(document, "Shape")));
    assertThat(document.text().toString())
        .contains(
            "\r\n  <!-- validate-ignore SR206: accepted by the author -->\r\n  <Shape>"
                + "<!-- validate-ignore SR205: accepted by the author --><Normal vector");
  }
}
