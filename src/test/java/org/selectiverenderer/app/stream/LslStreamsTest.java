package org.selectiverenderer.app.stream;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.head.HeadSampleListener;
import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.app.run.SceneRunner;
import org.selectiverenderer.app.settings.MotionSettings;
import org.selectiverenderer.app.settings.PathPlaybackSettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.apparatus.MouseButtonMapping;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.lsl.LslLibrary;
import org.selectiverenderer.lsl.LslOutlet;
import org.selectiverenderer.lsl.StreamInfo;
import org.selectiverenderer.study.headlog.EyeSample;
import org.selectiverenderer.study.headlog.HeadLogMetadata;
import org.selectiverenderer.study.headlog.HeadSample;
import org.selectiverenderer.study.headlog.SceneMap;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/** With the real liblsl, and another process at the other end. */
@Timeout(120)
class LslStreamsTest {
  /** Other programs may stream in the same network: ours are known by this. */
  private final String id = UUID.randomUUID().toString();

  @TempDir private Path folder = Path.of("");
  private final BlockingQueue<JsonNode> told = new LinkedBlockingQueue<>();
  private LslLibrary lsl;

  @BeforeEach
  void library() throws IOException {
    lsl = LslPeer.library();
  }

  private void tell(String event, Map<String, ?> more) {
    told.add(JsonTree.of(Map.of("event", event, "more", more)));
  }

  /** Walks past a box that fills the view for the first of two seconds. */
  private void walk(LslStreams streams) throws IOException, InterruptedException {
    Path scene =
        Files.writeString(
            folder.resolve("scene.x3d"),
            """
            <X3D version='4.0' profile='Immersive'><Scene>
              <Transform DEF='Box' translation='0 0 -5'><Shape><Box size='4 4 1'/></Shape></Transform>
            </Scene></X3D>
            """);
    Path walked =
        Files.writeString(
            folder.resolve("path.csv"), "t,x,y,z,yaw,pitch,roll\n0,0,0,0,0,0,0\n1,1,0,0,90,0,0\n");
    RunSettings settings =
        new RunSettings(scene, SelectiveController.Settings.SELECTIVE)
            .with(
                new MotionSettings(
                    MouseButtonMapping.OFF,
                    CameraPathReader.read(walked, new ProblemCollector())
                        .map(path -> PathPlaybackSettings.at(10, path))));
    SceneRunner.simulated(settings, new Listener(streams));
  }

  private record Listener(LslStreams streams) implements RunListener {
    @Override
    public void problem(Problem problem) {
      throw new AssertionError(problem);
    }

    @Override
    public void happened(TimelineEvent event) {
      streams.happened(event);
    }

    @Override
    public void printed(String text) {
      throw new AssertionError(text);
    }

    @Override
    public Optional<HeadSampleListener> samples() {
      return streams.samples();
    }
  }

  @Test
  void anotherProgramReceivesPosesWhatIsLookedAtAndEvents() throws Exception {
    List<JsonNode> poses = new ArrayList<>();
    double before = lsl.clock();
    try (LslStreams streams = LslStreams.sending(lsl, Map.of("study", id), this::tell);
        LslPeer posing = LslPeer.start("receive", "SelectiveRenderer-Pose", id);
        LslPeer looking = LslPeer.start("receive", "SelectiveRenderer-Gaze", id);
        LslPeer hearing = LslPeer.start("receive", "SelectiveRenderer-Events", id)) {
      assertThat(posing.next())
          .isEqualTo(
              "[\"MoCap\", \"Head_PosX\", \"Head_PosY\", \"Head_PosZ\", \"Head_OriX\","
                  + " \"Head_OriY\", \"Head_OriZ\", \"Head_OriW\", \"SceneTime\"]");
      assertThat(looking.next()).isEqualTo("[\"Gaze\", \"object\"]");
      assertThat(hearing.next()).isEqualTo("[\"Markers\", \"event\"]");
      walk(streams);
      streams.event(
          JsonTree.parse(
              """
              {"time": "2026-03-01T10:00:00Z", "event": "answer", "step": "recognition-hall",
               "object": "boat", "value": "yes", "confidence": 4, "condition": "high"}
              """));
      streams.event(
          JsonTree.parse(
              """
              {"time": "2026-03-01T10:00:01Z", "event": "assigned", "condition": "high", "place": 7,
               "assigned_by": "schedule", "age": "18-22"}
              """));
      for (int frame = 0; frame <= 10; frame++) {
        poses.add(JsonTree.parse(posing.next()));
      }
      assertThat(JsonTree.parse(looking.next()).path(1).asText()).isEqualTo("Box");
      assertThat(JsonTree.parse(looking.next()).path(1).asText()).isEqualTo("none");
      List<JsonNode> events = new ArrayList<>();
      while (events.stream().noneMatch(event -> event.path("event").asText().equals("assigned"))) {
        events.add(JsonTree.parse(JsonTree.parse(hearing.next()).path(1).asText()));
      }
      assertThat(events)
          .extracting(event -> event.path("event").asText())
          .containsExactly("start", "end", "answer", "assigned");
      assertThat(events.get(2).toString())
          .as("no answer and no condition goes out")
          .isEqualTo(
              "{\"event\":\"answer\",\"step\":\"recognition-hall\",\"object\":\"boat\","
                  + "\"study\":\""
                  + id
                  + "\"}");
      assertThat(events.get(3).toString())
          .as("nor the place in the schedule, which tells the condition")
          .isEqualTo("{\"event\":\"assigned\",\"study\":\"" + id + "\"}");
    }
    double half = Math.sqrt(0.5);
    double[] last = {1, 0, 0, 0, half, 0, half, 1};
    for (int channel = 0; channel < last.length; channel++) {
      assertThat(poses.get(10).path(channel + 1).asDouble()).isCloseTo(last[channel], within(1e-9));
    }
    assertThat(poses).extracting(pose -> pose.path(0).asDouble()).isSorted();
    assertThat(poses.get(0).path(0).asDouble())
        .as("stamped by the library's clock")
        .isBetween(before - 1, lsl.clock() + 1);
    assertThat(told).isEmpty();
  }

