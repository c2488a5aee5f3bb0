package org.selectiverenderer.study.headlog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;

class HeadLogTest {
  private static final SceneMap MAP =
      new SceneMap(
          List.of(
              new SceneMap.Area(
                  "DeskProx",
                  List.of(new double[] {0, 0}, new double[] {1, 0}, new double[] {1, 1}))),
          List.of(new SceneMap.Box("Office", new double[] {-2, 0, -2, 2, 3, 2})),
          List.of(
              new SceneMap.Box("Switch_Desk", new double[] {-1, 0, -2, 1, 1, -1}),
              new SceneMap.Box("Switch_Clock", new double[] {-1, 2, 1, 1, 3, 2})),
          List.of(new SceneMap.Box("Inline_Walls", new double[] {-2, 0, -2, 2, 3, 2})));

  private static final HeadLogMetadata DESCRIPTION =
      new HeadLogMetadata(
          "2026-01-01T00:00:00Z",
          "office.x3d",
          "selective",
          0,
          "ProView 50",
          "none",
          0.373,
          0.28,
          0.5,
          10,
          false,
          MAP);

  @TempDir private Path folder;

  private static HeadSample sample(double t, double yaw, double pitch, String object) {
    return new HeadSample(
        t,
        0.1,
        1.6,
        -1.0 / 3,
        yaw,
        pitch,
        0,
        yaw != 0,
        object,
        1.25,
        1,
        List.of("a", "b"),
        List.of("OfficeSchema"),
        16.6667,
        HeadSample.Moment.UNTOLD,
        null);
  }

  /** A moment of a machine that was started with the year. */
  private static HeadSample.Moment at(double mono, boolean visible) {
    return new HeadSample.Moment(
        visible, Instant.parse("2026-01-01T00:00:00Z").plusMillis((long) (mono * 1000)), mono);
  }

  /** What is looked at at a time, seen or not, with a clock that is ahead by some seconds. */
  private static HeadSample look(double t, String object, boolean visible, double ahead) {
    HeadSample like = sample(t, 1, 0, object);
    return new HeadSample(
        like.t(),
        like.x(),
        like.y(),
        like.z(),
        like.yaw(),
        like.pitch(),
        like.roll(),
        like.moved(),
        object,
        like.distance(),
        like.version(),
        like.cone(),
        like.schemas(),
        100,
        at(t + ahead, visible),
        null);
  }

  private Path write(List<HeadSample> samples) throws IOException {
    Path file = folder.resolve("session.csv");
    try (HeadLogWriter writer =
        HeadLogWriter.open(HeadLogFiles.claim(file, false), DESCRIPTION, problem -> {})) {
      samples.forEach(writer::add);
    }
    return file;
  }

