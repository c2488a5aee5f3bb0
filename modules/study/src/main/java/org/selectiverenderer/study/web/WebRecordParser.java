package org.selectiverenderer.study.web;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.Set;
import java.util.regex.Pattern;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SessionFolder;
import org.selectiverenderer.study.session.SessionStep;

/**
 * Reads a record of the page. A record whose frame is wrong is left out; of one that is right in
 * itself, an answer or a log that is wrong is left out alone. Each is reported.
 */
final class WebRecordParser {
  private static final Instant EARLIEST = Instant.parse("2020-01-01T00:00:00Z");
  private static final Instant LATEST = Instant.parse("2100-01-01T00:00:00Z");
  private static final Duration LONGEST = Duration.ofDays(2);
  private static final int MOST_INTERRUPTIONS = 10_000;
  private static final int MOST_TEXTS = 32;
  private static final int LONGEST_TEXT = 200;
  private static final Pattern CHECKSUM = Pattern.compile("[0-9a-f]{64}");

  private final LoadedStudy material;
  private final RecordFaults faults;
  private final Map<String, SessionStep> steps = new HashMap<>();
  private final WebTrialParser trials;
  private final Map<String, List<Questionnaire>> questionnaires = new HashMap<>();

  /** Something in a record is not as the page writes it. */
  private static final class Fault extends Exception {
    private static final long serialVersionUID = 1;

    Fault(String sentence) {
      super(sentence);
    }
  }

  WebRecordParser(LoadedStudy material, RecordFaults faults) throws IOException {
    this.material = material;
    this.faults = faults;
    trials = new WebTrialParser(material);
    material.steps().forEach(step -> steps.put(step.id(), step));
  }

  /**
   * Reads a record.
   *
   * @param session the session in which it was found
   * @return empty if it is left out, which is then reported
   */
  Optional<WebRecord> parse(String session, JsonNode json, SourceLocation place) {
    try {
      return Optional.of(record(session, json, place));
    } catch (Fault e) {
      faults.tell(place, e.getMessage() + "; the record is left out");
      return Optional.empty();
    }
  }

  private WebRecord record(String session, JsonNode json, SourceLocation place) throws Fault {
    require(json.isObject(), "a record is an object {...}");
    require(session.equals(json.path("session").asText()), "the record is of another session");
    SessionStep step = step(json);
    Instant started = time(json, "started");
    Instant told = time(json, "ended");
    // A clock that was set back meanwhile loses nothing.
    Instant ended = told.isBefore(started) ? started : told;
    require(
        Duration.between(started, told).abs().compareTo(LONGEST) < 0,
        "\"ended\" is not within two days after \"started\"");
    boolean trial = step instanceof SessionStep.OneTrial;
    boolean exposure = trial || step instanceof SessionStep.Exposure;
    // A trial without a picture, of instructions and questions alone, has an empty log.
    boolean logged = exposure && !(trial && json.path("log").path("rows").isEmpty());
    return new WebRecord(
        place,
        kept(json),
        identity(json, session),
        step,
        started,
        ended,
        json.path("origin").canConvertToLong() && json.path("origin").isNumber()
            ? OptionalLong.of(json.path("origin").asLong())
            : OptionalLong.empty(),
        number(json.path("mono"), 0, 1e9),
        interruptions(json.path("interruptions"), place),
        texts(json.path("recruitment")),
        texts(json.path("device")),
        answers(step, json.path("answers"), place),
        json.path("refused").asBoolean() && asksConsent(step),
        exposure && json.path("repeated").asBoolean(),
        json.path("display").asText().equals("webxr"),
        step instanceof SessionStep.Block && json.path("failed").asBoolean(),
        outcome(step, json),
        logged ? log(json.path("log"), place) : Optional.empty());
  }

  private SessionStep step(JsonNode json) throws Fault {
    String id = text(json, "step");
    SessionStep step = steps.get(id);
    if (step != null) {
      return step;
    }
    try {
      return trials
          .trial(json, text(json, "group"))
          .map(SessionStep.OneTrial::new)
          .orElseThrow(() -> new Fault("the study has no step " + RecordFaults.quoted(id)));
    } catch (IllegalArgumentException e) {
      throw new Fault(String.valueOf(e.getMessage()));
    }
  }

