package org.selectiverenderer.experiment.headlog;

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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.tracker.replay.ReplayLog;

class TrackerLogTest {
  @TempDir private Path folder;

  private Path write() throws IOException {
    Path headLog = folder.resolve("p01.csv");
    try (TrackerLog log =
        TrackerLog.open(headLog, false, "intertrax2:/dev/ttyUSB0", 100, problem -> {})) {
      for (int i = 1; i <= 3; i++) {
        log.add(
            new TrackerRecord(
                i,
                100 + i / 250.0,
                Instant.parse("2026-01-01T12:00:00Z").plusMillis(4 * i),
                10.00004 * i,
                -1,
                0));
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
    ReplayLog replay = ReplayLog.read(file, new Problems()).orElseThrow();
    assertThat(replay.size()).isEqualTo(3);
    assertThat(replay.duration()).isCloseTo(2 / 250.0, within(1e-5));
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
            () -> TrackerLog.open(folder.resolve("p01.csv"), false, "none", 0, problem -> {}))
        .isInstanceOf(FileAlreadyExistsException.class)
        .hasMessageContaining("p01_tracker");
    assertThat(file).hasBinaryContent(before);
  }
}
