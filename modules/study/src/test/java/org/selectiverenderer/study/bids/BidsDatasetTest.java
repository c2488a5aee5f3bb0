package org.selectiverenderer.study.bids;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.study.dataset.RecordedStudy;
import org.selectiverenderer.study.dataset.RecordedStudyFixture;
import org.selectiverenderer.testing.RequiresProgram;

class BidsDatasetTest {
  private static final BidsDataset.Origin ORIGIN =
      new BidsDataset.Origin("selective-renderer", "2.0", List.of("A. Zotos", "N. N."));

  @TempDir private Path folder = Path.of("");
  private final ProblemCollector problems = new ProblemCollector();
  private Path study = Path.of("");
  private Path dataset = Path.of("");

  @BeforeEach
  void write() throws IOException {
    study = Files.createDirectory(folder.resolve("study"));
    RecordedStudyFixture.write(study);
    dataset = folder.resolve("dataset");
    BidsDataset written =
        BidsDataset.write(
            RecordedStudy.read(RecordedStudyFixture.material(study), problems),
            ORIGIN,
            dataset,
            problems);
    assertThat(written.sessions()).isEqualTo(2);
  }

  private String text(String file) throws IOException {
    return Files.readString(dataset.resolve(file));
  }

  @Test
  void eventsCountFromTheFirstSampleAndSayTheTimeOfTheHeadLogTooWhichStandsStillInPauses()
      throws IOException {
    String events =
        text("sub-001/ses-01/motion/sub-001_ses-01_task-exposurehall_run-01_events.tsv");
    assertThat(events.lines().map(line -> line.substring(0, line.lastIndexOf('\t'))))
        .containsExactly(
            "onset\tduration\ttrial_type\tarea\tschemas\tobject\tversion_from\tversion_to"
                + "\tvisible\tpixels\tturning\ttext\tt",
            "1\t7\texposure\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\t1",
            "2\t4.5\tenter\tDeskProx\tDeskSchema\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\t2",
            "2\t0\tswitch\tn/a\tDeskSchema\tCoat\t1\t0\tyes\t1204\t12.5\tn/a\t2",
            "3\t2\tpause\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\t3",
            "6\t0\tnote\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tsneezed, or \"coughed\"\t4",
            "6.5\t0\texit\tDeskProx\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\t4.5",
            "7\t0\tflag\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tlow-frame-rate\t5");
  }

  @Test
  void whereTheEyesLookedLiesBesideTheMotionOfTheHead() throws IOException {
    String stem =
        "sub-P2/ses-01/motion/sub-P2_ses-01_task-exposurehall_tracksys-head_run-01"
            + "_recording-eye1_physio";
    assertThat(text(stem + ".json")).contains("\"PhysioType\" : \"eyetrack\"", "exposurehall");
    assertThat(dataset.resolve(stem + ".tsv.gz")).isNotEmptyFile();
    assertThat(dataset.resolve(stem.replace("P2", "001") + ".json")).doesNotExist();
  }

  @Test
  void theTrackersOwnRecordsAreATrackingSystemOfTheirOwn() throws IOException {
    String stem = "sub-001/ses-01/motion/sub-001_ses-01_task-exposurehall_tracksys-tracker_run-01";
    assertThat(text(stem + "_motion.tsv"))
        .isEqualTo(
            """
            0.000000\t0.000000\t0.000000\t1.000000\t0.000000
            0.000000\t0.707107\t0.000000\t0.707107\t0.010000
            """);
    assertThat(JsonTree.parse(text(stem + "_motion.json")).path("SamplingFrequency").asDouble())
        .isEqualTo(100);
    assertThat(dataset.resolve(stem.replace("001", "P2") + "_motion.tsv")).doesNotExist();
  }

