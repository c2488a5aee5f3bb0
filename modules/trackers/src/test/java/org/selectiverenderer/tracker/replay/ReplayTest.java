package org.selectiverenderer.tracker.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.Orientation;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.RecordingTrackerListener;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerHealth.State;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerOptions.Smoothing;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.factory.TrackerFactory;

class ReplayTest {
  @TempDir Path folder;
  private final RecordingTrackerListener watching = new RecordingTrackerListener();

  @Test
  void columnsAreFoundByNameInAHeadLogToo() throws IOException {
    Path file =
        file("frame,roll,t,x,yaw,object,pitch\n1,3,0.5,9,1,\"Desk, left\",2\n2,6,0.5,9,4,,5\n");
    ReplayLog log = log(file);
    PoseSample pose = new PoseSample();
    log.pose(1, pose);
    assertThat(log.size()).isEqualTo(2);
    assertThat(log.time(0)).isEqualTo(0.5);
    assertThat(pose.orientation()).isEqualTo(new Orientation(4, 5, 6));
  }

  @Test
  void isPlayedAtItsPaceToItsEnd() throws IOException {
    Path file = file("t,yaw,pitch,roll\n10,1,0,0\n10.01,2,0,0\n10.02,3,0,0\n");
    try (HeadTracker tracker = open(file)) {
      watching.until("the end", () -> tracker.health().state() == State.ENDED);
      assertThat(watching.orientations)
          .containsExactly(
              new Orientation(1, 0, 0), new Orientation(2, 0, 0), new Orientation(3, 0, 0));
      PoseSample pose = new PoseSample();
      assertThat(tracker.read(pose)).isTrue();
      assertThat(pose.yaw()).isEqualTo(3);
    }
  }

  @Test
  void placesAreReadFromTheirColumns() throws IOException {
    ReplayLog log = log(file("t,yaw,pitch,roll,right,up,back\n0,1,2,3,0.1,0.2,-0.3\n1,1,2,3,,,\n"));
    assertThat(log.placed()).isTrue();
    PoseSample pose = new PoseSample();
    log.pose(0, pose);
    assertThat(pose.placed()).isTrue();
    assertThat(new double[] {pose.x(), pose.y(), pose.z()}).containsExactly(0.1, 0.2, -0.3);
    log.pose(1, pose);
    assertThat(pose.placed()).isFalse();
    assertThat(log(file("t,yaw,pitch,roll,x,y,z\n0,1,2,3,4,5,6\n")).placed()).isFalse();
  }

