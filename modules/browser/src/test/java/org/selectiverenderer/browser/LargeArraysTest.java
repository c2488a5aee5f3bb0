package org.selectiverenderer.browser;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.StringJoiner;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeSubgraphCollector;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.PackedArray;

/** Large arrays that a mesh has been made of are packed, which nobody can tell who reads them. */
class LargeArraysTest {
  private static final int COLUMNS = 50;
  private static final int ROWS = 40;

  private static final int[] INDICES = indices();
  private static final float[] NORMALS = normals();
  private static final float[] POINTS = points();

  private static final String SURFACE =
      "<Shape><IndexedFaceSet DEF='S' coordIndex='%s'><Coordinate DEF='C' point='%s'/>"
              .formatted(text(INDICES), text(POINTS, "%.5f"))
          + "<Normal DEF='N' vector='%s'/></IndexedFaceSet></Shape>"
              .formatted(text(NORMALS, "%.3f"));

  private static int[] indices() {
    int[] indices = new int[5 * COLUMNS * ROWS];
    for (int face = 0; face < COLUMNS * ROWS; face++) {
      int a = face / COLUMNS * (COLUMNS + 1) + face % COLUMNS;
      int[] corners = {a, a + 1, a + COLUMNS + 2, a + COLUMNS + 1, -1};
      System.arraycopy(corners, 0, indices, 5 * face, 5);
    }
    return indices;
  }

  private static float[] normals() {
    float[] normals = new float[3 * (COLUMNS + 1) * (ROWS + 1)];
    for (int i = 0; i < normals.length; i += 3) {
      normals[i] = i % 7 / 1000f;
      normals[i + 1] = -i % 5 / 1000f;
      normals[i + 2] = 0.997f;
    }
    return normals;
  }

  private static float[] points() {
    float[] points = new float[NORMALS.length];
    for (int i = 0; i < points.length / 3; i++) {
      points[3 * i] = i % (COLUMNS + 1) / 4f;
      points[3 * i + 1] = -(i / (COLUMNS + 1)) / 4f;
      points[3 * i + 2] = (1000 * (i * i % 17) + 1) / 100_000f;
    }
    return points;
  }

  private static String text(int[] values) {
    StringJoiner text = new StringJoiner(" ");
    Arrays.stream(values).forEach(value -> text.add(Integer.toString(value)));
    return text.toString();
  }

  private static String text(float[] values, String format) {
    StringJoiner text = new StringJoiner(" ");
    for (float value : values) {
      text.add(String.format(Locale.ROOT, format, value));
    }
    return text.toString();
  }

  @Test
  void fieldsOfALargeSurfaceAreReadAsWritten() {
    try (WorldFixture fixture = new WorldFixture(SURFACE)) {
      assertThat(fixture.problems.list()).isEmpty();
      assertThat(fixture.node("S").ints("coordIndex")).isEqualTo(INDICES);
      assertThat(fixture.node("C").floats("point")).isEqualTo(POINTS);
      assertThat(fixture.node("N").floats("vector")).isEqualTo(NORMALS);
      assertThat(fixture.node("S").value("coordIndex"))
          .as("an array in memory once, however often it is read")
          .isSameAs(fixture.node("S").value("coordIndex"));
    }
  }

  @Test
  void pointsAreStoredOnceForTheFieldAndTheMesh() {
    try (WorldFixture fixture = new WorldFixture("<Group/>")) {
      LoadedScene loaded = fixture.load(Path.of("no-such-folder"), SURFACE);
      Mesh mesh = loaded.assets().mesh(loaded.scene().find("S").orElseThrow()).orElseThrow();
      float[] points = loaded.scene().find("C").orElseThrow().floats("point");
      assertThat(mesh.positions()).isSameAs(points);
    }
  }

  @Test
  void newNormalsMakeAnotherMesh() {
    try (WorldFixture fixture = new WorldFixture(SURFACE)) {
      fixture.step(0);
      float[] up = new float[NORMALS.length];
      for (int i = 1; i < up.length; i += 3) {
        up[i] = 1;
      }
      fixture.send("N", "vector", up);
      assertThat(fixture.node("N").floats("vector")).isSameAs(up);
      assertThat(fixture.node("S").ints("coordIndex")).isEqualTo(INDICES);
    }
  }

  @Test
  void lookingForNodesLeavesArraysPacked() {
    Object packed = PackedArray.of(INDICES);
    Node surface =
        new Node(NodeCatalogue.load().get("IndexedFaceSet"), null, SourceLocation.of("test.x3d"));
    surface.init(surface.type().indexOf("coordIndex"), packed);
    assertThat(NodeSubgraphCollector.of(surface)).containsExactly(surface);
    assertThat(packed).hasToString("packed array");
    assertThat(surface.ints("coordIndex")).isEqualTo(INDICES);
  }
}