  @Test
  void placesOfTheTrackerAreChannelsWhereItTellsThem() throws IOException {
    Files.writeString(
        study.resolve("sub-P2/ses-01/head/exposure-hall_run-01_tracker.csv"),
        "t,yaw,pitch,roll,number,wall,mono,right,up,back\n"
            + "0.5,0,0,0,1,2026-03-01T08:00:12.500Z,100.5,0.1,-0.2,0.3\n"
            + "0.51,0,0,0,2,2026-03-01T08:00:12.510Z,100.51,,,\n");
    dataset = folder.resolve("placed");
    BidsDataset.write(
        RecordedStudy.read(RecordedStudyFixture.material(study), problems),
        ORIGIN,
        dataset,
        problems);
    String stem = "sub-P2/ses-01/motion/sub-P2_ses-01_task-exposurehall_tracksys-tracker_run-01";
    assertThat(text(stem + "_motion.tsv"))
        .isEqualTo(
            """
            0.000000\t0.000000\t0.000000\t1.000000\t0.10000\t-0.20000\t0.30000\t0.000000
            0.000000\t0.000000\t0.000000\t1.000000\tn/a\tn/a\tn/a\t0.010000
            """);
    assertThat(text(stem + "_channels.tsv"))
        .hasLineCount(9)
        .contains("\ntracker_POS_y\ty\tPOS\thead\tm\t100.0\ttracker\n");
    JsonNode told = JsonTree.parse(text(stem + "_motion.json"));
    assertThat(told.path("POSChannelCount").asInt()).isEqualTo(3);
    assertThat(told.path("MotionChannelCount").asInt()).isEqualTo(8);
  }

  @Test
  void theDurationOfAnExposureThatWasCutOffIsNotKnown() throws IOException {
    assertThat(text("sub-P2/ses-01/motion/sub-P2_ses-01_task-exposurehall_run-01_events.tsv"))
        .contains("\n1\tn/a\texposure\t");
  }

  @Test
  void theLastAnswerToEachQuestionCountsAndSaysWhatWasTrue() throws IOException {
    assertThat(text("sub-001/ses-01/beh/sub-001_ses-01_task-memoryhall_beh.tsv"))
        .isEqualTo(
            """
            question\tresponse\tconfidence\tresponse_time\tplace\tarea\tconsistency\tpresent
            boat\tno\t3\t5.5\t1\thall\tinconsistent\tno
            coat\tyes\t5\t1.5\t2\thall\tconsistent\tyes
            """);
  }

  @Test
  void anAnswerThatIsPersonalOrNoLongerAskedForIsInNoFile() throws IOException {
    assertThat(text("sub-001/ses-01/beh/sub-001_ses-01_task-form_beh.tsv"))
        .contains("eyes\tbrown\t")
        .hasLineCount(2);
    assertThat(text("sub-001/ses-01/beh/sub-001_ses-01_task-closing_beh.tsv").lines().skip(1))
        .containsExactly(
            "changes\tno\tn/a\t0.3\t1\tn/a\tn/a\tn/a",
            "remarks\tlong, \"but\" fine\tn/a\t9\t2\tn/a\tn/a\tn/a");
    try (Stream<Path> all = Files.walk(dataset)) {
      for (Path file : all.filter(Files::isRegularFile).toList()) {
        assertThat(plain(file)).doesNotContain("Maria", "210 1234", "the boat");
      }
    }
  }