  @Test
  void aPlaceThatIsThereInPartIsAFault() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    Path half = file("t,yaw,pitch,roll,right,up,back\n0,1,2,3,0.1,,0\n");
    assertThat(ReplayLog.read(half, problems)).isEmpty();
    assertThat(problems.list()).singleElement().asString().contains(":2:13: a number is missing");
    Path missing = file("t,yaw,pitch,roll,right\n0,1,2,3,0.1\n");
    assertThat(ReplayLog.read(missing, new ProblemCollector())).isEmpty();
  }

  @Test
  void placesArePlayedAsTheyWereRecorded() throws IOException {
    Path file = file("t,yaw,pitch,roll,right,up,back\n0,1,0,0,0.1,0.2,0.3\n0.01,2,0,0,,,\n");
    try (HeadTracker tracker = open(file)) {
      watching.until("the end", () -> tracker.health().state() == State.ENDED);
      assertThat(tracker.placed()).isTrue();
    }
    assertThat(watching.places).containsExactly("0.1 0.2 0.3", "none");
    PoseSample pose = new PoseSample();
    try (FrameSteppedReplay replay =
        new FrameSteppedReplay(new TrackerSpec.Replay(file), log(file), TrackerOptions.NONE)) {
      replay.advanceTo(0);
      assertThat(replay.read(pose)).isTrue();
      assertThat(pose.placed()).isTrue();
      assertThat(pose.y()).isEqualTo(0.2);
      replay.advanceTo(1);
      assertThat(replay.read(pose)).isTrue();
      assertThat(pose.placed()).isFalse();
    }
  }

  @Test
  void steppedByFramesTheSameTimesGiveTheSamePoses() throws IOException {
    StringBuilder text = new StringBuilder("t,yaw,pitch,roll\n");
    for (int i = 0; i < 200; i++) {
      text.append(i / 120.0).append(',').append(50 * Math.sin(i / 30.0)).append(",1,2\n");
    }
    Path file = file(text.toString());
    TrackerOptions options =
        new TrackerOptions(Optional.empty(), Set.of(), Optional.of(Smoothing.DEFAULT), 0.03);
    assertThat(frames(file, options)).isEqualTo(frames(file, options)).hasSize(90);
  }

  @Test
  void steppedByFramesTheNewestRowThatIsNotLaterCounts() throws IOException {
    Path file = file("t,yaw,pitch,roll\n0.1,1,0,0\n0.2,2,0,0\n0.3,3,0,0\n");
    try (FrameSteppedReplay replay =
        new FrameSteppedReplay(new TrackerSpec.Replay(file), log(file), TrackerOptions.NONE)) {
      PoseSample pose = new PoseSample();
      replay.advanceTo(0.05);
      assertThat(replay.read(pose)).isFalse();
      replay.advanceTo(0.2);
      assertThat(replay.read(pose)).isTrue();
      assertThat(pose.yaw()).isEqualTo(2);
      replay.advanceTo(9);
      replay.read(pose);
      assertThat(pose.yaw()).isEqualTo(3);
      assertThat(replay.health().state()).isEqualTo(State.ENDED);
      replay.advanceTo(0.1);
      replay.read(pose);
      assertThat(pose.yaw()).as("going back").isEqualTo(1);
    }
  }

  @Test
  void aRowTornByACrashIsPassedOver() throws IOException {
    Path file = file("t,yaw,pitch,roll\n0,1,2,3\n0.1,4,");
    ProblemCollector problems = new ProblemCollector();
    assertThat(ReplayLog.read(file, problems)).map(ReplayLog::size).contains(1);
    assertThat(problems.any()).isFalse();
    assertThat(problems.list())
        .extracting(Problem::toString)
        .containsExactly(file + ":3:1: the last row is incomplete; it is ignored");
  }

  @Test
  void faultsAreReportedWithTheirPlacesAndNothingIsPlayed() throws IOException {
    Path file = file("t,yaw,pitch,roll\n1,1,2,x\n2,NaN,0,0\n1.5,0,0,0\n");
    assertThatThrownBy(() -> open(file).close())
        .isInstanceOf(TrackerException.class)
        .hasMessage("the log " + file + " has errors");
    assertThat(watching.problems)
        .extracting(Problem::toString)
        .containsExactly(
            file + ":2:7: 'x' is not a number; the log is not played",
            file + ":3:3: 'NaN' is not a number; the log is not played");
  }

  @Test
  void timesMayBeTheSameButNotGoBack() throws IOException {
    Path file = file("t,yaw,pitch,roll\n1,0,0,0\n1,0,0,0\n0.5,0,0,0\n");
    ProblemCollector problems = new ProblemCollector();
    assertThat(ReplayLog.read(file, problems)).isEmpty();
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly("the time 0.5 is earlier than the row before; the log is not played");
  }

  @Test
  void aLogWithoutAnglesOrThatIsNotThereIsRefused() throws IOException {
    Path file = file("t,x,y,z\n0,1,2,3\n");
    assertThatThrownBy(() -> open(file).close()).isInstanceOf(TrackerException.class);
    assertThat(watching.messages().get(0))
        .contains(
            "the header lacks yaw, pitch, roll (it must be t,yaw,pitch,roll or t,yaw,pitch,roll,right,up,back)");
    Path none = folder.resolve("none.csv");
    assertThatThrownBy(() -> open(none).close())
        .isInstanceOf(TrackerException.class)
        .hasMessage("there is no log " + none);
  }

  private List<Orientation> frames(Path file, TrackerOptions options) throws IOException {
    List<Orientation> frames = new ArrayList<>();
    try (FrameSteppedReplay replay =
        new FrameSteppedReplay(new TrackerSpec.Replay(file), log(file), options)) {
      PoseSample pose = new PoseSample();
      for (int frame = 0; frame < 90; frame++) {
        replay.advanceTo(frame / 60.0);
        assertThat(replay.read(pose)).isTrue();
        frames.add(pose.orientation());
      }
    }
    return frames;
  }

  private HeadTracker open(Path file) throws IOException {
    return TrackerFactory.open(new TrackerSpec.Replay(file), TrackerOptions.NONE, watching);
  }

  private static ReplayLog log(Path file) throws IOException {
    return ReplayLog.read(file, new ProblemCollector()).orElseThrow();
  }

  private Path file(String text) throws IOException {
    return Files.writeString(folder.resolve("log.csv"), text);
  }
}
