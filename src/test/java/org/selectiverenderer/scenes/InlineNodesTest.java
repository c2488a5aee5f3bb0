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
import org.selectiverenderer.testing.X3dDocument;
import org.w3c.dom.Element;

class InlineNodesTest {

  private static final Path FOLDER = Path.of("inlineNodes");

  /** {@code mvn test -Dtest=InlineNodesTest -Dscenes.update=true} writes the files anew. */
  @BeforeAll
  static void update() throws IOException {
    if (Boolean.getBoolean("scenes.update")) {
      for (Map.Entry<String, String> file : GeneratedInlineFiles.all().entrySet()) {
        Files.writeString(FOLDER.resolve(file.getKey()), file.getValue());
      }
    }
  }

  @Test
  void committedFilesAreWhatTheRecipesMake() throws IOException {
    for (Map.Entry<String, String> file : GeneratedInlineFiles.all().entrySet()) {
      assertThat(Files.readString(FOLDER.resolve(file.getKey())))
          .as(file.getKey())
          .isEqualTo(file.getValue());
    }
  }

  @ParameterizedTest
  @CsvSource({"trashCan_v1.x3d, 1064", "trashCan_v2.x3d, 93"})
  void trashCanHasThePolygonsOfTheThesis(String file, int polygons) throws IOException {
    X3dDocument document = X3dDocument.read(FOLDER.resolve(file));

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

  private static String material(X3dDocument document) {
    Element material = document.elements("Material").get(0);
    return material.getAttribute("diffuseColor") + material.getAttribute("specularColor");
  }
}