  private Optional<WebRecord.TrialOutcome> outcome(SessionStep step, JsonNode json) throws Fault {
    if (!(step instanceof SessionStep.OneTrial trial)) {
      return Optional.empty();
    }
    try {
      return Optional.of(trials.outcome(json, trial.trial()));
    } catch (IllegalArgumentException e) {
      throw new Fault(String.valueOf(e.getMessage()));
    }
  }

  /**
   * Returns the text that is kept. A text of JavaScript may end within a character, half of which
   * no file holds: it must be the same when it is read again.
   */
  private static String kept(JsonNode json) {
    return new String(json.toString().getBytes(StandardCharsets.UTF_8), StandardCharsets.UTF_8);
  }

  private WebRecord.Identity identity(JsonNode json, String session) throws Fault {
    JsonNode slot = json.path("slot");
    int places = material.study().participants();
    require(
        slot.isInt() && slot.asInt() >= 1 && slot.asInt() <= places,
        "\"slot\" is not a place of the study's plan, from 1 to " + places);
    String participant = text(json, "participant");
    require(
        participant.matches(SessionFolder.LABEL) && participant.length() <= 40,
        "\"participant\" is not an id of letters and digits");
    String group = text(json, "group");
    require(
        material.study().design().group(group).isPresent(),
        "the study has no condition " + RecordFaults.quoted(group));
    String language = text(json, "language");
    require(
        material.study().languages().contains(language),
        "the study has no language " + RecordFaults.quoted(language));
    String checksum = text(json, "checksum");
    require(CHECKSUM.matcher(checksum).matches(), "\"checksum\" is not a SHA-256 checksum");
    return new WebRecord.Identity(session, slot.asInt(), participant, group, language, checksum);
  }

  private List<WebRecord.Interruption> interruptions(JsonNode json, SourceLocation place) {
    List<WebRecord.Interruption> all = new ArrayList<>();
    double before = 0;
    for (JsonNode one : json) {
      OptionalDouble t = number(one.path("t"), before, 1e6);
      String event = one.path("event").asText();
      if (t.isEmpty() || !event.matches("[a-z-]{1,40}") || all.size() >= MOST_INTERRUPTIONS) {
        faults.tell(
            place,
            "\"interruptions\" are not as the page writes them; the rest of them is left out");
        break;
      }
      before = t.getAsDouble();
      all.add(new WebRecord.Interruption(before, event));
    }
    return all;
  }

  /** Returns members that are texts, numbers or booleans, as texts; none that is too long. */
  private static Map<String, String> texts(JsonNode json) {
    Map<String, String> all = new LinkedHashMap<>();
    json.properties()
        .forEach(
            member -> {
              String text = member.getValue().asText();
              if (member.getValue().isValueNode()
                  && !member.getValue().isNull()
                  && member.getKey().matches("[0-9A-Za-z_-]{1,40}")
                  && text.length() <= LONGEST_TEXT
                  && all.size() < MOST_TEXTS) {
                all.put(member.getKey(), text.replaceAll("\\p{Cntrl}", " "));
              }
            });
    return all;
  }

  private List<WebRecord.Given> answers(SessionStep step, JsonNode json, SourceLocation place) {
    List<WebRecord.Given> all = new ArrayList<>();
    if (json.isMissingNode()) {
      return all;
    }
    if (!json.isArray() || questionnaires(step).isEmpty() && !json.isEmpty()) {
      faults.tell(place, "\"answers\" are no list, or the step asks nothing; they are left out");
      return all;
    }
    Set<String> known = new HashSet<>();
    for (JsonNode one : json) {
      try {
        WebRecord.Given given = answer(questionnaires(step), one);
        require(
            known.add(given.question().id()),
            given.question().id() + " is answered twice in one record");
        all.add(given);
      } catch (Fault e) {
        faults.tell(place, e.getMessage() + "; the answer is left out");
      }
    }
    return all;
  }

