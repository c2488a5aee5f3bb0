package org.selectiverenderer.study.session;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.definition.QualityCriteria;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.design.TrialKey;
import org.selectiverenderer.study.design.TrialResult;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.TimedAnswer;

/**
 * The state of a session, derived from the events of its journal. Damaged and truncated lines are
 * ignored; {@link #tellDamage} reports them. Thread-safe: a journal adds events while other threads
 * read.
 */
public final class SessionHistory {
  private static final String FORM = new SessionStep.Form().id();

  private boolean web;
  private final Set<String> finished = new LinkedHashSet<>();
  private final Map<String, Integer> runs = new HashMap<>();
  private final Map<String, Map<String, TimedAnswer>> answers = new LinkedHashMap<>();
  private final Map<String, String> pages = new HashMap<>();
  private final List<String> headLogs = new ArrayList<>();
  private final Set<SessionFlagEvent> flags = new LinkedHashSet<>();
  private final List<String> areaOrder = new ArrayList<>();
  private final List<TrialResult> results = new ArrayList<>();
  private final Map<String, Map<Integer, List<TrialKey>>> orders = new HashMap<>();
  private Optional<String> group = Optional.empty();
  private int place;
  private String checksum = "";
  private String language = "";
  private boolean aborted;
  private boolean over;
  private boolean refused;
  private JournalContent text = JournalContent.of(new byte[0]);

  private SessionHistory() {}

  /** Returns the history of a session that has not begun. */
  static SessionHistory none() {
    return new SessionHistory();
  }

  /** Returns the history of some events. */
  public static SessionHistory of(Iterable<? extends JsonNode> events) {
    SessionHistory history = new SessionHistory();
    events.forEach(history::add);
    return history;
  }

  /**
   * Reads a journal, which another program may be writing.
   *
   * @throws IOException if the file cannot be read
   */
  public static SessionHistory read(Path journal) throws IOException {
    JournalContent text = JournalContent.read(journal);
    SessionHistory history = of(text.events());
    history.text = text;
    return history;
  }

  /** Reports the damaged lines of the journal that was read. */
  void tellDamage(Path journal, ProblemCollector problems) {
    JournalRecovery.tellDamaged(journal, text, problems);
    if (text.tail() > 0) {
      problems.info(
          new SourceLocation(journal.toString(), text.lines() + 1, 1),
          "the last line is cut off, by a crash or because it is being written now; it is"
              + " ignored, and --resume repairs the file");
    }
  }

  /** Adds an event that is on the disk. */
  synchronized void add(JsonNode event) {
    String step = event.path("step").asText();
    switch (event.path("event").asText()) {
      case "session-began" -> {
        options(event);
        checksum = event.path("study_sha256").asText();
        language = event.path("language").asText();
        web = event.path("source").asText().equals("web");
      }
      case "resumed" -> {
        aborted = false;
        options(event);
      }
      case "trial-order" ->
          orders
              .computeIfAbsent(step, key -> new HashMap<>())
              .put(event.path("round").asInt(1), TrialEvents.order(event));
      case "assigned" -> {
        place = event.path("place").asInt();
        group = Optional.of(event.path("condition").asText()).filter(name -> !name.isEmpty());
      }
      case "area-order" -> {
        areaOrder.clear();
        event.path("areas").forEach(area -> areaOrder.add(area.asText()));
      }
      case "step-began" -> {
        runs.merge(step, 1, Integer::sum);
        if (event.has("head_log")) {
          headLogs.add(event.get("head_log").asText());
        }
      }
      case "step-finished" -> {
        finished.add(step);
        TrialEvents.result(event).ifPresent(results::add);
        if (event.path("head_log_incomplete").asBoolean()) {
          raise(SessionFlag.HEAD_LOG_INCOMPLETE, step);
        }
      }
      case "answer" ->
          answers
              .computeIfAbsent(step, key -> new LinkedHashMap<>())
              .compute(event.path("object").asText(), (question, earlier) -> given(event, earlier));
      case "page" -> pages.put(step, event.path("page").asText());
      case "flag" ->
          SessionFlag.of(event.path("flag").asText()).ifPresent(flag -> raise(flag, step));
      case "refused" -> refused = true;
      case "aborted" -> aborted = true;
      case "session-finished" -> over = true;
      default -> {
        // Other events are for people only.
      }
    }
  }

  private static TimedAnswer given(JsonNode event, @Nullable TimedAnswer earlier) {
    TimedAnswer given =
        (earlier == null ? TimedAnswer.NONE : earlier)
            .then(
                new Answer(event.path("value").asText(), event.path("confidence").asInt()),
                event.has("ms") ? OptionalLong.of(event.path("ms").asLong()) : OptionalLong.empty(),
                event.path("place").asInt());
    return event.path("personal").asBoolean() ? given.keptPersonal() : given;
  }

  /** Raises the flags that journals of an older format record as options. */
  private void options(JsonNode event) {
    if (event.path("unattended").asBoolean()) {
      raise(SessionFlag.SIMULATED, "");
    }
    if (event.has("exposure_s")) {
      raise(SessionFlag.SHORTENED, "");
    }
  }

