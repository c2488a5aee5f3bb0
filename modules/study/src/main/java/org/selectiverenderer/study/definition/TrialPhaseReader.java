package org.selectiverenderer.study.definition;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.LocatedJsonValue;
import org.selectiverenderer.study.definition.StudyQuestionnairesReader.FileOfKey;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialPhase.ResponseKeys;
import org.selectiverenderer.study.questionnaire.AudioFileName;
import org.selectiverenderer.study.questionnaire.QuestionKind;

/** Reads the phases of a block's trials. */
final class TrialPhaseReader {
  private static final List<String> KINDS =
      List.of("instruction", "fixation", "exposure", "blank", "questions", "feedback", "repeat");
  private static final Pattern COLUMN = Pattern.compile("\\{([^{}]*)\\}");
  private static final String KEY = "[0-9a-z]|space|enter|left|right|up|down";
  private static final int MOST_ROUNDS = 10_000;

  private final FileOfKey files;
  private final QuestionKind.Texts texts;

  TrialPhaseReader(FileOfKey files, QuestionKind.Texts texts) {
    this.files = files;
    this.texts = texts;
  }

  /**
   * Reads the phases of a block.
   *
   * @param columns the factors, and the columns of the stimuli, that texts may name in braces
   */
  List<TrialPhase> read(JsonObjectReader block, List<String> columns) {
    return phases(block, "trial", columns);
  }

  private List<TrialPhase> phases(JsonObjectReader keys, String key, List<String> columns) {
    return keys.objects(key, "a phase", each -> phase(each, columns)).stream()
        .flatMap(Optional::stream)
        .toList();
  }

  private Optional<TrialPhase> phase(JsonObjectReader keys, List<String> columns) {
    String kind = keys.text("show");
    return switch (kind) {
      case "instruction" ->
          Optional.of(new TrialPhase.Instruction(text(keys, "text", columns), audio(keys)));
      case "fixation" -> Optional.of(new TrialPhase.Fixation(seconds(keys, 0.5)));
      case "exposure" -> Optional.of(exposure(keys, columns));
      case "blank" -> Optional.of(blank(keys, columns));
      case "questions" -> Optional.of(new TrialPhase.Questions(keys.text("questionnaire")));
      case "feedback" ->
          Optional.of(
              new TrialPhase.Feedback(
                  text(keys, "correct", columns),
                  text(keys, "wrong", columns),
                  checked(keys, "missing", texts.optional(keys, "missing"), columns),
                  seconds(keys, 1)));
      case "repeat" -> Optional.of(repeat(keys, columns));
      default -> {
        if (!kind.isEmpty()) {
          keys.fault(
              "show",
              "there is no phase '%s'%s"
                  .formatted(
                      kind,
                      SpellingSuggester.nearest(kind, KINDS)
                          .map(near -> "; did you mean '%s'?".formatted(near))
                          .orElse(" (known: %s)".formatted(String.join(", ", KINDS)))));
        }
        keys.names(); // Marks all keys as read: those of an unknown phase cannot be checked.
        yield Optional.empty();
      }
    };
  }

  private Optional<Path> audio(JsonObjectReader keys) {
    String name = texts.optional(keys, "audio");
    if (name.isEmpty()) {
      return Optional.empty();
    }
    if (!AudioFileName.known(name)) {
      keys.fault("audio", AudioFileName.NEEDED);
      return Optional.empty();
    }
    return Optional.of(files.find(keys, "audio", name));
  }

  private static double seconds(JsonObjectReader keys, double usual) {
    return keys.number("seconds", 0, TrialPhase.LONGEST, usual);
  }

