package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.OffsetDateTime;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.study.definition.SessionFlag;

class SessionJournalTest {
  @TempDir private Path folder;
  private OffsetDateTime wall = OffsetDateTime.parse("2026-03-01T10:00:00Z");
  private long nanos = 5_000_000_000L;

  private void pass(double seconds, double byTheWall) {
    nanos += Math.round(seconds * 1e9);
    wall = wall.plusNanos(Math.round(byTheWall * 1e9));
  }

  @Test
  void eachEventHasTheMonotonicTimeAndAWallClockThatMovesIsFlaggedOnce() throws IOException {
    Path file = folder.resolve("events.jsonl");
    try (SessionJournal journal =
        SessionJournal.begin(file, new JournalClock(() -> wall, () -> nanos))) {
      journal.tell("session-began", Map.of());
      pass(10, 11.9);
      journal.tell("within", Map.of());
      pass(10, -3600);
      journal.tell("note", Map.of("step", "exposure-hall", "text", "set back"));
      pass(1.5, 1.5);
      journal.keep("end", Map.of());
    }
    assertThat(Files.readAllLines(file))
        .containsExactly(
            "{\"time\":\"2026-03-01T10:00Z\",\"event\":\"session-began\",\"mono\":5.0}",
            "{\"time\":\"2026-03-01T10:00:11.900Z\",\"event\":\"within\",\"mono\":15.0}",
            "{\"time\":\"2026-03-01T09:00:11.900Z\",\"event\":\"flag\",\"step\":\"exposure-hall\","
                + "\"flag\":\"clock-moved\",\"seconds\":-3608.1,\"mono\":25.0}",
            "{\"time\":\"2026-03-01T09:00:11.900Z\",\"event\":\"note\",\"step\":\"exposure-hall\","
                + "\"text\":\"set back\",\"mono\":25.0}",
            "{\"time\":\"2026-03-01T09:00:13.400Z\",\"event\":\"end\",\"mono\":26.5}");
    assertThat(SessionHistory.read(file).flags())
        .containsExactly(new SessionFlagEvent(SessionFlag.CLOCK_MOVED, "exposure-hall"));
  }
}