  /** Returns the questionnaires of a step; a trial may ask several. */
  private List<Questionnaire> questionnaires(SessionStep step) {
    if (step instanceof SessionStep.OneTrial trial) {
      return questionnaires.computeIfAbsent(
          "trials of " + trial.trial().block(),
          key ->
              trial.trial().phases().stream()
                  .filter(TrialPhase.Questions.class::isInstance)
                  .map(phase -> ((TrialPhase.Questions) phase).questionnaire())
                  .flatMap(name -> material.inTrials(name).stream())
                  .toList());
    }
    if (!(step instanceof SessionStep.Form || step instanceof SessionStep.Questions)) {
      return List.of();
    }
    // The order of the questions, which differs between participants, does not matter here.
    return questionnaires.computeIfAbsent(
        step.id(), id -> List.of(material.questionnaire(step, "001")));
  }

  /** Returns whether an answer to the questions of a step may refuse consent. */
  private boolean asksConsent(SessionStep step) {
    return step instanceof SessionStep.Form
        || questionnaires(step).stream()
            .flatMap(questionnaire -> questionnaire.questions().stream())
            .anyMatch(question -> question.must().isPresent());
  }

  private WebRecord.Given answer(List<Questionnaire> asked, JsonNode json) throws Fault {
    String id = json.path("question").asText();
    Question question =
        asked.stream()
            .flatMap(questionnaire -> questionnaire.question(id).stream())
            .findFirst()
            .orElseThrow(
                () -> new Fault("the questionnaire has no question " + RecordFaults.quoted(id)));
    List<AnswerField> fields = question.kind().fields(material.wording());
    String value = value(question, fields.get(0), json.path("value"));
    int confidence = 0;
    if (fields.size() > 1) {
      String sure = value(question, fields.get(1), json.path("confidence"));
      require(sure.matches("\\d{1,3}"), id + ": the confidence is not a number");
      confidence = Integer.parseInt(sure);
    }
    OptionalDouble ms = number(json.path("ms"), 0, LONGEST.toMillis());
    OptionalDouble place = number(json.path("place"), 1, 100_000);
    return new WebRecord.Given(
        question,
        new Answer(value, confidence),
        ms.isPresent() ? OptionalLong.of(Math.round(ms.getAsDouble())) : OptionalLong.empty(),
        (int) place.orElse(0));
  }

  private static String value(Question question, AnswerField field, JsonNode json) throws Fault {
    String text = json.isTextual() || json.isNumber() ? json.asText() : "";
    Optional<String> value = text.isEmpty() ? Optional.empty() : field.typed(text);
    return value.orElseThrow(
        () ->
            new Fault(
                "%s: %s is not an answer that may be given (%s)"
                    .formatted(question.id(), RecordFaults.quoted(text), field.allowed())));
  }

  private Optional<WebExposureLog> log(JsonNode json, SourceLocation place) {
    try {
      return Optional.of(WebLogParser.log(json));
    } catch (IllegalArgumentException e) {
      faults.tell(place, e.getMessage() + "; the log of the exposure is left out");
      return Optional.empty();
    }
  }

  /** Returns a number within limits; empty if there is none, or it is outside. */
  static OptionalDouble number(JsonNode json, double least, double most) {
    double value = json.isNumber() ? json.asDouble() : Double.NaN;
    return value >= least && value <= most ? OptionalDouble.of(value) : OptionalDouble.empty();
  }

  private static Instant time(JsonNode json, String key) throws Fault {
    try {
      Instant time = Instant.parse(text(json, key));
      require(
          time.isAfter(EARLIEST) && time.isBefore(LATEST),
          "\"" + key + "\" is not a time of this century; the participant's clock is wrong");
      return time;
    } catch (DateTimeException e) {
      throw new Fault("\"" + key + "\" is not a time such as 2026-01-31T12:00:00.000Z");
    }
  }

  private static String text(JsonNode json, String key) throws Fault {
    require(json.path(key).isTextual(), "\"" + key + "\" is not a text");
    return json.path(key).asText();
  }

  private static void require(boolean holds, String otherwise) throws Fault {
    if (!holds) {
      throw new Fault(otherwise);
    }
  }
}
