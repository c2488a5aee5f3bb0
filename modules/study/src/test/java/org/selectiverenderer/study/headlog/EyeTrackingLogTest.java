package org.selectiverenderer.study.headlog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;

/** What the eyes of a participant looked at, from the log's file to what is read off it. */
class EyeTrackingLogTest {
  private static final SceneMap MAP =
      new SceneMap(
          List.of(),
          List.of(new SceneMap.Box("Office", new double[] {-2, 0, -2, 2, 3, 2})),
          List.of(
              new SceneMap.Box("Switch_Desk", new double[] {-1, 0, -2, 1, 1, -1}),
              new SceneMap.Box("Switch_Lamp", new double[] {-1, 0, 1, 1, 1, 2}),
              new SceneMap.Box("Switch_Clock", new double[] {-1, 2, 1, 1, 3, 2})),
          List.of());

  private static HeadLogMetadata description(boolean eyes) {
    return new HeadLogMetadata(
        "2026-01-01T00:00:00Z",
        "office.x3d",
        "selective",
        0,
        "headset",
        "none",
        0.5,
        0.5,
        0.5,
        10,
        eyes,
        MAP);
  }

  @TempDir private Path folder;

  /** The head rests and looks at the desk. */
  private static HeadSample sample(int number, boolean visible, EyeSample eyes) {
    return new HeadSample(
            number * 0.02,
            0,
            1.6,
            0,
            0,
            0,
            0,
            false,
            "Switch_Desk",
            1.5,
            1,
            List.of(),
            List.of(),
            20,
            new HeadSample.Moment(visible, null, 5 + number * 0.02),
            null)
        .looking(eyes);
  }

  private static EyeSample at(double yaw, String object) {
    return new EyeSample(true, yaw, -2, object, 2, object.isEmpty() ? -1 : 0);
  }

  private Path write(boolean eyes, List<HeadSample> samples) throws IOException {
    Path file = folder.resolve("session.csv");
    try (HeadLogWriter writer =
        HeadLogWriter.open(HeadLogFiles.claim(file, true), description(eyes), problem -> {})) {
      samples.forEach(writer::add);
    }
    return file;
  }

