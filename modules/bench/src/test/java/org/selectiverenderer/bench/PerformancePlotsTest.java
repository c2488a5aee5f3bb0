package org.selectiverenderer.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The plots of docs/performance.md are those of the figures beside it. */
class PerformancePlotsTest {
  private static final Path FIGURES = Path.of("docs", "figures", "performance");
  private static final Path PICTURES = Path.of("docs", "pictures");

  @TempDir Path folder;
  private static Map<String, String> files;

  /** {@code mvn test -Dtest=PerformancePlotsTest -Dplots.update=true} draws them anew. */
  @BeforeAll
  static void drawAndUpdate() throws IOException {
    files = new PerformancePlots(FIGURES).files();
    if (Boolean.getBoolean("plots.update")) {
      for (Map.Entry<String, String> file : files.entrySet()) {
        Files.writeString(PICTURES.resolve(file.getKey()), file.getValue());
      }
    }
  }

  @Test
  void theCommittedPicturesAreDrawnFromTheCommittedFigures() throws IOException {
    for (Map.Entry<String, String> file : files.entrySet()) {
      assertThat(Files.readString(PICTURES.resolve(file.getKey())).replace("\r\n", "\n"))
          .as(file.getKey())
          .isEqualTo(file.getValue());
    }
  }

  @Test
  void noPictureIsWithoutFiguresAndNoFiguresAreWithoutAPlot() throws IOException {
    assertThat(names(PICTURES, "performance-.*\\.svg")).isEqualTo(files.keySet());
    assertThat(names(FIGURES, ".*"))
        .isSubsetOf(
            Stream.of(PerformancePlot.values()).map(plot -> plot.fileName() + ".csv").toList());
  }

  private static Set<String> names(Path folder, String pattern) throws IOException {
    if (Files.notExists(folder)) {
      return Set.of();
    }
    try (Stream<Path> all = Files.list(folder)) {
      return all.map(path -> path.getFileName().toString())
          .filter(name -> name.matches(pattern))
          .collect(Collectors.toSet());
    }
  }

  @Test
  void barsStandInTheOrderOfTheFile() throws IOException {
    String svg =
        draw("frames", "group,series,value", "Hall,ours,40", "Hall,theirs,20", "Attic,theirs,3");

    assertThat(svg)
        .containsSubsequence("ours", "theirs", "Hall", "40", "20", "Attic", "not measured", "3");
  }

  @Test
  void curvesAreDrawnFromTheirPoints() throws IOException {
    String svg =
        draw(
            "growth-sensors",
            "series,x,y",
            "frame,1,0.5",
            "frame,1000,0.6",
            "load,1,2",
            "load,1000,90");

    assertThat(svg).contains(">sensors<", ">milliseconds<", ">frame<", ">load<");
  }

  @Test
  void aFigureThatIsNoneIsNamedWithItsPlace() {
    assertThatThrownBy(() -> draw("frame", "group,series,value", "Hall,update,1", "Hall,draw,fast"))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("frame.csv:3:11: 'fast' is not a number");
    assertThatThrownBy(() -> draw("frame", "group,series,value", "Hall,update,1", "Hall,update,2"))
        .hasMessageContaining("frame.csv:3:1: this bar is there already");
    assertThatThrownBy(() -> draw("growth-inlines", "series,x", "load,1"))
        .hasMessageContaining("growth-inlines.csv:1:1")
        .hasMessageContaining("y");
  }

  private String draw(String name, String... lines) throws IOException {
    Path figures = Files.createTempDirectory(folder, "figures");
    Files.write(figures.resolve(name + ".csv"), List.of(lines));
    Map<String, String> drawn = new PerformancePlots(figures).files();
    assertThat(drawn).containsOnlyKeys("performance-" + name + ".svg");
    return drawn.get("performance-" + name + ".svg");
  }
}
