package org.selectiverenderer.experiment.session;

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
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.control.Condition;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.GivenAnswer;
import org.selectiverenderer.experiment.study.SessionFlag;
import org.selectiverenderer.experiment.study.StudyQuality;

/**
 * What a session's journal says has happened. Lines that are damaged or that a crash cut off are no
 * events; {@link #tellDamage} says them. May be asked by any thread while a journal adds to it.
 */
public final class SessionHistory {
  private static final String FORM = new SessionStep.Form().id();

  private final Set<String> finished = new LinkedHashSet<>();
  private final Map<String, Integer> runs = new HashMap<>();
  private final Map<String, Map<String, GivenAnswer>> answers = new LinkedHashMap<>();
  private final Map<String, String> pages = new HashMap<>();
  private final List<String> headLogs = new ArrayList<>();
  private final Set<RaisedFlag> flags = new LinkedHashSet<>();
  private final List<String> areaOrder = new ArrayList<>();
  private Optional<Condition> condition = Optional.empty();
  private String checksum = "";
  private boolean aborted;
  private boolean over;
  private boolean refused;
  private JournalText text = JournalText.of(new byte[0]);

  private SessionHistory() {}

  /** Of a session that has not begun. */
  static SessionHistory none() {
    return new SessionHistory();
  }

  /** Of a journal's events. */
  public static SessionHistory of(Iterable<? extends JsonNode> events) {
    SessionHistory history = new SessionHistory();
    events.forEach(history::add);
    return history;
  }

  /**
   * Reads a journal; harmless while a program writes it.
   *
   * @throws IOException if it cannot be read
   */
  public static SessionHistory read(Path journal) throws IOException {
    JournalText text = JournalText.read(journal);
    SessionHistory history = of(text.events());
    history.text = text;
    return history;
  }

  /** Says which lines of the journal that was read are no events. */
  void tellDamage(Path journal, Problems problems) {
    JournalMending.tellDamaged(journal, text, problems);
    if (text.tail() > 0) {
      problems.info(
          new Location(journal.toString(), text.lines() + 1, 1),
          "the last line is cut off, by a crash or because it is being written now; it is no"
              + " event, and --resume mends the file");
    }
  }

  /** An event is on the disk. */
  synchronized void add(JsonNode event) {
    String step = event.path("step").asText();
    switch (event.path("event").asText()) {
      case "session-began" -> {
        options(event);
        checksum = event.path("study_sha256").asText();
      }
      case "resumed" -> {
        aborted = false;
        options(event);
      }
      case "assigned" -> condition = Condition.of(event.path("condition").asText());
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
        // The rest is for people to read.
      }
    }
  }

  private static GivenAnswer given(JsonNode event, @Nullable GivenAnswer earlier) {
    GivenAnswer given =
        (earlier == null ? GivenAnswer.NONE : earlier)
            .then(
                new Answer(event.path("value").asText(), event.path("confidence").asInt()),
                event.has("ms") ? OptionalLong.of(event.path("ms").asLong()) : OptionalLong.empty(),
                event.path("place").asInt());
    return event.path("personal").asBoolean() ? given.keptPersonal() : given;
  }

  /** Journals of before there were flags say these in their own way. */
  private void options(JsonNode event) {
    if (event.path("unattended").asBoolean()) {
      raise(SessionFlag.SIMULATED, "");
    }
    if (event.has("exposure_s")) {
      raise(SessionFlag.SHORTENED, "");
    }
  }

  private void raise(SessionFlag flag, String step) {
    flags.add(new RaisedFlag(flag, step));
  }

  /** What sets the session apart, each once, in the order in which it was told. */
  synchronized List<RaisedFlag> flags() {
    return List.copyOf(flags);
  }

  /** The same without the steps. */
  public Set<SessionFlag> raised() {
    Set<SessionFlag> raised = new LinkedHashSet<>();
    flags().forEach(flag -> raised.add(flag.flag()));
    return raised;
  }

  /** Those of its flags by which a study leaves the session out. */
  List<RaisedFlag> excluding(StudyQuality quality) {
    return refused()
        ? List.of()
        : flags().stream().filter(raised -> quality.exclude().contains(raised.flag())).toList();
  }

  /** Whether a flag was raised, of whatever step. */
  boolean flagged(SessionFlag flag) {
    return flags().stream().anyMatch(raised -> raised.flag() == flag);
  }

  /** Whether a step is done. */
  public synchronized boolean finished(SessionStep step) {
    return finished.contains(step.id());
  }

  /** How often a step was begun. */
  public synchronized int runs(SessionStep step) {
    return runs.getOrDefault(step.id(), 0);
  }

  /** The answers of a step so far, by the questions' ids. */
  public Map<String, Answer> answers(SessionStep step) {
    Map<String, Answer> last = new HashMap<>();
    given(step).forEach((question, given) -> last.put(question, given.answer()));
    return Map.copyOf(last);
  }

  /** The same, and how they came about. */
  public synchronized Map<String, GivenAnswer> given(SessionStep step) {
    return Map.copyOf(answers.getOrDefault(step.id(), Map.of()));
  }

  /**
   * Those of all steps, by the steps' ids, in the order in which they were begun to be answered.
   */
  public synchronized Map<String, Map<String, GivenAnswer>> given() {
    Map<String, Map<String, GivenAnswer>> all = new LinkedHashMap<>();
    answers.forEach((step, given) -> all.put(step, Map.copyOf(given)));
    return all;
  }

  /** The page of a step that was shown last. */
  public synchronized Optional<String> page(SessionStep step) {
    return Optional.ofNullable(pages.get(step.id()));
  }

  /** Steps with answers but for the form, by their ids. */
  synchronized Set<String> answeredSteps() {
    Set<String> steps = new LinkedHashSet<>(answers.keySet());
    steps.remove(FORM); // Whoever filled it in has answered nothing of what is studied yet.
    return Set.copyOf(steps);
  }

  /** Answers in all to questionnaires, each question's last. */
  synchronized int answerCount() {
    return answers.entrySet().stream()
        .filter(step -> !step.getKey().equals(FORM))
        .mapToInt(step -> step.getValue().size())
        .sum();
  }

  /** Names of all head logs that were begun. */
  public synchronized List<String> headLogs() {
    return List.copyOf(headLogs);
  }

  /** Names of the areas in the participant's order, once it is known. */
  synchronized List<String> areaOrder() {
    return List.copyOf(areaOrder);
  }

  /** The participant's condition, once it is assigned. */
  public synchronized Optional<Condition> condition() {
    return condition;
  }

  /** SHA-256 of the study file with which it began. */
  synchronized String checksum() {
    return checksum;
  }

  /** Whether a simulated participant took part, if only for a while. */
  public boolean unattended() {
    return flagged(SessionFlag.SIMULATED);
  }

  /** Whether exposures were shortened for a test. */
  public boolean shortened() {
    return flagged(SessionFlag.SHORTENED);
  }

  /** Whether the experimenter stopped it; it may be resumed. */
  public synchronized boolean aborted() {
    return aborted;
  }

  /** Whether the participant did not consent. */
  public synchronized boolean refused() {
    return refused;
  }

  /** Whether it is complete. */
  public synchronized boolean over() {
    return over;
  }
}
