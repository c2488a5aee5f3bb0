package org.selectiverenderer.radiosity;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.polygon.ScenePolygonCounter;
import org.selectiverenderer.polygon.SceneStatistics;
import org.selectiverenderer.polygon.SceneStatisticsCsvWriter;

/**
 * The committed lit apartment, as {@code radiosity scenes/apartment-unlit.x3d --rays 1024 --quality
 * 99.99} writes it.
 */
class LitApartmentTest {
  private static final Path SCENES = Path.of("scenes");
  private static final Path INLINED = Path.of("inlineNodes", "apartment-lit");

  /** Tables 3 to 5 of the thesis hold to the polygon, for every object and every set of schemas. */
  @Test
  void bakingKeepsEveryCount() throws Exception {
    assertThat(counts("apartment-lit.x3d")).isEqualTo(counts("apartment.x3d"));
  }

  private static String counts(String scene) throws Exception {
    ProblemCollector problems = new ProblemCollector();
    SceneStatistics statistics = ScenePolygonCounter.of(SCENES.resolve(scene), List.of(), problems);
    assertThat(problems.list()).isEmpty();
    String csv = SceneStatisticsCsvWriter.of(statistics).replace(scene, "");
    assertThat(csv).startsWith("kind,scope,name,version,polygons,percent,draw_calls,texture_bytes");
    return csv.replaceAll("(?m),[^,\n]*,[^,\n]*$", ""); // light adds pictures and parts shapes
  }

  /** Lamps that are on make highlights only: nothing throws back diffuse light. */
  @Test
  void nothingInItNeedsALamp() throws IOException {
    String scene = Files.readString(SCENES.resolve("apartment-lit.x3d"));
    assertThat(scene).doesNotContain("<Material");
    int files = 0;
    try (Stream<Path> inlined = Files.list(INLINED)) {
      for (Path file : inlined.filter(path -> path.toString().endsWith(".x3d")).toList()) {
        String text = Files.readString(file);
        assertThat(text.replace("<Material diffuseColor='0 0 0' ambientIntensity='0'", ""))
            .doesNotContain("<Material");
        assertThat(text).contains("<IndexedTriangleStripSet");
        assertThat(scene).contains("inlineNodes/apartment-lit/" + file.getFileName());
        files++;
      }
    }
    assertThat(files).isGreaterThan(100);
  }

  /** What other scenes' copies of it cost: 40 MB of text and pictures, and none is left over. */
  @Test
  void allOfItIsSmallAndNamed() throws IOException {
    List<Path> files;
    try (Stream<Path> inlined = Files.list(INLINED)) {
      files = inlined.sorted().toList();
    }
    StringBuilder texts = new StringBuilder(Files.readString(SCENES.resolve("apartment-lit.x3d")));
    long bytes = texts.length();
    for (Path file : files) {
      bytes += Files.size(file);
      if (!isPicture(file)) {
        texts.append(Files.readString(file));
      }
    }
    for (Path file : files) {
      if (isPicture(file)) {
        assertThat(texts.indexOf("\"" + file.getFileName() + "\"")).as("%s", file).isPositive();
      }
    }
    assertThat(bytes).isLessThan(40_000_000);
  }

  private static boolean isPicture(Path file) {
    return file.toString().endsWith(".png");
  }
}
