package org.selectiverenderer.study.headlog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.replay.ReplayLog;

class TrackerLogWriterTest {
  @TempDir private Path folder;

  private Path write() throws IOException {
    Path headLog = folder.resolve("p01.csv");
    try (TrackerLogWriter log =
        TrackerLogWriter.open(
            headLog, false, "intertrax2:/dev/ttyUSB0", false, 100, problem -> {})) {
      for (int i = 1; i <= 3; i++) {
        log.add(
            new TrackerRecord(
                i,
                100 + i / 250.0,
                Instant.parse("2026-01-01T12:00:00Z").plusMillis(4 * i),
                10.00004 * i,
                -1,
                0,
                Optional.empty()));
      }
    }
    return folder.resolve("p01_tracker.csv");
  }

  @Test
  void recordsAreWrittenAsTheyArriveAndCanBeReplayed() throws IOException {
    Path file = write();
    assertThat(Files.readAllLines(file))
        .containsExactly(
            "t,yaw,pitch,roll,number,wall,mono",
            "0.004000,10.0000,-1.0000,0.0000,1,2026-01-01T12:00:00.004Z,100.004000",
            "0.008000,20.0001,-1.0000,0.0000,2,2026-01-01T12:00:00.008Z,100.008000",
            "0.012000,30.0001,-1.0000,0.0000,3,2026-01-01T12:00:00.012Z,100.012000");
    ReplayLog replay = ReplayLog.read(file, new ProblemCollector()).orElseThrow();
    assertThat(replay.size()).isEqualTo(3);
    assertThat(replay.duration()).isCloseTo(2 / 250.0, within(1e-5));
  }

  @Test
  void placesAreWrittenAndDescribedWhereTheTrackerTellsThem() throws IOException {
    Instant wall = Instant.parse("2026-01-01T12:00:00Z");
    Optional<TrackerRecord.Place> place =
        Optional.of(new TrackerRecord.Place(0.1, -0.25, 0.000004));
    try (TrackerLogWriter log =
        TrackerLogWriter.open(
            folder.resolve("p02.csv"), false, "opentrack:4242", true, 9, problem -> {})) {
      log.add(new TrackerRecord(1, 10, wall, 1, 2, 3, place));
      log.add(new TrackerRecord(2, 11, wall, 1, 2, 3, Optional.empty()));
    }
    Path file = folder.resolve("p02_tracker.csv");
    assertThat(Files.readAllLines(file))
        .containsExactly(
            "t,yaw,pitch,roll,number,wall,mono,right,up,back",
            "1.000000,1.0000,2.0000,3.0000,1,2026-01-01T12:00:00.000Z,10.000000,0.10000,-0.25000,0.00000",
            "2.000000,1.0000,2.0000,3.0000,2,2026-01-01T12:00:00.000Z,11.000000,,,");
    JsonNode told = new ObjectMapper().readTree(folder.resolve("p02_tracker.json").toFile());
    List<String> columns = new ArrayList<>();
    told.get("columns").fieldNames().forEachRemaining(columns::add);
    assertThat(Files.readAllLines(file).get(0)).isEqualTo(String.join(",", columns));
    ReplayLog replay = ReplayLog.read(file, new ProblemCollector()).orElseThrow();
    PoseSample pose = new PoseSample();
    replay.pose(0, pose);
    assertThat(new double[] {pose.x(), pose.y(), pose.z()}).containsExactly(0.1, -0.25, 0);
    replay.pose(1, pose);
    assertThat(pose.placed()).isFalse();
  }

  @Test
  void theDescriptionNamesTheTrackerAndEveryColumn() throws IOException {
    Path file = write();
    JsonNode told = new ObjectMapper().readTree(folder.resolve("p01_tracker.json").toFile());
    assertThat(told.get("tracker").asText()).isEqualTo("intertrax2:/dev/ttyUSB0");
    assertThat(told.get("head_log").asText()).isEqualTo("p01.csv");
    List<String> columns = new ArrayList<>();
    told.get("columns").fieldNames().forEachRemaining(columns::add);
    assertThat(Files.readAllLines(file).get(0)).isEqualTo(String.join(",", columns));
  }

  @Test
  void aLogThatIsThereIsKept() throws IOException {
    Path file = write();
    byte[] before = Files.readAllBytes(file);
    assertThatThrownBy(
            () ->
                TrackerLogWriter.open(
                    folder.resolve("p01.csv"), false, "none", false, 0, problem -> {}))
        .isInstanceOf(FileAlreadyExistsException.class)
        .hasMessageContaining("p01_tracker");
    assertThat(file).hasBinaryContent(before);
  }
}