  private static HeadLog read(Path file) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    HeadLog log = HeadLogReader.read(file, problems).orElseThrow();
    assertThat(problems.any()).isFalse();
    return log;
  }

  /**
   * Half a second at the lamp, a blink of a tenth, half a second at the lamp again; a jump through
   * the wall; 0.6 seconds at the desk, of which the picture is black for the last 0.2.
   */
  private static List<HeadSample> session() {
    List<HeadSample> samples = new ArrayList<>();
    for (int i = 0; i < 90; i++) {
      EyeSample eyes = at(i % 2 * 0.3, "Switch_Desk");
      if (i >= 25 && i < 30) {
        eyes = EyeSample.LOST;
      } else if (i < 55) {
        eyes = at(20 + i % 2 * 0.3, "Switch_Lamp");
      } else if (i < 60) {
        eyes = at(20 - 4 * (i - 54), "");
      }
      samples.add(sample(i, i < 80, eyes));
    }
    return samples;
  }

  @Test
  void whatIsWrittenIsReadAgain() throws IOException {
    List<HeadSample> samples =
        List.of(
            sample(0, true, at(12.3456784, "Switch_Lamp")),
            sample(1, true, EyeSample.LOST),
            sample(2, true, new EyeSample(true, -3, 4, "", Double.NaN, -1)));
    Path file = write(true, samples);
    List<String> lines = Files.readAllLines(file);
    assertThat(lines.get(0))
        .endsWith(",mono,eyes,gaze_yaw,gaze_pitch,gaze_object,gaze_distance,gaze_version");
    assertThat(lines.get(1)).endsWith(",tracked,12.345678,-2.000000,Switch_Lamp,2.000,0");
    assertThat(lines.get(2)).endsWith(",lost,,,,,");
    assertThat(lines.get(3)).endsWith(",tracked,-3.000000,4.000000,,,");
    HeadLog log = read(file);
    assertThat(log.description().eyes()).isTrue();
    assertThat(log.samples())
        .extracting(HeadSample::eyes)
        .containsExactly(
            new EyeSample(true, 12.345678, -2, "Switch_Lamp", 2, 0),
            EyeSample.LOST,
            samples.get(2).eyes());
  }

  @Test
  void aLogOfAHeadsetWithoutAnEyeTrackerSaysNothingOfTheEyes() throws IOException {
    Path file = write(false, List.of(sample(0, true, null), sample(1, true, null)));
    assertThat(Files.readAllLines(file).get(0)).endsWith(",mono");
    assertThat(folder.resolve("session.json")).content().doesNotContain("eyes", "gaze");
    HeadLog log = read(file);
    assertThat(log.samples()).extracting(HeadSample::eyes).containsOnlyNulls();
    HeadLogAnalysis analysis = HeadLogAnalysis.of(log);
    assertThat(analysis.eyes()).isEmpty();
    assertThat(HeadLogReport.text(analysis)).doesNotContain("eyes");
    assertThat(new ObjectMapper().readTree(HeadLogReport.json(analysis)).has("eyes")).isFalse();
    assertThat(HeadLogPlot.svg(analysis)).doesNotContain("eyes");
    assertThat(BidsMotionFiles.eyes(log, "stem", "viewing", "x")).isEmpty();
  }

  @Test
  void aRowThatSaysNonsenseOfTheEyesIsLeftOutWithItsPlace() throws IOException {
    Path file = write(true, List.of(sample(0, true, EyeSample.LOST), sample(1, true, at(1, "A"))));
    Files.writeString(file, Files.readString(file).replace(",lost,", ",shut,"));
    ProblemCollector problems = new ProblemCollector();
    assertThat(HeadLogReader.read(file, problems).orElseThrow().samples()).hasSize(1);
    assertThat(problems.list().get(0).toString())
        .contains("session.csv:2:", "is neither tracked nor lost");
  }

  @Test
  void theEyesAreATargetOfTheirOwn() throws IOException {
    HeadLogAnalysis analysis = HeadLogAnalysis.of(read(write(true, session())));
    assertThat(analysis.head().objects())
        .extracting(DwellSummary.ObjectView::object)
        .containsExactly("Switch_Desk");
    EyeTrackingAnalysis eyes = analysis.eyes().orElseThrow();
    assertThat(eyes.tracked()).isCloseTo(75 / 80.0, within(1e-9));
    assertThat(eyes.looks().objects())
        .extracting(DwellSummary.ObjectView::object, DwellSummary.ObjectView::looks)
        .containsExactly(tuple("Switch_Lamp", 1), tuple("Switch_Desk", 1));
    // The blink is within the look; what was black is not.
    assertThat(eyes.looks().objects().get(0).seconds()).isCloseTo(1.1, within(1e-9));
    assertThat(eyes.looks().objects().get(1).seconds()).isCloseTo(0.4, within(1e-9));
    assertThat(eyes.looks().unseen()).isEqualTo(Map.of("Office", List.of("Switch_Clock")));
    assertThat(HeadLogReport.text(analysis))
        .contains("eyes: tracked 94 % of the time in view, 2 fixations", "looked at by the eyes");
    JsonNode json = new ObjectMapper().readTree(HeadLogReport.json(analysis)).path("eyes");
    assertThat(json.path("tracked").asDouble()).isEqualTo(0.938);
    assertThat(json.at("/objects/0/fixations").asInt()).isOne();
    assertThat(json.at("/unseen/0").asText()).isEqualTo("Switch_Clock");
    assertThat(HeadLogPlot.svg(analysis)).contains("Looked at by the eyes", "stroke-width=\"1.5\"");
  }

  @Test
  void eyesThatRestFixateAndEyesThatMoveDoNot() throws IOException {
    List<Fixation> fixations =
        HeadLogAnalysis.of(read(write(true, session()))).eyes().orElseThrow().fixations();
    assertThat(fixations)
        .extracting(Fixation::object)
        .containsExactly("Switch_Lamp", "Switch_Desk");
    assertThat(fixations.get(0).start()).isZero();
    assertThat(fixations.get(0).end()).isCloseTo(1.1, within(1e-9));
    assertThat(fixations.get(1).duration()).isCloseTo(0.4, within(0.021));
  }

  @Test
  void aHeadThatTurnsUnderEyesThatHoldTheirTargetDoesNotEndAFixation() throws IOException {
    List<HeadSample> samples = new ArrayList<>();
    for (int i = 0; i < 50; i++) {
      HeadSample still = sample(i, true, null);
      samples.add(
          new HeadSample(
              still.t(),
              0,
              1.6,
              0,
              i,
              0,
              0,
              true,
              "",
              Double.NaN,
              -1,
              List.of(),
              List.of(),
              20,
              still.moment(),
              new EyeSample(true, -i, 0, "Switch_Lamp", 2, 0)));
    }
    assertThat(HeadLogAnalysis.of(read(write(true, samples))).eyes().orElseThrow().fixations())
        .singleElement()
        .satisfies(fixation -> assertThat(fixation.duration()).isCloseTo(1, within(1e-9)));
  }

  @Test
  void aPictureThatGoesEndsAFixation() throws IOException {
    List<HeadSample> samples = new ArrayList<>();
    for (int i = 0; i < 30; i++) {
      samples.add(sample(i, i < 10 || i >= 12, at(0, "A")));
    }
    assertThat(HeadLogAnalysis.of(read(write(true, samples))).eyes().orElseThrow().fixations())
        .hasSize(2);
  }

  @Test
  void bidsHasTheEyesBesideTheMotionOfTheHead() throws IOException {
    HeadLog log = read(write(true, session()));
    BidsMotionFiles.write(log, folder.resolve("bids"), "01");
    String name = "sub-01_task-viewing_tracksys-head_recording-eye1_physio";
    JsonNode json =
        new ObjectMapper().readTree(folder.resolve("bids").resolve(name + ".json").toFile());
    assertThat(json.path("PhysioType").asText()).isEqualTo("eyetrack");
    assertThat(json.path("RecordedEye").asText()).isEqualTo("cyclopean");
    assertThat(json.path("SampleCoordinateSystem").asText()).isEqualTo("eye-in-head");
    assertThat(json.path("SamplingFrequency").asDouble()).isEqualTo(50);
    assertThat(json.path("StartTime").asDouble()).isZero();
    List<String> columns = new ArrayList<>();
    json.path("Columns").forEach(column -> columns.add(column.asText()));
    assertThat(columns)
        .containsExactly("timestamp", "x_coordinate", "y_coordinate", "distance", "visible")
        .allSatisfy(column -> assertThat(json.path(column).has("Description")).isTrue());
    byte[] zipped = Files.readAllBytes(folder.resolve("bids").resolve(name + ".tsv.gz"));
    String text =
        new String(
            new GZIPInputStream(new ByteArrayInputStream(zipped)).readAllBytes(),
            StandardCharsets.UTF_8);
    List<String> rows = text.lines().toList();
    assertThat(rows).hasSize(90);
    assertThat(rows.get(0)).isEqualTo("0.000000\t-20.000000\t-2.000000\t1.000000\t1");
    assertThat(rows.get(25)).isEqualTo("0.500000\tn/a\tn/a\tn/a\t1");
    assertThat(rows.get(80)).endsWith("\t0");
  }
}
