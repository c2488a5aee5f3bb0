package org.selectiverenderer.study.threshold;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.study.threshold.ThresholdEstimate.Kind;

/** What the participants of a pilot come to. */
class ThresholdResultsTest extends ThresholdPilotFixture {
  private void participants(int count, double share) throws IOException {
    ThresholdStudy study = study();
    for (int i = 1; i <= count; i++) {
      try (ThresholdSession session = open(String.format(Locale.ROOT, "%03d", i), false)) {
        answer(session, observer(study, share, 100 + i), 10_000);
      }
    }
  }

  @Test
  void whoSawOtherPicturesIsTold() throws IOException {
    participants(2, 0.1);
    ThresholdStudy study = study();
    try (ThresholdSession session =
        ThresholdSession.open(
            study,
            ladders(study),
            new ThresholdSession.Opening("003", "other pictures", "test 1", true, false),
            problems)) {
      answer(session, observer(study, 0.1, 103), 10_000);
    }
    assertThat(ThresholdResults.read(study, problems).participants()).isEqualTo(3);
    assertThat(told())
        .singleElement()
        .asString()
        .endsWith(
            "threshold.json: the settings or the pictures were changed between participants (sub-001,"
                + " sub-002; sub-003); their results are not comparable, and should not be averaged");
  }

  @Test
  void meansAreOfLogarithmsAndTheIntervalIsStudents() {
    ObjectThreshold vase =
        new ObjectThreshold(
            "Vase",
            2000,
            List.of(
                new ThresholdEstimate(Kind.FOUND, 100),
                new ThresholdEstimate(Kind.FOUND, 200),
                new ThresholdEstimate(Kind.FOUND, 400),
                new ThresholdEstimate(Kind.OPEN, 640)));

    // R: exp(t.test(log(c(100, 200, 400)))$conf.int) is 35.746212 1118.999675
    assertThat(vase.mean()).isCloseTo(200, within(1e-9));
    assertThat(vase.low()).isCloseTo(35.746212, within(1e-5));
    assertThat(vase.high()).isCloseTo(1118.999675, within(1e-5));
    assertThat(vase.wanted()).contains(200);
  }

  @Test
  void anObjectWhoseVersionsWereNotGoodEnoughForMostStaysAsItIs() {
    assertThat(
            new ObjectThreshold(
                    "Vase",
                    2000,
                    List.of(
                        new ThresholdEstimate(Kind.FOUND, 100),
                        new ThresholdEstimate(Kind.ABOVE, 1400)))
                .wanted())
        .isEmpty();
    assertThat(new ObjectThreshold("Vase", 0, List.of()).wanted()).isEmpty();
    assertThat(
            new ObjectThreshold("Vase", 2000, List.of(new ThresholdEstimate(Kind.BELOW, 20)))
                .wanted())
        .contains(20);
  }

  @Test
  void manyObserversComeToTheThresholdThatTheyHave() throws IOException {
    participants(20, 0.1);

    JsonNode tree = JsonTree.parse(ThresholdReport.json(ThresholdResults.read(study(), problems)));

    assertThat(told()).isEmpty();
    assertThat(tree.path("participants").asInt()).isEqualTo(20);
    assertThat(tree.path("objects")).hasSize(5);
    for (JsonNode object : tree.path("objects")) {
      // They tell half of the versions at 200 polygons; 70.7 % of answers are right a little above.
      assertThat(object.path("mean").asDouble()).isBetween(150.0, 300.0);
      assertThat(object.path("low").asDouble()).isLessThan(object.path("mean").asDouble());
      assertThat(object.path("found").asInt()).isEqualTo(20);
      assertThat(object.path("polygons").asInt())
          .isEqualTo((int) Math.ceil(object.path("mean").asDouble()));
    }
  }

  @Test
  void theCommandsMakeTheVersions() throws IOException {
    participants(2, 0.1);
    ThresholdResults results = ThresholdResults.read(study(), problems);

    assertThat(results.commands("./selective-renderer", "my room.x3d").lines())
        .hasSize(5)
        .allMatch(
            line ->
                line.matches(
                    "\\./selective-renderer versions 'my room\\.x3d' --object \\w+"
                        + " --polygons \\d+"));
    assertThat(ThresholdReport.text(results, "selective-renderer", "room.x3d"))
        .contains("Pilot: 2 participants; polygons at which 70.7 % of the answers")
        .contains("\nselective-renderer versions room.x3d --object Vase --polygons ");
  }

  @Test
  void whoDoesNotAttendIsLeftOutAndSaidToBe() throws IOException {
    write("tell-apart", "\"catches\": 0.3,");
    ThresholdStudy study = study();
    participants(1, 0.1);
    try (ThresholdSession session = open("009", false)) {
      while (session.next().isPresent()) {
        session.answer(session.next().get(), ThresholdTrial.LEFT, 1);
      }
    }

    ThresholdResults results = ThresholdResults.read(study, problems);

    assertThat(results.participants()).isEqualTo(1);
    assertThat(told()).singleElement().asString().contains("sub-009 is left out: of ");
  }

  @Test
  void whatIsSettledOfAPilotThatWasCutOffCounts() throws IOException {
    ThresholdStudy study = study();
    try (ThresholdSession session = open("001", false)) {
      SimulatedObserver observer = observer(study, 0.1, 1);
      while (session.pilot().left() == 5) {
        answer(session, observer, 1);
      }
    }

    ThresholdResults results = ThresholdResults.read(study, problems);

    assertThat(results.objects()).filteredOn(object -> !object.estimates().isEmpty()).hasSize(1);
    assertThat(told())
        .singleElement()
        .asString()
        .contains("the trials of sub-001 are not finished");
    assertThat(results.commands("selective-renderer", "room.x3d"))
        .contains(": nobody's threshold is known yet\n");
  }

  @Test
  void aPilotWithoutParticipantsHasNoThresholds() throws IOException {
    assertThat(
            ThresholdReport.text(
                ThresholdResults.read(study(), problems), "selective-renderer", "room.x3d"))
        .startsWith("Pilot: 0 participants")
        .contains("# Vase: nobody's threshold is known yet");
    assertThat(Files.exists(folder.resolve("threshold"))).isFalse();
  }
}
