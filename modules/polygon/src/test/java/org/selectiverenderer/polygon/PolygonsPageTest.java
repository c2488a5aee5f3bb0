package org.selectiverenderer.polygon;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;

/** docs/polygons.md and its pictures are what the program counts now. */
class PolygonsPageTest {
  private static final Path DOCS = Path.of("docs");
  private static final Path APARTMENT = Path.of("scenes", "apartment.x3d");

  @TempDir static Path folder;
  private static Map<String, String> files;

  /** {@code mvn test -Dtest=PolygonsPageTest -Dpolygons.update=true} writes the files anew. */
  @BeforeAll
  static void makeAndUpdate() throws IOException {
    boolean standIn = Files.notExists(APARTMENT);
    Path scene = standIn ? SyntheticApartment.write(folder) : APARTMENT;
    SceneStatistics statistics = ScenePolygonCounter.of(scene, List.of(), new ProblemCollector());
    files = new PolygonsPage(statistics).files(standIn, folder);
    if (Boolean.getBoolean("polygons.update")) {
      for (Map.Entry<String, String> file : files.entrySet()) {
        Files.writeString(DOCS.resolve(file.getKey()), file.getValue());
      }
    }
  }

  @Test
  void theCommittedPageIsWhatTheProgramCounts() throws IOException {
    for (Map.Entry<String, String> file : files.entrySet()) {
      assertThat(Files.readString(DOCS.resolve(file.getKey())).replace("\r\n", "\n"))
          .as(file.getKey())
          .isEqualTo(file.getValue());
    }
  }

  @Test
  void thePageNamesBothMisprintsAndWhatTheyShouldBe() {
    assertThat(files.get("polygons.md"))
        .contains("76,968 (misprint) | 75,648 |", "163,608 (misprint) | 165,608 |")
        .containsOnlyOnce("| 76,968 | 26.41 % | 26.00 | 75,648 | 25.95 % |");
  }
}