  @Test
  void whereTheEyesLookGoesOutWhereAHeadsetTracksThem() throws Exception {
    try (LslStreams streams = LslStreams.sending(lsl, Map.of("study", id), this::tell)) {
      HeadSampleListener eyes = streams.samples().orElseThrow();
      eyes.scene(
          new HeadLogMetadata(
              "", "scene.x3d", "high", 0, "headset", "none", 1, 1, 1, 10, true, SceneMap.EMPTY));
      try (LslPeer looking = LslPeer.start("receive", "SelectiveRenderer-Eyes", id);
          LslPeer naming = LslPeer.start("receive", "SelectiveRenderer-EyeObject", id)) {
        assertThat(looking.next())
            .isEqualTo(
                "[\"Gaze\", \"Gaze_DirX\", \"Gaze_DirY\", \"Gaze_DirZ\", \"Gaze_Yaw\","
                    + " \"Gaze_Pitch\", \"Tracked\"]");
        assertThat(naming.next()).isEqualTo("[\"Gaze\", \"object\"]");
        eyes.sampled(looking(new EyeSample(true, -30, 0, "Lamp", 2, 0)), System.nanoTime());
        eyes.sampled(looking(EyeSample.LOST), System.nanoTime());
        JsonNode seen = JsonTree.parse(looking.next());
        double[] right = {1, 0, 0, -30, 0, 1}; // The head is turned by 60 degrees already.
        for (int channel = 0; channel < right.length; channel++) {
          assertThat(seen.path(channel + 1).asDouble()).isCloseTo(right[channel], within(1e-9));
        }
        assertThat(looking.next()).endsWith(" 0.0]");
        assertThat(JsonTree.parse(naming.next()).path(1).asText()).isEqualTo("Lamp");
        assertThat(JsonTree.parse(naming.next()).path(1).asText()).isEqualTo("none");
      }
    }
    assertThat(told).isEmpty();
  }

  private static HeadSample looking(EyeSample eyes) {
    HeadSample.Moment moment = HeadSample.Moment.UNTOLD;
    return new HeadSample(
            0,
            0,
            0,
            0,
            -60,
            0,
            0,
            false,
            "",
            Double.NaN,
            -1,
            List.of(),
            List.of(),
            10,
            moment,
            null)
        .looking(eyes);
  }

  private JsonNode awaited(String event) throws InterruptedException {
    JsonNode next = told.poll(60, TimeUnit.SECONDS);
    assertThat(next).isNotNull();
    assertThat(next.path("event").asText()).as(next.toString()).isEqualTo(event);
    return next.path("more");
  }

  /** Waits until the other process has sent so many lines. */
  private static void awaitLines(Path file, int lines) {
    Eventually.await(
        lines + " lines in " + file,
        () -> Files.exists(file) && Files.readAllLines(file).size() >= lines);
  }

  private static List<String> column(Path file, String name) throws IOException {
    CsvTable table =
        CsvTable.parse(
                file.toString(),
                Files.readAllBytes(file),
                (at, fault) -> {
                  throw new AssertionError(at + ": " + fault);
                })
            .orElseThrow();
    return table.rows().stream().map(row -> row.cell(name)).toList();
  }

