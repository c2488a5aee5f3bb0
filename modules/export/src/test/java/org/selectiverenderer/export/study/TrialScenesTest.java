package org.selectiverenderer.export.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.export.WebPage;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialSequencer;
import org.selectiverenderer.study.session.LoadedStudy;

class TrialScenesTest {
  /** The number of equal rows, none of which may follow another: few orders are allowed. */
  private static final int ALIKE = 300;

  /** With it an order is found for the first round, but not for the second. */
  private static final int SEED = 27;

  private static final String BLOCK =
      """
        "blocks": [{"name": "drill", "stimuli": "rows.csv", "order": "random",
          "at_most_in_a_row": {"kind": 1}, "practice": {"correct": 0.8, "rounds": %d},
          "trial": [{"show": "exposure", "seconds": 1, "keys": ["f"], "correct": "f"}]}],
      """;

  @TempDir Path folder;

  private static String rows() {
    StringBuilder rows = new StringBuilder("kind\n" + "same\n".repeat(ALIKE));
    IntStream.range(1, ALIKE).forEach(other -> rows.append(other).append('\n'));
    return rows.toString();
  }

  private static List<LoadedStudy> read(StudyFixture fixture, int rounds) throws IOException {
    return fixture.read(
        StudyFixture.text(BLOCK.formatted(rounds))
            .replace("[\"high\", \"selective\"]", "[\"selective\"]")
            .replace("\"participants\": 4", "\"participants\": 1")
            .replace("\"seed\": 3", "\"seed\": " + SEED));
  }

  private static boolean found(LoadedStudy material, int round) {
    Study study = material.study();
    TrialBlock block = study.design().blocks().get(0);
    return new TrialSequencer(block, study.design().groups().get(0), study.seed())
        .trials(0, round)
        .isPresent();
  }

  @Test
  void aLaterRoundOfAPracticeWithoutAnOrderIsToldInOneLine() throws IOException {
    Optional<WebPage> page = WebPage.ofStudy();
    assumeThat(page).isPresent(); // a build without Node.js has none
    StudyFixture fixture = new StudyFixture(folder);
    Files.writeString(folder.resolve("rows.csv"), rows());
    LoadedStudy material = read(fixture, 2).get(0);
    assertThat(found(material, 1)).isTrue();
    assertThat(found(material, 2)).isFalse();
    assertThat(
            StudyFolder.of(
                page.get(), StudyFolder.Host.WEB_SERVER, read(fixture, 2), fixture.collector()))
        .isEmpty();
    assertThat(fixture.problems())
        .singleElement()
        .asString()
        .contains("study.json: ")
        .contains("the block drill (place 1 of the plan, round 2)")
        .contains("\"at_most_in_a_row\"");
  }
}