  private static String plain(Path file) throws IOException {
    if (!file.toString().endsWith(".gz")) {
      return Files.readString(file);
    }
    try (InputStream unzipped = new GZIPInputStream(Files.newInputStream(file))) {
      return new String(unzipped.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  @Test
  void answersOfWhoDidNotConsentAreInNoFile() throws IOException {
    Path session = Files.createDirectories(study.resolve("sub-N3/ses-01"));
    Files.writeString(
        session.resolve("events.jsonl"),
        """
        {"time":"2026-03-01T12:00:00.000Z","event":"session-began","software":"selective-renderer 2.0"}
        {"time":"2026-03-01T12:00:01.000Z","event":"step-began","step":"form","run":1}
        {"time":"2026-03-01T12:00:02.000Z","event":"answer","step":"form","object":"eyes","value":"grey","ms":9,"place":2}
        {"time":"2026-03-01T12:00:03.000Z","event":"refused"}
        """);
    Path other = folder.resolve("other");
    BidsDataset.write(
        RecordedStudy.read(RecordedStudyFixture.material(study), problems),
        ORIGIN,
        other,
        problems);
    assertThat(other.resolve("sub-N3/sub-N3_sessions.tsv")).content().contains("\trefused\t");
    assertThat(other.resolve("sub-N3/ses-01/beh")).doesNotExist();
  }

  @Test
  void columnsThatAreNotWhatBidsMeansByTheirNamesGetOthers() throws IOException {
    assertThat(text("participants.tsv").lines().findFirst())
        .hasValue(
            "participant_id\tcondition\tplace\tassigned_by\tinstead_of\tage_band\tsimulated\tsex_answer");
    JsonNode columns = JsonTree.parse(text("participants.json"));
    assertThat(columns.path("condition").path("Levels").path("high").asText()).isNotEmpty();
  }

  @Test
  void sessionsSayHowTheyEnded() throws IOException {
    assertThat(text("sub-001/sub-001_sessions.tsv"))
        .endsWith(
            "ses-01\t2026-03-01T08:00:00.000Z\t30\t5\tselective\tn/a\tfinished\tno\tlow-frame-rate"
                + "\tselective-renderer 2.0\n");
    assertThat(text("sub-P2/sub-P2_sessions.tsv")).contains("\tunfinished\t");
    assertThat(text("sub-001/ses-01/sub-001_ses-01_scans.tsv"))
        .contains("tracksys-head_run-01_motion.tsv\t2026-03-01T08:00:12.000Z\n");
  }

  @Test
  void damagedLinesAreToldWithTheirPlaceAndTheRestIsUsed() {
    assertThat(problems.list())
        .extracting(Problem::toString)
        .anyMatch(
            line ->
                line.endsWith(
                    "events.jsonl:3:1: this line is damaged, perhaps by a crash; it is left out"))
        .anyMatch(line -> line.contains("events.jsonl:6:1: the last line is cut off"))
        .anyMatch(line -> line.contains("_tracker.csv"))
        .anyMatch(line -> line.contains("the study no longer has dropped; the answers to it are"))
        .hasSize(4);
  }

  @Test
  void aFolderWithFilesIsNotMixedWithADataset() throws IOException {
    RecordedStudy recorded =
        RecordedStudy.read(RecordedStudyFixture.material(study), new ProblemCollector());
    assertThatThrownBy(() -> BidsDataset.write(recorded, ORIGIN, study, problems))
        .isInstanceOf(IOException.class)
        .hasMessage(study + ": is not empty; a dataset needs a folder of its own, name a new one");
  }

  /** What the lab alone can say: keys that are recommended and for which nothing is known. */
  private static final Set<String> THE_LABS =
      Set.of(
          "HEDVersion",
          "License",
          "SourceDatasets",
          "CogAtlasID",
          "CogPOID",
          "Instructions",
          "InstitutionName",
          "InstitutionAddress",
          "InstitutionalDepartmentName",
          "SubjectArtefactDescription");

  @Test
  @RequiresProgram("bids-validator-deno")
  void theValidatorFindsNoErrorAndWarnsOfWhatTheLabAloneCanSay() throws Exception {
    Process validator =
        new ProcessBuilder(
                "bids-validator-deno", "--format", "json", "--max-rows", "-1", dataset.toString())
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    String said = new String(validator.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(validator.waitFor()).as(said).isZero();
    List<String> errors = new ArrayList<>();
    Set<String> warnings = new TreeSet<>();
    JsonNode report = JsonTree.parse(said);
    for (JsonNode issue : report.path("issues").path("issues")) {
      if (issue.path("severity").asText().equals("error")) {
        errors.add(issue.toString());
      } else {
        warnings.add(issue.path("subCode").asText(issue.path("code").asText()));
      }
    }
    assertThat(errors).isEmpty();
    assertThat(THE_LABS).containsAll(warnings);
    assertThat(report.path("summary").path("subjects")).hasSize(2);
  }
}
