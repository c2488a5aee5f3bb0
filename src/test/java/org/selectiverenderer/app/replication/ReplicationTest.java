package org.selectiverenderer.app.replication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.polygon.ScenePolygonCounter;
import org.selectiverenderer.statistics.report.Provenance;
import org.selectiverenderer.study.session.LoadedStudy;

/** The thesis's study is made anew, the same for the same seed, and never over what is there. */
class ReplicationTest {
  private static final Path APARTMENT = Path.of("scenes", "apartment.x3d");
  private static final Provenance PROVENANCE =
      new Provenance("selective-renderer", "test", LocalDate.of(2026, 1, 15), true);

  @TempDir private Path folder;

  private List<String> made(String name) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    List<String> lines =
        new Replication(folder.resolve(name), APARTMENT, 9, 4)
            .run(PROVENANCE, problems, line -> {})
            .orElseThrow();
    assertThat(problems.any()).as(problems.list().toString()).isFalse();
    return lines;
  }

  @Test
  void theStudyIsMadeTwiceAlike() throws IOException {
    List<String> lines = made("once");
    assertThat(lines.get(0)).contains("10 of 10 counts").contains("8 are as printed");
    assertThat(lines.get(1)).contains("44 of 44");
    assertThat(lines).hasSize(4);
    Path made = folder.resolve("once");
    assertThat(made.resolve("study/participants.tsv")).content().hasLineCount(10).contains("true");
    assertThat(made.resolve("study/study.json"))
        .content()
        .contains(
            "\"participants\": 9,",
            "\"seed\": 4,",
            "\"scene\": \"scenes/apartment.x3d\"",
            "\"scene\": \"scenes/practice.x3d\"")
        .doesNotContain("../");
    assertThat(made.resolve("study/pilot/threshold.json"))
        .content()
        .contains("\"scene\": \"../scenes/apartment.x3d\"");
    assertThat(made.resolve("study/sub-009/ses-01/events.jsonl"))
        .content()
        .contains("\"flag\":\"simulated\"", "\"shown\":false", "session-finished");
    assertThat(Files.readAllLines(made.resolve("responses.csv"))).hasSize(1 + 9 * 160);
    assertThat(made.resolve("tables-3-5.csv"))
        .content()
        .contains("5,Office,DeskSchema,76968,75648,75648,misprint");
    assertThat(made.resolve("tables-6-11.csv")).content().hasLineCount(1 + 36 * 6);
    assertThat(made.resolve("index.html"))
        .content()
        .contains("Table 11: sofa", "What this cannot say", "prefers-color-scheme")
        .doesNotContain("href=\"http", "url(", "<script", "src=");
    for (String name : List.of("report.html", "plan.html", "answers.csv", "scores.csv")) {
      assertThat(made.resolve(name)).isNotEmptyFile();
    }

    // All of it moves to another place, with its scene.
    Path elsewhere = Files.createDirectories(folder.resolve("another/machine")).resolve("study");
    Files.move(made.resolve("study"), elsewhere);
    ProblemCollector problems = new ProblemCollector();
    assertThat(LoadedStudy.read(elsewhere.resolve("study.json"), problems)).isPresent();
    assertThat(
            ScenePolygonCounter.of(elsewhere.resolve("scenes/apartment.x3d"), List.of(), problems)
                .totalHigh())
        .isEqualTo(ScenePolygonCounter.of(APARTMENT, List.of(), problems).totalHigh());
    assertThat(problems.list()).isEmpty();

    made("again");

    for (String name : List.of("responses.csv", "index.html", "tables-6-11.csv", "effects.csv")) {
      assertThat(folder.resolve("again").resolve(name)).hasSameTextualContentAs(made.resolve(name));
    }
  }

  @Test
  void aFolderWithFilesIsRefused() throws IOException {
    Path there = Files.writeString(folder.resolve("notes.txt"), "mine");

    assertThatThrownBy(
            () ->
                new Replication(folder, APARTMENT, 9, 4)
                    .run(PROVENANCE, new ProblemCollector(), line -> {}))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("is not empty; name a new folder");

    assertThat(folder).isDirectoryContaining(path -> path.equals(there));
    assertThat(folder.resolve("study")).doesNotExist();
  }
}