  private TrialPhase exposure(JsonObjectReader keys, List<String> columns) {
    Map<String, String> choices = new LinkedHashMap<>();
    keys.object(
        "choices",
        "the choices of Switches",
        each -> {
          for (String name : each.names()) {
            Optional<LocatedJsonValue> value = each.value(name);
            String choice = value.flatMap(LocatedJsonValue::text).orElseGet(() -> number(value));
            if (!choice.matches("-1|\\d{1,6}") && !COLUMN.matcher(choice).matches()) {
              each.fault(name, "a choice is a whole number, -1 for none, or a {column} of numbers");
            }
            choices.put(checked(each, name, name, columns), checked(each, name, choice, columns));
          }
          return choices;
        });
    boolean sceneEnds =
        keys.choice("until", List.of(true, false), scene -> scene ? "scene" : "time", false);
    return new TrialPhase.Exposure(
        TrialSettingsReader.number(keys, "seconds", 0.001, TrialPhase.LONGEST),
        choices,
        response(keys, columns),
        sceneEnds);
  }

  private static String number(Optional<LocatedJsonValue> value) {
    double number = value.map(LocatedJsonValue::number).orElse(Double.NaN);
    return number == Math.rint(number) ? Long.toString((long) number) : "";
  }

  private TrialPhase blank(JsonObjectReader keys, List<String> columns) {
    OptionalDouble seconds = TrialSettingsReader.number(keys, "seconds", 0.001, TrialPhase.LONGEST);
    ResponseKeys response = response(keys, columns);
    if (seconds.isEmpty() && response.keys().isEmpty()) {
      keys.fault("a blank needs \"seconds\", or \"keys\" that end it");
    }
    return new TrialPhase.Blank(seconds, response);
  }

  private ResponseKeys response(JsonObjectReader keys, List<String> columns) {
    List<String> pressed = new ArrayList<>();
    for (LocatedJsonValue value : keys.list("keys", false)) {
      String key = value.toString();
      if (!key.matches(KEY)) {
        keys.fault(
            value,
            "'%s' is no key; known are letters in lower case, digits, space, enter, left, right, up and down"
                .formatted(key));
      } else {
        pressed.add(key);
      }
    }
    Optional<String> correct = keys.text("correct", false);
    if (correct.isPresent() && pressed.isEmpty()) {
      keys.fault("correct", "\"correct\" needs the \"keys\" of which it is one");
    } else if (correct.isPresent()
        && !pressed.contains(correct.get())
        && correct.get().indexOf('{') < 0) {
      keys.fault("correct", "'" + correct.get() + "' is none of the \"keys\"");
    }
    return new ResponseKeys(
        pressed, correct.map(text -> checked(keys, "correct", text, columns)).orElse(""));
  }

  private TrialPhase repeat(JsonObjectReader keys, List<String> columns) {
    List<TrialPhase> phases = phases(keys, "phases", columns);
    if (phases.stream().noneMatch(TrialPhaseReader::responds)) {
      keys.fault("phases", "none of the phases has \"keys\" that would end the repetition");
    }
    if (phases.stream()
        .anyMatch(
            phase -> phase instanceof TrialPhase.Repeat || phase instanceof TrialPhase.Questions)) {
      keys.fault("phases", "a repetition consists of other phases than questions and repetitions");
    }
    return new TrialPhase.Repeat(phases, (int) keys.whole("most", 1, MOST_ROUNDS, 100));
  }

  private static boolean responds(TrialPhase phase) {
    return phase instanceof TrialPhase.Exposure exposure && !exposure.response().keys().isEmpty()
        || phase instanceof TrialPhase.Blank blank && !blank.response().keys().isEmpty();
  }

  private String text(JsonObjectReader keys, String key, List<String> columns) {
    return checked(keys, key, texts.text(keys, key), columns);
  }

  /** Reports names in braces that are neither factors nor columns. */
  private static String checked(
      JsonObjectReader keys, String key, String text, List<String> columns) {
    Matcher named = COLUMN.matcher(text);
    while (named.find()) {
      if (!columns.contains(named.group(1))) {
        keys.fault(
            key,
            "{%s} is neither a factor nor a column of the block's stimuli%s"
                .formatted(
                    named.group(1),
                    SpellingSuggester.nearest(named.group(1), columns)
                        .map(near -> "; did you mean {%s}?".formatted(near))
                        .orElse("")));
      }
    }
    return text;
  }
}