  private HeadLog read(Path file) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    HeadLog log = HeadLogReader.read(file, problems).orElseThrow();
    assertThat(problems.any()).isFalse();
    return log;
  }

  @Test
  void whatIsWrittenIsReadAgainToAMillionth() throws IOException {
    List<HeadSample> samples =
        List.of(
            sample(0, 12.345678901234567, -3, "Switch_Desk"),
            new HeadSample(
                0.1,
                0,
                0,
                0,
                0,
                0,
                0,
                false,
                "",
                Double.NaN,
                -1,
                List.of(),
                List.of(),
                5,
                at(12.5, true),
                null),
            sample(0.2, 1e-7, 0, "a \"quoted\", one"));
    HeadLog log = read(write(samples));
    assertThat(log.samples().get(0).yaw()).isEqualTo(12.345679);
    assertThat(log.samples().get(0).z()).isEqualTo(-0.333333);
    assertThat(log.samples().get(1)).isEqualTo(samples.get(1));
    assertThat(log.samples().get(2).object()).isEqualTo("a \"quoted\", one");
    assertThat(log.description().map().rooms().get(0).bounds()).containsExactly(-2, 0, -2, 2, 3, 2);
    assertThat(log.description().tanX()).isEqualTo(0.373);
  }

  @Test
  void theDescriptionNamesEveryColumnOfTheFile() throws IOException {
    Path file = write(List.of(sample(0, 0, 0, "")));
    JsonNode columns =
        new ObjectMapper().readTree(folder.resolve("session.json").toFile()).get("columns");
    List<String> named = new ArrayList<>();
    columns.fieldNames().forEachRemaining(named::add);
    assertThat(Files.readAllLines(file).get(0)).isEqualTo(String.join(",", named));
    assertThat(columns.get("distance").get("units").asText()).isEqualTo("scene unit");
  }

  @Test
  void aLineCutOffByACrashIsLeftOut() throws IOException {
    Path file = write(List.of(sample(0, 0, 0, "A"), sample(0.1, 0, 0, "A")));
    Files.writeString(file, "0.2,1,2", StandardOpenOption.APPEND);
    ProblemCollector problems = new ProblemCollector();
    assertThat(HeadLogReader.read(file, problems).orElseThrow().samples()).hasSize(2);
    assertThat(problems.any()).isFalse();
    assertThat(problems.list().get(0).toString()).contains("session.csv", "cut off");
  }

  @Test
  void anotherKindOfFileIsRefusedInASentence() throws IOException {
    Path file = folder.resolve("other.csv");
    Files.writeString(file, "t,x\n1,2\n");
    ProblemCollector problems = new ProblemCollector();
    assertThat(HeadLogReader.read(file, problems)).isEmpty();
    assertThat(problems.list().get(0).toString()).contains("other.csv:1:1", "lacks y");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void aDiskThatTakesNothingIsToldAtTheBeginning() throws IOException {
    Path full = Path.of("/dev/full");
    org.junit.jupiter.api.Assumptions.assumeTrue(Files.exists(full));
    Path link = folder.resolve("session.csv");
    Files.createSymbolicLink(link, full);
    assertThat(
            org.assertj.core.api.Assertions.catchThrowable(
                () ->
                    HeadLogWriter.open(HeadLogFiles.claim(link, true), DESCRIPTION, problem -> {})))
        .isInstanceOf(IOException.class);
    Files.delete(link);
  }

  @Test
  void numbersHaveAFixedNumberOfDecimalsThatTheDescriptionTells() throws IOException {
    Path file =
        write(
            List.of(
                new HeadSample(
                    2.0 / 3,
                    1e-7,
                    -1e-9,
                    12345678.5,
                    -90,
                    0,
                    180,
                    true,
                    "",
                    4,
                    -1,
                    List.of(),
                    List.of(),
                    16.6666,
                    at(1234.5678901, false),
                    null)));
    assertThat(Files.readAllLines(file).get(1))
        .isEqualTo(
            "0.666667,0.000000,0.000000,12345678.500000,-90.000000,0.000000,180.000000,moved,,4.000,,,,16.667,0,"
                + "2026-01-01T00:20:34.567Z,1234.567890");
    JsonNode columns =
        new ObjectMapper().readTree(folder.resolve("session.json").toFile()).get("columns");
    assertThat(columns.get("yaw").get("decimals").asInt()).isEqualTo(6);
    assertThat(columns.get("distance").get("decimals").asInt()).isEqualTo(3);
    assertThat(columns.get("object").has("decimals")).isFalse();
  }

  @Test
  void samplesOfOneObjectInTurnAreOneLook() throws IOException {
    List<HeadSample> samples = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      // The desk, for one sample a chair's leg before it, the clock, the desk again.
      String object =
          i == 5 ? "Leg" : i < 20 ? "Switch_Desk" : i < 30 ? "Switch_Shelf" : "Switch_Desk";
      samples.add(sample(i * 0.1, 1, 0, object));
    }
    HeadLogAnalysis analysis = HeadLogAnalysis.of(read(write(samples)));
    assertThat(analysis.head().all())
        .extracting(Dwell::object)
        .containsExactly("Switch_Desk", "Leg", "Switch_Shelf", "Switch_Desk");
    assertThat(analysis.head().all().get(0).end()).isCloseTo(2, within(1e-9));
    DwellSummary.ObjectView desk = analysis.head().objects().get(0);
    assertThat(desk.object()).isEqualTo("Switch_Desk");
    assertThat(desk.looks()).isEqualTo(2);
    assertThat(desk.seconds()).as("without the leg").isCloseTo(2.9, within(1e-9));
    assertThat(desk.first()).isZero();
    assertThat(analysis.head().unseen()).isEqualTo(Map.of("Office", List.of("Switch_Clock")));
  }

  @Test
  void whatTheParticipantDidNotSeeIsNotLookedAtAndIsSaidToBeLeftOut() throws IOException {
    List<HeadSample> samples = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      // Black for a second, then the desk; it goes dark and comes again; black in the end.
      boolean visible = i >= 10 && i < 20 || i >= 22 && i < 30;
      samples.add(look(i * 0.1, i < 35 ? "Switch_Desk" : "Switch_Clock", visible, 5));
    }
    HeadLogAnalysis analysis = HeadLogAnalysis.of(read(write(samples)));
    assertThat(analysis.seconds()).isCloseTo(1.8, within(1e-9));
    assertThat(analysis.unshown().samples()).isEqualTo(22);
    assertThat(analysis.unshown().seconds()).isCloseTo(2.2, within(1e-9));
    assertThat(analysis.unshown().pauses()).isZero();
    DwellSummary.ObjectView desk = analysis.head().objects().get(0);
    assertThat(desk.seconds()).isCloseTo(1.8, within(1e-9));
    assertThat(desk.first()).isCloseTo(1, within(1e-9));
    assertThat(desk.looks()).isEqualTo(2);
    assertThat(analysis.head().unseen()).isEqualTo(Map.of("Office", List.of("Switch_Clock")));
    assertThat(analysis.rooms().get(0).seconds()).isCloseTo(1.8, within(1e-9));
    assertThat(HeadLogReport.text(analysis))
        .contains("1.8 s in view, 18 samples", "left out: 2.2 s, 22 samples without a picture");
    assertThat(new ObjectMapper().readTree(HeadLogReport.json(analysis)).at("/left_out/seconds"))
        .hasToString("2.2");
    assertThat(HeadLogPlot.svg(analysis)).contains("grey: no picture");
  }

  @Test
  void aPauseIsWhereTheMachinesClockWentOnAndTheLogsDidNot() throws IOException {
    List<HeadSample> samples = new ArrayList<>();
    for (int i = 0; i < 20; i++) {
      samples.add(look(i * 0.1, "Switch_Desk", true, i < 10 ? 5 : 65));
    }
    HeadLogAnalysis analysis = HeadLogAnalysis.of(read(write(samples)));
    assertThat(analysis.seconds()).isCloseTo(2, within(1e-9));
    assertThat(analysis.unshown().pauses()).isOne();
    assertThat(analysis.unshown().paused()).isCloseTo(60, within(1e-6));
    assertThat(analysis.head().objects().get(0).looks()).isEqualTo(2);
    assertThat(HeadLogReport.text(analysis)).contains("paused: 1 time, 60.0 s together");
  }

  @Test
  void eachMomentInViewBelongsToOneObjectAtMost() throws IOException {
    List<HeadSample> samples = new ArrayList<>();
    for (int i = 0; i <= 100; i++) {
      // The line of sight goes to and fro over an edge, faster than a dwell ends.
      samples.add(sample(i * 0.1, 1, 0, i % 2 == 0 ? "A" : "B"));
    }
    HeadLogAnalysis analysis = HeadLogAnalysis.of(read(write(samples)).inView(1.05, 8.02));
    assertThat(analysis.seconds()).isCloseTo(6.97, within(1e-9));
    assertThat(analysis.head().objects())
        .extracting(DwellSummary.ObjectView::looks)
        .containsOnly(1);
    assertThat(
            analysis.head().objects().stream().mapToDouble(DwellSummary.ObjectView::seconds).sum())
        .isCloseTo(6.97, within(1e-9));
    assertThat(analysis.head().all())
        .first()
        .satisfies(dwell -> assertThat(dwell.start()).isEqualTo(1.05));
    assertThat(analysis.head().all())
        .allSatisfy(dwell -> assertThat(dwell.end()).isLessThanOrEqualTo(8.02 + 1e-9));
  }

  @Test
  void aLogThatWasNeverInViewHasNoDwells() throws IOException {
    HeadLog log = read(write(List.of(sample(0, 1, 0, "A"), sample(0.1, 1, 0, "A"))));
    HeadLogAnalysis never =
        HeadLogAnalysis.of(log.inView(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY));
    assertThat(never.seconds()).isZero();
    assertThat(never.idle()).isZero();
    assertThat(never.head().all()).isEmpty();
    assertThat(HeadLogAnalysis.of(log.inView(3, 2)).head().objects()).isEmpty();
  }

  @Test
  void aLogFromBeforeThereWasAPictureColumnIsReadAsSeen() throws IOException {
    Path file = write(List.of(look(0, "A", false, 1), look(0.1, "A", false, 1)));
    Files.write(
        file,
        Files.readAllLines(file).stream()
            .map(line -> line.replaceAll("(,[^,]*){3}$", ""))
            .toList());
    assertThat(Files.readAllLines(file).get(0)).endsWith(",frame_ms");
    HeadLog log = read(file);
    assertThat(log.samples()).extracting(HeadSample::moment).containsOnly(HeadSample.Moment.UNTOLD);
    assertThat(HeadLogReport.text(HeadLogAnalysis.of(log))).doesNotContain("left out", "paused");
  }

  @Test
  void aMomentThatCannotBeIsSaidWithItsPlace() throws IOException {
    Path file = write(List.of(look(0, "A", true, 1), look(0.1, "A", true, 1)));
    List<String> lines = new ArrayList<>(Files.readAllLines(file));
    lines.set(2, lines.get(2).replace(",1,2026-01-01T", ",1,2026-01-01 "));
    Files.write(file, lines);
    ProblemCollector problems = new ProblemCollector();
    assertThat(HeadLogReader.read(file, problems).orElseThrow().samples()).hasSize(1);
    assertThat(problems.list().get(0).toString())
        .contains("session.csv:3:", "2026-01-01 00:00:01.100Z", "is not a date and time such as");
  }

  @Test
  void whoLooksRoundAtEyeLevelSeesTheWallsButNeitherFloorNorCeilingNearby() throws IOException {
    List<HeadSample> samples = new ArrayList<>();
    for (int i = 0; i <= 36; i++) {
      samples.add(sample(i * 0.1, 10 * i - 180, 0, ""));
    }
    RoomCoverage room = HeadLogAnalysis.of(read(write(samples))).rooms().get(0);
    assertThat(room.room()).isEqualTo("Office");
    assertThat(room.seconds()).isCloseTo(3.7, within(1e-6));
    assertThat(room.seen()).isBetween(0.2, 0.5);
    assertThat(room.unseen()).containsExactly("floor", "ceiling");
  }

  @Test
  void whoLooksStraightAheadSeesOneWallOnly() throws IOException {
    RoomCoverage room =
        HeadLogAnalysis.of(read(write(List.of(sample(0, 0, 0, ""), sample(1, 0, 0, "")))))
            .rooms()
            .get(0);
    assertThat(room.unseen()).containsExactly("wall -X", "wall +X", "floor", "ceiling", "wall +Z");
  }

  @Test
  void aHeadThatLooksEverywhereHasSeenAll() throws IOException {
    List<HeadSample> samples = new ArrayList<>();
    for (int pitch = -90; pitch <= 90; pitch += 10) {
      for (int yaw = -180; yaw < 180; yaw += 10) {
        samples.add(sample(samples.size() * 0.01, yaw, pitch, ""));
      }
    }
    RoomCoverage room = HeadLogAnalysis.of(read(write(samples))).rooms().get(0);
    assertThat(room.seen()).isEqualTo(1);
    assertThat(room.unseen()).isEmpty();
  }

  @Test
  void bidsDataAreMetresAndQuaternionsAsTheChannelsSay() throws IOException {
    HeadLog log = read(write(List.of(sample(2, 90, 0, "A"), sample(2.5, 90, 0, "A"))));
    Path data = BidsMotionFiles.write(log, folder.resolve("bids"), "07");
    assertThat(data.getFileName()).hasToString("sub-07_task-viewing_tracksys-head_motion.tsv");
    assertThat(Files.readAllLines(data))
        .containsExactly(
            "0.050000\t0.800000\t-0.166667\t0.000000\t0.707107\t0.000000\t0.707107\t0.000000\t1.000000",
            "0.050000\t0.800000\t-0.166667\t0.000000\t0.707107\t0.000000\t0.707107\t0.500000\t1.000000");
    List<String> channels =
        Files.readAllLines(data.resolveSibling("sub-07_task-viewing_tracksys-head_channels.tsv"));
    assertThat(channels).hasSize(1 + 9);
    assertThat(channels.get(1)).isEqualTo("head_POS_x\tx\tPOS\thead\tm\t2.0\tscene");
    JsonNode sidecar =
        new ObjectMapper()
            .readTree(
                data.resolveSibling("sub-07_task-viewing_tracksys-head_motion.json").toFile());
    assertThat(sidecar.get("SamplingFrequency").asDouble()).isEqualTo(2);
    assertThat(sidecar.get("TaskName").asText()).isEqualTo("viewing");
  }

  @Test
  void aPlotShowsRoomsAreasAndWhatWasLookedAt() throws IOException {
    List<HeadSample> samples = new ArrayList<>();
    for (int i = 0; i < 30; i++) {
      samples.add(sample(i * 0.1, i, 0, i < 10 ? "Switch_Desk" : "A<b>"));
    }
    HeadLogAnalysis analysis = HeadLogAnalysis.of(read(write(samples)));
    assertThat(HeadLogPlot.svg(analysis))
        .startsWith("<svg ")
        .contains("DeskProx", "Office: ", "Switch_Desk", "A&lt;b&gt;")
        .endsWith("</svg>\n");
  }

  @Test
  void nothingOfThePlanIsDrawnOverTheNamesOfRoomsAndAreas() throws IOException {
    HeadLogAnalysis analysis =
        HeadLogAnalysis.of(
            read(write(List.of(sample(0, 0, 0, "Switch_Desk"), sample(1, 9, 0, "")))));
    String plan = HeadLogPlot.svg(analysis).split("In the middle of the view")[0];
    String afterNames = plan.substring(plan.indexOf(">DeskProx<"));
    assertThat(afterNames).contains("Office: ").doesNotContain("<path", "<circle");
  }
}
