package org.selectiverenderer.study.definition;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.QualityRule;
import org.selectiverenderer.schema.SwitchTransition;
import org.selectiverenderer.study.definition.StudyQuestionnairesReader.FileOfKey;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialSettings;

/** Reads the keys of a level or a block that determine what its trials show. */
final class TrialSettingsReader {
  /** The highest number of a Switch's child that a choice may name; a higher one is a mistake. */
  private static final int MOST_CHOICE = 999_999;

  /** The modes with windows, which a trial may change. */
  private static final List<DisplayMode> WINDOWS =
      List.of(DisplayMode.values()).stream().filter(mode -> mode != DisplayMode.OPENXR).toList();

  private final FileOfKey files;
  private final ProblemCollector problems;

  /**
   * @param files resolves the names of files
   * @param problems receives the faults of tables of choices
   */
  TrialSettingsReader(FileOfKey files, ProblemCollector problems) {
    this.files = files;
    this.problems = problems;
  }

  /** Reads the settings among the keys of an object. */
  TrialSettings read(JsonObjectReader keys) {
    Map<String, Integer> choices = new LinkedHashMap<>(table(keys));
    choices.putAll(choices(keys));
    Optional<Display> display =
        keys.object(
            "display",
            "the display of a trial",
            each ->
                new Display(
                    each.has("mode")
                        ? Optional.of(
                            each.choice(
                                "mode",
                                WINDOWS,
                                mode -> mode.name().toLowerCase(Locale.ROOT).replace('_', '-'),
                                DisplayMode.WINDOW))
                        : Optional.empty(),
                    number(each, "ipd", 0, EyeGeometry.LARGEST_IPD)));
    return new TrialSettings(
        condition(keys),
        choices,
        keys.text("scene", false).map(name -> files.find(keys, "scene", name)),
        keys.text("area", false),
        keys.text("viewpoint", false),
        number(keys, "seconds", 0.001, TrialPhase.LONGEST),
        keys.has("light")
            ? Optional.of(keys.choice("light", List.of(true, false), on -> on ? "on" : "off", true))
            : Optional.empty(),
        display.flatMap(Display::mode),
        display.map(Display::ipd).orElse(OptionalDouble.empty()),
        transition(keys),
        qualities(keys));
  }

  /** Reads what decides the levels of qualities; the condition decides those that are missing. */
  static Map<Quality, QualityRule> qualities(JsonObjectReader keys) {
    Map<Quality, QualityRule> rules = new EnumMap<>(Quality.class);
    keys.object(
        "qualities",
        "the qualities",
        each -> {
          for (Quality quality : Quality.values()) {
            if (each.has(quality.spelling())) {
              rules.put(
                  quality,
                  each.choice(
                      quality.spelling(),
                      List.of(QualityRule.values()),
                      QualityRule::spelling,
                      QualityRule.SELECTIVE));
            }
          }
          return rules;
        });
    return rules;
  }

  /** Reads how objects change their versions, which may be missing. */
  static Optional<SwitchTransition> transition(JsonObjectReader keys) {
    Optional<String> text = keys.text("switch", false);
    Optional<SwitchTransition> known = text.flatMap(SwitchTransition::of);
    if (text.isPresent() && known.isEmpty()) {
      keys.fault(
          "switch",
          "'%s' is no way to change a version; choose at-once, fade:MS or unseen[:DEG_PER_S]"
              .formatted(text.get()));
    }
    return known;
  }

  private record Display(Optional<DisplayMode> mode, OptionalDouble ipd) {}

  /** Reads a number that may be missing. */
  static OptionalDouble number(JsonObjectReader keys, String key, double least, double most) {
    return keys.has(key)
        ? OptionalDouble.of(keys.number(key, least, most, least))
        : OptionalDouble.empty();
  }

  private static Optional<Condition> condition(JsonObjectReader keys) {
    return keys.has("condition")
        ? Optional.of(
            keys.choice(
                "condition", List.of(Condition.values()), Condition::spelling, Condition.SELECTIVE))
        : Optional.empty();
  }

  private static Map<String, Integer> choices(JsonObjectReader keys) {
    Map<String, Integer> choices = new LinkedHashMap<>();
    keys.object(
        "choices",
        "the choices of Switches",
        each -> {
          for (String name : each.names()) {
            choices.put(name, (int) each.whole(name, -1, MOST_CHOICE, Double.NaN));
          }
          return choices;
        });
    return choices;
  }

  /** Reads a table of choices: a column {@code switch}, and one for each manipulation. */
  private Map<String, Integer> table(JsonObjectReader keys) {
    Map<String, Integer> choices = new LinkedHashMap<>();
    keys.object(
        "table",
        "a table of choices",
        each -> {
          Path file = files.find(each, "file", each.text("file"));
          String column = each.text("column");
          if (each.has("file") && !column.isEmpty()) {
            choices.putAll(read(file, column));
          }
          return choices;
        });
    return choices;
  }

  private Map<String, Integer> read(Path file, String column) {
    Map<String, Integer> choices = new LinkedHashMap<>();
    try {
      Optional<CsvTable> table =
          CsvTable.parse(file.toString(), CsvTable.bytes(file), problems::error);
      List<String> columns = List.of("switch", column);
      if (table.isEmpty() || !table.get().require(columns, String.join(",", columns))) {
        return choices;
      }
      for (CsvRow row : table.get().rows()) {
        String choice = row.cell(column);
        if (choice.matches("-1|\\d{1,6}")) {
          choices.put(row.cell("switch"), Integer.parseInt(choice));
        } else if (!choice.isEmpty()) {
          problems.error(
              row.location(column),
              "'%s' is no choice of a Switch: a whole number, or -1 for none".formatted(choice));
        }
      }
    } catch (java.nio.file.NoSuchFileException e) {
      return choices; // The reader of the key has told that the file is missing.
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return choices;
  }
}
