package org.selectiverenderer.experiment.dataset;

import java.io.IOException;
import java.time.OffsetDateTime;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.experiment.questionnaire.GivenAnswer;
import org.selectiverenderer.experiment.session.SessionFolder;
import org.selectiverenderer.experiment.session.SessionHistory;
import org.selectiverenderer.experiment.study.SessionFlag;

/** A session as its journal tells it. */
public final class RecordedSession {
  private final SessionFolder folder;
  private final List<JournalLine> events;
  private final List<RecordedRun> runs;
  private final SessionHistory history;

  private RecordedSession(SessionFolder folder, List<JournalLine> events) {
    this.folder = folder;
    this.events = List.copyOf(events);
    runs = runs(events);
    history = SessionHistory.of(events.stream().map(JournalLine::members).toList());
  }

  /**
   * Reads a session.
   *
   * @param problems hears of what is damaged
   * @return empty when there are no events in it, which {@code problems} has heard
   * @throws IOException if its journal cannot be read at all
   */
  static Optional<RecordedSession> read(SessionFolder folder, Problems problems)
      throws IOException {
    List<JournalLine> events = JournalLine.read(folder.journal(), problems);
    if (events.isEmpty()) {
      problems.warning(
          Location.of(folder.journal().toString()), "the session has no events; it is left out");
      return Optional.empty();
    }
    return Optional.of(new RecordedSession(folder, events));
  }

  private List<RecordedRun> runs(List<JournalLine> all) {
    List<RecordedRun> found = new ArrayList<>();
    Map<String, Integer> counted = new HashMap<>();
    List<JournalLine> own = new ArrayList<>();
    for (JournalLine line : all) {
      if (line.event().equals("step-began")) {
        add(found, own, counted);
        own = new ArrayList<>();
      }
      own.add(line);
    }
    add(found, own, counted);
    return List.copyOf(found);
  }

  /** What one step's beginning leads to the next one's; after the end of a step nothing is its. */
  private void add(List<RecordedRun> found, List<JournalLine> lines, Map<String, Integer> counted) {
    if (lines.isEmpty() || !lines.get(0).members().has("head_log")) {
      return;
    }
    String step = lines.get(0).step();
    int end = lines.size();
    boolean finished = false;
    for (int i = 1; i < lines.size(); i++) {
      String event = lines.get(i).event();
      if (event.equals("step-finished") || event.equals("resumed")) {
        finished = event.equals("step-finished");
        end = finished ? i + 1 : i;
        break;
      }
    }
    int number = counted.merge(step, 1, Integer::sum);
    String log = lines.get(0).text("head_log");
    found.add(new RecordedRun(this, step, number, log, finished, lines.subList(0, end)));
  }

  public SessionFolder folder() {
    return folder;
  }

  /** All that happened, in order. */
  public List<JournalLine> events() {
    return events;
  }

  /** The scenes that were shown, in order. */
  public List<RecordedRun> runs() {
    return runs;
  }

  /** When it began. */
  public OffsetDateTime began() {
    return events.get(0).time();
  }

  /** The last that is known of it. */
  public OffsetDateTime ended() {
    return events.get(events.size() - 1).time();
  }

  /** How objects were rendered; empty when no condition was assigned. */
  public String condition() {
    return events.stream()
        .filter(line -> line.event().equals("assigned"))
        .map(line -> line.text("condition"))
        .findFirst()
        .orElse("");
  }

  /** How it ended, as {@code sessions} tables have it. */
  public String outcome() {
    String outcome = "unfinished";
    for (JournalLine line : events) {
      switch (line.event()) {
        case "session-finished" -> outcome = "finished";
        case "refused" -> outcome = "refused";
        case "aborted" -> outcome = "aborted";
        case "resumed" -> outcome = "unfinished";
        default -> {
          // Says nothing of the end.
        }
      }
    }
    return outcome;
  }

  /** Whether a simulated participant took part, if only for a while. */
  public boolean simulated() {
    return history.unattended();
  }

  /** What is to be known of its quality, each once, in order. */
  public List<String> flags() {
    return history.raised().stream().map(SessionFlag::spelling).toList();
  }

  /** The answers of each step so far, personal ones too; none of who does not take part. */
  Map<String, Map<String, GivenAnswer>> given() {
    return history.refused() ? Map.of() : history.given();
  }

  /** The program that ran it. */
  public String software() {
    return events.get(0).text("software");
  }
}
