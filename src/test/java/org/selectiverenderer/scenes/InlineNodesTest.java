package org.selectiverenderer.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.w3c.dom.Element;

class InlineNodesTest {

  private static final Path FOLDER = Path.of("inlineNodes");

  /** {@code mvn test -Dtest=InlineNodesTest -Dscenes.update=true} writes the files anew. */
  @BeforeAll
  static void update() throws IOException {
    if (Boolean.getBoolean("scenes.update")) {
      for (Map.Entry<String, String> file : InlineNodes.all().entrySet()) {
        Files.writeString(FOLDER.resolve(file.getKey()), file.getValue());
      }
    }
  }

  @Test
  void committedFilesAreWhatTheRecipesMake() throws IOException {
    for (Map.Entry<String, String> file : InlineNodes.all().entrySet()) {
      assertThat(Files.readString(FOLDER.resolve(file.getKey())))
          .as(file.getKey())
          .isEqualTo(file.getValue());
    }
  }

  @ParameterizedTest
  @CsvSource({"trashCan_v1.x3d, 1064", "trashCan_v2.x3d, 93"})
  void trashCanHasThePolygonsOfTheThesis(String file, int polygons) throws IOException {
    X3dDocument document = X3dDocument.read(FOLDER.resolve(file));

    assertThat(document.elements("IndexedFaceSet")).hasSize(1);
    assertThat(document.triangles()).isEqualTo(polygons);
  }

  @Test
  void versionsHaveTheSameBoundsAndColour() throws IOException {
    X3dDocument v1 = X3dDocument.read(FOLDER.resolve("trashCan_v1.x3d"));
    X3dDocument v2 = X3dDocument.read(FOLDER.resolve("trashCan_v2.x3d"));

    double[] a = v1.pointBounds();
    double[] b = v2.pointBounds();
    for (int axis = 0; axis < 3; axis++) {
      double size = a[axis + 3] - a[axis];
      assertThat(b[axis]).isCloseTo(a[axis], within(0.02 * size));
      assertThat(b[axis + 3]).isCloseTo(a[axis + 3], within(0.02 * size));
    }
    assertThat(material(v1)).isEqualTo(material(v2));
  }

  @Test
  void everyTriangleOfATrashCanHasThreePointsAndAnArea() {
    for (TriangleMesh mesh : new TriangleMesh[] {TrashCan.v1(), TrashCan.v2()}) {
      assertThat(mesh.triangles())
          .allSatisfy(
              t ->
                  assertThat(
                          doubleArea(
                              mesh.points().get(t[0]),
                              mesh.points().get(t[1]),
                              mesh.points().get(t[2])))
                      .isGreaterThan(1e-7));
    }
  }

  private static double doubleArea(double[] a, double[] b, double[] c) {
    double ux = b[0] - a[0];
    double uy = b[1] - a[1];
    double uz = b[2] - a[2];
    double vx = c[0] - a[0];
    double vy = c[1] - a[1];
    double vz = c[2] - a[2];
    return Math.hypot(Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz), ux * vy - uy * vx);
  }

  private static String material(X3dDocument document) {
    Element material = document.elements("Material").get(0);
    return material.getAttribute("diffuseColor") + material.getAttribute("specularColor");
  }
}
