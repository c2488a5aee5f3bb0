package org.selectiverenderer.study.dataset;

import java.io.IOException;
import java.nio.file.Path;
import java.time.OffsetDateTime;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.headlog.HeadLog;
import org.selectiverenderer.study.headlog.HeadLogAnalysis;
import org.selectiverenderer.study.questionnaire.TimedAnswer;
import org.selectiverenderer.study.session.SessionFolder;
import org.selectiverenderer.study.session.SessionHistory;

/** A session as recorded by its journal. */
public final class RecordedSession {
  private static final String PRACTICE = "practice";

  private final SessionFolder folder;
  private final List<JournalEvent> events;
  private final List<RecordedRun> runs;
  private final SessionHistory history;

  private RecordedSession(SessionFolder folder, List<JournalEvent> events) {
    this.folder = folder;
    this.events = List.copyOf(events);
    runs = runs(events);
    history = SessionHistory.of(events.stream().map(JournalEvent::members).toList());
  }

  /**
   * Reads a session.
   *
   * @param problems receives each damaged line
   * @return empty if the journal has no events, which is then in {@code problems}
   * @throws IOException if the journal cannot be read
   */
  static Optional<RecordedSession> read(SessionFolder folder, ProblemCollector problems)
      throws IOException {
    List<JournalEvent> events = JournalEvent.read(folder.journal(), problems);
    if (events.isEmpty()) {
      problems.warning(
          SourceLocation.of(folder.journal().toString()),
          "the session has no events; it is left out");
      return Optional.empty();
    }
    return Optional.of(new RecordedSession(folder, events));
  }

  /**
   * Returns the run whose head log a file is.
   *
   * @param headLog the head log's CSV file
   * @param problems receives each damaged line of the session's journal
   * @return empty if the file is not in the folder of a session, or its journal has no such run
   * @throws IOException if the journal cannot be read
   */
  public static Optional<RecordedRun> runOf(Path headLog, ProblemCollector problems)
      throws IOException {
    Optional<SessionFolder> folder = SessionFolder.ofHeadLog(headLog);
    if (folder.isEmpty()) {
      return Optional.empty();
    }
    List<JournalEvent> events = JournalEvent.read(folder.get().journal(), problems);
    return events.isEmpty()
        ? Optional.empty()
        : new RecordedSession(folder.get(), events)
            .runs().stream()
                .filter(run -> run.headLog().getFileName().equals(headLog.getFileName()))
                .findFirst();
  }

  private List<RecordedRun> runs(List<JournalEvent> all) {
    List<RecordedRun> found = new ArrayList<>();
    Map<String, Integer> counted = new HashMap<>();
    List<JournalEvent> own = new ArrayList<>();
    for (JournalEvent line : all) {
      if (line.event().equals("step-began")) {
        add(found, own, counted);
        own = new ArrayList<>();
      }
      own.add(line);
    }
    add(found, own, counted);
    return List.copyOf(found);
  }

  /**
   * Adds the run of a step that shows a scene. Its lines go from the beginning of the step to that
   * of the next one; lines after the end of the step are not its own.
   */
  private void add(
      List<RecordedRun> found, List<JournalEvent> lines, Map<String, Integer> counted) {
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

  /** Returns all events in order. */
  public List<JournalEvent> events() {
    return events;
  }

  /** Returns the runs in which a scene was shown, in order. */
  public List<RecordedRun> runs() {
    return runs;
  }

  /** Returns the time of the first event. */
  public OffsetDateTime began() {
    return events.get(0).time();
  }

  /** Returns the seconds from the first event to the last ({@link JournalEvent#seconds}). */
  public double duration() {
    return events.get(events.size() - 1).seconds();
  }

  /**
   * Returns how long exposures were in view in all runs but those of the practice, in seconds;
   * empty if a head log is missing.
   *
   * @param fade seconds of the picture's fade-out
   * @throws IOException if a head log cannot be read
   */
  OptionalDouble inView(double fade) throws IOException {
    double seconds = 0;
    for (RecordedRun run : runs) {
      if (run.step().equals(PRACTICE)) {
        continue;
      }
      // The tables of runs report the log's faults.
      Optional<HeadLog> log = run.head(new ProblemCollector());
      if (log.isEmpty()) {
        return OptionalDouble.empty();
      }
      seconds += HeadLogAnalysis.of(run.inView(log.get(), fade)).seconds();
    }
    return OptionalDouble.of(seconds);
  }

  /** Returns the condition; empty if none was assigned. */
  public String condition() {
    return events.stream()
        .filter(line -> line.event().equals("assigned"))
        .map(line -> line.text("condition"))
        .findFirst()
        .orElse("");
  }

  /** Returns how the session ended, in the spelling of the {@code sessions} tables. */
  public String outcome() {
    String outcome = "unfinished";
    for (JournalEvent line : events) {
      switch (line.event()) {
        case "session-finished" -> outcome = "finished";
        case "refused" -> outcome = "refused";
        case "aborted" -> outcome = "aborted";
        case "resumed" -> outcome = "unfinished";
        default -> {
          // Other events do not concern the end.
        }
      }
    }
    return outcome;
  }

  /** Returns whether a simulated participant took part, if only in some steps. */
  public boolean simulated() {
    return history.unattended();
  }

  /**
   * Returns the spellings of the quality flags, each once, in the order in which they were raised.
   */
  public List<String> flags() {
    return history.raised().stream().map(SessionFlag::spelling).toList();
  }

  /**
   * Returns the answers by step, personal ones included; none if the participant refused consent.
   */
  Map<String, Map<String, TimedAnswer>> given() {
    return history.refused() ? Map.of() : history.given();
  }

  /**
   * Returns the ids that a recruiting service gave the participant of a session in a browser, by
   * their names; they lead to a person.
   */
  Map<String, String> recruitment() {
    Map<String, String> ids = new LinkedHashMap<>();
    events.stream()
        .filter(line -> line.event().equals("recruitment"))
        .forEach(
            line ->
                line.members()
                    .path("ids")
                    .properties()
                    .forEach(id -> ids.putIfAbsent(id.getKey(), id.getValue().asText())));
    return ids;
  }

  /** Returns the language of the participant's texts; empty if the journal does not say. */
  public String language() {
    return history.language().orElse("");
  }

  /** Returns name and version of the program that ran the session. */
  public String software() {
    return events.get(0).text("software");
  }
}
