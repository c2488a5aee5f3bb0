package org.selectiverenderer.study.dataset;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;

/** What a session's journal says after somebody has set the wall clock. */
class RecordedSessionTest {
  @TempDir private Path folder;

  @BeforeEach
  void write() throws IOException {
    RecordedStudyFixture.write(folder);
  }

  private RecordedSession session(String events) throws IOException {
    Files.writeString(folder.resolve("sub-001/ses-01/events.jsonl"), events);
    ProblemCollector problems = new ProblemCollector();
    return RecordedStudy.read(RecordedStudyFixture.material(folder), problems).sessions().get(0);
  }

  @Test
  void durationsComeFromTheMonotonicClock() throws IOException {
    RecordedSession session =
        session(
            """
            {"time":"2026-03-01T10:00:00Z","event":"session-began","mono":100.0,"participant":"001","session":1}
            {"time":"2026-03-01T10:00:01Z","event":"step-began","step":"exposure-hall","mono":101.0,"head_log":"exposure-hall_run-01"}
            {"time":"2026-03-01T10:00:03Z","event":"shown","step":"exposure-hall","mono":103.0,"t":1.0}
            {"time":"2026-03-01T10:00:05Z","event":"paused","step":"exposure-hall","mono":105.0}
            {"time":"2026-03-01T09:00:07Z","event":"continued","step":"exposure-hall","mono":107.5}
            {"time":"2026-03-01T09:00:08Z","event":"note","mono":108.5,"text":"clock set back"}
            {"time":"2026-03-01T09:00:11Z","event":"step-finished","step":"exposure-hall","mono":111.5}
            """);
    assertThat(session.duration()).isEqualTo(11.5);
    assertThat(SessionsTable.row(session, 1).get(3)).isEqualTo(11.5);
    assertThat(SessionsTable.row(session, 1).get(4)).as("in view").isEqualTo(5.0);
    RecordedRun run = session.runs().get(0);
    assertThat(run.paused()).isEqualTo(2.5);
    assertThat(run.beganAt(Optional.empty())).hasValue(2);
    List<List<Object>> rows =
        RunEventsTable.rows(run, Optional.empty(), 1).stream()
            .map(row -> List.<Object>of(row.get(0), row.get(1), row.get(2)))
            .collect(Collectors.toList());
    assertThat(rows)
        .containsExactly(
            List.of(1.0, Double.NaN, "exposure"),
            List.of(3.0, 2.5, "pause"),
            List.of(6.5, 0.0, "note"));
  }

  @Test
  void aResumedSessionHasAnotherOriginAndItsBreakComesFromTheWallClock() throws IOException {
    assertThat(
            session(
                    """
                    {"time":"2026-03-01T10:00:00Z","event":"session-began","mono":9000.0}
                    {"time":"2026-03-01T10:00:10Z","event":"note","mono":9010.0}
                    {"time":"2026-03-01T10:01:10Z","event":"journal-mended","mono":20.0}
                    {"time":"2026-03-01T10:01:10Z","event":"resumed","mono":20.5}
                    {"time":"2026-03-01T10:01:12Z","event":"session-finished","mono":22.5}
                    """)
                .duration())
        .isEqualTo(72.5);
    assertThat(
            session(
                    """
                    {"time":"2026-03-01T10:00:00Z","event":"session-began","mono":10.0}
                    {"time":"2026-03-01T09:00:00Z","event":"resumed","mono":900.0}
                    {"time":"2026-03-01T09:00:02Z","event":"session-finished","mono":902.0}
                    """)
                .duration())
        .as("a break of which nobody knows the length")
        .isEqualTo(2);
  }

  @Test
  void anOlderJournalHasNoNegativeDuration() throws IOException {
    assertThat(
            session(
                    """
                    {"time":"2026-03-01T10:00:00Z","event":"session-began"}
                    {"time":"2026-03-01T09:00:00Z","event":"note"}
                    {"time":"2026-03-01T09:00:05Z","event":"session-finished"}
                    """)
                .duration())
        .isEqualTo(5);
  }
}