  @Test
  void streamsOfAnotherProgramAreRecordedWithTheOffsetsOfItsClock() throws Exception {
    Path streamed = folder.resolve("streams");
    Path eeg = streamed.resolve("Amplifier_run-01.csv");
    Path buttons = streamed.resolve("Buttons_run-01.csv");
    try (LslPeer amplifier = LslPeer.start("send", id);
        LslStreams streams = LslStreams.none()) {
      assertThat(amplifier.next()).isEqualTo("ready");
      streams.record(
          lsl,
          List.of("type='EEG' and source_id='" + id + "'", "starts-with(source_id,'" + id + "')"),
          streamed,
          this::tell);
      assertThat(List.of(awaited("stream-began"), awaited("stream-began")))
          .extracting(stream -> stream.path("file").asText())
          .containsExactlyInAnyOrder("Amplifier_run-01.csv", "Buttons_run-01.csv");
      awaitLines(eeg, 30);
      awaitLines(buttons, 3);
    }
    assertThat(awaited("stream-ended").path("samples").asInt()).isPositive();
    assertThat(awaited("stream-ended").path("samples").asInt()).isPositive();
    List<String> left = column(eeg, "Pz, left");
    assertThat(column(eeg, "Cz"))
        .as("no sample is missing")
        .isEqualTo(left.stream().map(value -> value.replace(".5", "")).toList());
    assertThat(column(buttons, "channel1")).allMatch(text -> text.matches("button \\d+0?, \u00e9"));
    JsonNode description = JsonTree.read(streamed.resolve("Amplifier_run-01.json"));
    assertThat(description.path("type").asText()).isEqualTo("EEG");
    assertThat(description.path("nominal_rate_hz").asDouble()).isEqualTo(100);
    assertThat(description.path("channels").path(1).path("unit").asText()).isEqualTo("microvolts");
    Path offsets = streamed.resolve("Amplifier_run-01.offsets.csv");
    List<String> measured = column(offsets, "offset");
    assertThat(measured.get(measured.size() - 1)).as("both clocks are this machine's").isNotEmpty();
    assertThat(Double.parseDouble(measured.get(measured.size() - 1))).isCloseTo(0, within(0.1));
  }

  @Test
  void aMarkerThatTellsOfACalibrationIsAnEvent() throws Exception {
    StreamInfo markers =
        StreamInfo.sent(
            "Tracker", "Markers", List.of(new StreamInfo.Channel("text", "", "Marker")), true, id);
    try (LslOutlet tracker = lsl.outlet(markers);
        LslStreams streams = LslStreams.none()) {
      streams.record(lsl, List.of("source_id='" + id + "'"), folder.resolve("in"), this::tell);
      Path file = folder.resolve("in").resolve(awaited("stream-began").path("file").asText());
      // What is sent before the recorder has connected reaches nobody.
      Eventually.await(
          "a recorded marker",
          () -> {
            tracker.push(lsl.clock(), "blink");
            return Files.exists(file) && Files.readAllLines(file).size() > 1;
          });
      double time = lsl.clock();
      tracker.push(time, "Calibration ended, 0.4 degrees");
      JsonNode calibration = awaited("calibration");
      assertThat(calibration.path("by").asText()).isEqualTo("stream");
      assertThat(calibration.path("stream").asText()).isEqualTo("Tracker");
      assertThat(calibration.path("text").asText()).isEqualTo("Calibration ended, 0.4 degrees");
      assertThat(calibration.path("stream_time").asDouble()).isCloseTo(time, within(1e-6));
    }
    assertThat(awaited("stream-ended").path("samples").asInt()).isGreaterThan(1);
  }

  @Test
  void aStreamOfAnotherRunOfTheSessionDoesNotReplaceTheFirst() throws Exception {
    Path streamed = Files.createDirectories(folder.resolve("streams"));
    Files.writeString(streamed.resolve("Amplifier_run-01.json"), "kept");
    try (LslPeer amplifier = LslPeer.start("send", id);
        LslStreams streams = LslStreams.none()) {
      assertThat(amplifier.next()).isEqualTo("ready");
      streams.record(lsl, List.of("source_id='" + id + "'"), streamed, this::tell);
      assertThat(awaited("stream-began").path("file").asText()).isEqualTo("Amplifier_run-02.csv");
    }
    assertThat(streamed.resolve("Amplifier_run-01.json")).hasContent("kept");
  }

  @Test
  void aFileThatIsNoLiblslIsSaidToBeNone() throws IOException {
    Path text = Files.writeString(folder.resolve("liblsl.so"), "no library");
    assertThatThrownBy(() -> LslLibrary.open(Optional.of(text)))
        .isInstanceOf(IOException.class)
        .hasMessage(
            text
                + ": cannot be loaded as liblsl, the library of the Lab Streaming Layer; take the"
                + " one for this machine from https://github.com/sccn/liblsl/releases");
    Path missing = folder.resolve("none.so");
    assertThatThrownBy(() -> LslLibrary.open(Optional.of(missing)))
        .isInstanceOf(IOException.class)
        .hasMessage(
            missing
                + ": there is no such file; --lsl-library or SELECTIVE_RENDERER_LSL must name the"
                + " file of liblsl");
  }
}