  private void raise(SessionFlag flag, String step) {
    flags.add(new SessionFlagEvent(flag, step));
  }

  /** Returns the flags, each once, in the order in which they were raised. */
  synchronized List<SessionFlagEvent> flags() {
    return List.copyOf(flags);
  }

  /** Returns the flags without their steps. */
  public Set<SessionFlag> raised() {
    Set<SessionFlag> raised = new LinkedHashSet<>();
    flags().forEach(flag -> raised.add(flag.flag()));
    return raised;
  }

  /** Returns the flags by which a study excludes the session. */
  List<SessionFlagEvent> excluding(QualityCriteria quality) {
    return refused()
        ? List.of()
        : flags().stream().filter(raised -> quality.exclude().contains(raised.flag())).toList();
  }

  /** Returns whether a flag was raised in any step. */
  boolean flagged(SessionFlag flag) {
    return flags().stream().anyMatch(raised -> raised.flag() == flag);
  }

  /** Returns whether a step is finished. */
  public synchronized boolean finished(SessionStep step) {
    return finished.contains(step.id());
  }

  /** Returns how often a step was begun. */
  public synchronized int runs(SessionStep step) {
    return runs.getOrDefault(step.id(), 0);
  }

  /** Returns the answers of a step so far, by the questions' ids. */
  public Map<String, Answer> answers(SessionStep step) {
    Map<String, Answer> last = new HashMap<>();
    given(step).forEach((question, given) -> last.put(question, given.answer()));
    return Map.copyOf(last);
  }

  /** Returns the answers of a step so far with their response times, by the questions' ids. */
  public synchronized Map<String, TimedAnswer> given(SessionStep step) {
    return Map.copyOf(answers.getOrDefault(step.id(), Map.of()));
  }

  /**
   * Returns the answers of all steps with their response times, by the steps' ids, in the order of
   * the first answers.
   */
  public synchronized Map<String, Map<String, TimedAnswer>> given() {
    Map<String, Map<String, TimedAnswer>> all = new LinkedHashMap<>();
    answers.forEach((step, given) -> all.put(step, Map.copyOf(given)));
    return all;
  }

  /** Returns the answers of the step with an id, by the questions' ids. */
  synchronized Map<String, TimedAnswer> given(String step) {
    return Map.copyOf(answers.getOrDefault(step, Map.of()));
  }

  /** Returns the id of the page of a step that was shown last. */
  public synchronized Optional<String> page(SessionStep step) {
    return Optional.ofNullable(pages.get(step.id()));
  }

  /** Returns the ids of the steps with answers, other than the form. */
  synchronized Set<String> answeredSteps() {
    Set<String> steps = new LinkedHashSet<>(answers.keySet());
    steps.remove(FORM); // The form is not a part of the collected data.
    return Set.copyOf(steps);
  }

  /** Returns the number of answered questions, without those of the form. */
  synchronized int answerCount() {
    return answers.entrySet().stream()
        .filter(step -> !step.getKey().equals(FORM))
        .mapToInt(step -> step.getValue().size())
        .sum();
  }

  /** Returns the names of all head logs that were begun. */
  public synchronized List<String> headLogs() {
    return List.copyOf(headLogs);
  }

  /** Returns the names of the areas in the participant's order, once it is known. */
  synchronized List<String> areaOrder() {
    return List.copyOf(areaOrder);
  }

  /** Returns the name of the participant's group, once it is assigned. */
  public synchronized Optional<String> group() {
    return group;
  }

  /** Returns the participant's place in the schedule, from 1; 0 before the assignment. */
  synchronized int place() {
    return place;
  }

  /** Returns the results of all finished trials, in order. */
  public synchronized List<TrialResult> results() {
    return List.copyOf(results);
  }

  /** Returns the recorded orders of a block's trials, by round. */
  synchronized Map<Integer, List<TrialKey>> orders(String block) {
    return Map.copyOf(orders.getOrDefault(block, Map.of()));
  }

  /** Returns the SHA-256 checksum of the study file at the session's begin. */
  synchronized String checksum() {
    return checksum;
  }

  /** Returns the language in which the session was begun; empty if its journal does not say. */
  public synchronized Optional<String> language() {
    return Optional.of(language).filter(code -> !code.isEmpty());
  }

  /** Returns whether a simulated participant took part, if only in some steps. */
  public boolean unattended() {
    return flagged(SessionFlag.SIMULATED);
  }

  /** Returns whether exposures were shortened for a test. */
  public boolean shortened() {
    return flagged(SessionFlag.SHORTENED);
  }

  /** Returns whether the experimenter aborted the session, which may be resumed. */
  public synchronized boolean aborted() {
    return aborted;
  }

  /** Returns whether the participant refused consent. */
  public synchronized boolean refused() {
    return refused;
  }

  /** Returns whether the session ran in a participant's web browser. */
  synchronized boolean ofWeb() {
    return web;
  }

  /** Returns whether the session is complete. */
  public synchronized boolean over() {
    return over;
  }
}
