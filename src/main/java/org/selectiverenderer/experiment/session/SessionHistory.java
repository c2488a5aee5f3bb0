package org.selectiverenderer.experiment.session;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
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
import org.selectiverenderer.base.json.JsonTree;
import org.selectiverenderer.control.Condition;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.GivenAnswer;

/**
 * What a session's journal says has happened. Lines that a crash cut off are no events and are
 * passed over.
 */
final class SessionHistory {
  private static final String FORM = new SessionStep.Form().id();

  private final Set<String> finished = new LinkedHashSet<>();
  private final Map<String, Integer> runs = new HashMap<>();
  private final Map<String, Map<String, GivenAnswer>> answers = new LinkedHashMap<>();
  private final Map<String, String> pages = new HashMap<>();
  private final List<String> headLogs = new ArrayList<>();
  private final Set<String> brokenLogs = new LinkedHashSet<>();
  private Optional<Condition> condition = Optional.empty();
  private String checksum = "";
  private boolean unattended;
  private boolean shortened;
  private boolean aborted;
  private boolean over;
  private boolean refused;

  private SessionHistory() {}

  /** Of a session that has not begun. */
  static SessionHistory none() {
    return new SessionHistory();
  }

  /**
   * Reads a journal.
   *
   * @throws IOException if it cannot be read
   */
  public static SessionHistory read(Path journal) throws IOException {
    SessionHistory history = new SessionHistory();
    String text = new String(Files.readAllBytes(journal), StandardCharsets.UTF_8);
    for (String line : text.split("\n")) {
      JsonNode event = whole(line);
      if (event != null && event.isObject()) {
        history.add(event);
      }
    }
    return history;
  }

  private static @Nullable JsonNode whole(String line) {
    try {
      return JsonTree.parse(line);
    } catch (JsonProcessingException e) {
      return null; // Cut off by a crash: it was never said.
    }
  }

  private void add(JsonNode event) {
    String step = event.path("step").asText();
    switch (event.path("event").asText()) {
      case "session-began" -> {
        unattended = event.path("unattended").asBoolean();
        shortened = event.has("exposure_s");
        checksum = event.path("study_sha256").asText();
      }
      case "resumed" -> {
        aborted = false;
        unattended |= event.path("unattended").asBoolean();
        shortened |= event.has("exposure_s");
      }
      case "assigned" -> condition = Condition.of(event.path("condition").asText());
      case "step-began" -> {
        runs.merge(step, 1, Integer::sum);
        if (event.has("head_log")) {
          headLogs.add(event.get("head_log").asText());
        }
      }
      case "step-finished" -> {
        finished.add(step);
        if (event.path("head_log_incomplete").asBoolean()) {
          brokenLogs.add(step);
        }
      }
      case "answer" ->
          answers
              .computeIfAbsent(step, key -> new LinkedHashMap<>())
              .compute(event.path("object").asText(), (question, earlier) -> given(event, earlier));
      case "page" -> pages.put(step, event.path("page").asText());
      case "refused" -> refused = true;
      case "aborted" -> aborted = true;
      case "session-finished" -> over = true;
      default -> {
        // The rest is for people to read.
      }
    }
  }

  private static GivenAnswer given(JsonNode event, @Nullable GivenAnswer earlier) {
    return (earlier == null ? GivenAnswer.NONE : earlier)
        .then(
            new Answer(event.path("value").asText(), event.path("confidence").asInt()),
            event.has("ms") ? OptionalLong.of(event.path("ms").asLong()) : OptionalLong.empty(),
            event.path("place").asInt());
  }

  /** Whether a step is done. */
  public boolean finished(SessionStep step) {
    return finished.contains(step.id());
  }

  /** How often a step was begun. */
  public int runs(SessionStep step) {
    return runs.getOrDefault(step.id(), 0);
  }

  /** The answers of a step so far, by the questions' ids. */
  public Map<String, Answer> answers(SessionStep step) {
    Map<String, Answer> last = new HashMap<>();
    given(step).forEach((question, given) -> last.put(question, given.answer()));
    return Map.copyOf(last);
  }

  /** The same, and how they came about. */
  public Map<String, GivenAnswer> given(SessionStep step) {
    return Map.copyOf(answers.getOrDefault(step.id(), Map.of()));
  }

  /** The page of a step that was shown last. */
  public Optional<String> page(SessionStep step) {
    return Optional.ofNullable(pages.get(step.id()));
  }

  /** Steps with answers but for the form, by their ids. */
  Set<String> answeredSteps() {
    Set<String> steps = new LinkedHashSet<>(answers.keySet());
    steps.remove(FORM); // Whoever filled it in has answered nothing of what is studied yet.
    return Set.copyOf(steps);
  }

  /** Answers in all to questionnaires, each question's last. */
  int answerCount() {
    return answers.entrySet().stream()
        .filter(step -> !step.getKey().equals(FORM))
        .mapToInt(step -> step.getValue().size())
        .sum();
  }

  /** Names of all head logs that were begun. */
  public List<String> headLogs() {
    return List.copyOf(headLogs);
  }

  /** Steps that were shown to their end with a head log that a full or slow disk cut short. */
  Set<String> brokenLogs() {
    return brokenLogs;
  }

  /** The participant's condition, once it is assigned. */
  public Optional<Condition> condition() {
    return condition;
  }

  /** SHA-256 of the study file with which it began. */
  String checksum() {
    return checksum;
  }

  /** Whether a simulated participant took part, if only for a while. */
  public boolean unattended() {
    return unattended;
  }

  /** Whether exposures were shortened for a test. */
  public boolean shortened() {
    return shortened;
  }

  /** Whether the experimenter stopped it; it may be resumed. */
  public boolean aborted() {
    return aborted;
  }

  /** Whether the participant did not consent. */
  public boolean refused() {
    return refused;
  }

  /** Whether it is complete. */
  public boolean over() {
    return over;
  }
}
