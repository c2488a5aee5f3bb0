package org.selectiverenderer.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.testing.X3dDocument;

class HeavySceneGeneratorTest {

  @TempDir Path dir;

  @Test
  void inlinedObjectsHaveTheTrianglesThatItReports() throws IOException {
    BenchScene written = HeavySceneGenerator.write(dir, 0.01);

    X3dDocument scene = X3dDocument.read(written.scene());
    assertThat(scene.elements("Inline")).hasSize(70);
    assertThat(scene.elements("Switch")).hasSize(70).hasSize(written.switches());
    int triangles = 0;
    for (var inline : scene.elements("Inline")) {
      triangles +=
          X3dDocument.read(dir.resolve(inline.getAttribute("url").replace("\"", ""))).triangles();
    }
    assertThat((long) triangles).isEqualTo(written.triangles());
    assertThat(triangles).isCloseTo(7840, within(16));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.01, 0.02})
  void bytesAreCountedAndTheSameEveryTime(double share) throws IOException {
    BenchScene first = HeavySceneGenerator.write(dir.resolve("a"), share);
    BenchScene second = HeavySceneGenerator.write(dir.resolve("b"), share);

    List<Path> files = files(dir.resolve("a"));
    long bytes = 0;
    for (Path file : files) {
      Path twin = dir.resolve("b").resolve(dir.resolve("a").relativize(file));
      assertThat(file).hasSameBinaryContentAs(twin);
      bytes += file.toString().endsWith(".x3d") ? Files.size(file) : 0;
    }
    assertThat(first.bytes()).isEqualTo(bytes).isEqualTo(second.bytes());
    assertThat(files).hasSize(72);
  }

  @ParameterizedTest
  @EnumSource(BenchSurface.class)
  void normalsPointOutwardsAndNoTriangleIsMissing(BenchSurface form) {
    SurfaceMesh mesh = SurfaceMesh.of(form, 0.3, 24, 18);

    assertThat(mesh.triangles()).hasSize(3 * 2 * 24 * 18);
    // Moved a little along its normals, a closed surface with outward normals encloses more.
    double[] larger = mesh.points().clone();
    for (int i = 0; i < larger.length; i++) {
      larger[i] += 0.001 * mesh.normals()[i];
    }
    assertThat(volume(larger, mesh.triangles()))
        .isGreaterThan(volume(mesh.points(), mesh.triangles()));
    assertThat(volume(mesh.points(), mesh.triangles())).isPositive();
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, 1.01, Double.NaN})
  void refusesAShareOutOfRange(double share) {
    assertThatThrownBy(() -> HeavySceneGenerator.write(dir, share))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("share");
  }

  @Test
  void pathStartsAtTheFirstViewpointAndEndsThere() throws IOException {
    BenchScene written = HeavySceneGenerator.write(dir, 0.01);

    List<String> lines = Files.readAllLines(written.path());
    assertThat(lines.get(0)).isEqualTo("t,x,y,z,yaw,pitch,roll");
    double[] first = X3dDocument.numbers(lines.get(1));
    double[] last = X3dDocument.numbers(lines.get(lines.size() - 1));
    double[] eye =
        X3dDocument.numbers(
            X3dDocument.read(written.scene())
                .elements("Viewpoint")
                .get(0)
                .getAttribute("position"));
    assertThat(new double[] {first[1], first[2], first[3]}).containsExactly(eye);
    assertThat(new double[] {last[1], last[2], last[3]}).containsExactly(eye);
    assertThat(last[0]).isEqualTo(20);
  }

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> walk = Files.walk(folder)) {
      return walk.filter(Files::isRegularFile).toList();
    }
  }

  private static double volume(double[] p, int[] triangles) {
    double six = 0;
    for (int t = 0; t < triangles.length; t += 3) {
      int a = 3 * triangles[t];
      int b = 3 * triangles[t + 1];
      int c = 3 * triangles[t + 2];
      six +=
          p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1])
              - p[a + 1] * (p[b] * p[c + 2] - p[b + 2] * p[c])
              + p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
    }
    return six / 6;
  }
}
