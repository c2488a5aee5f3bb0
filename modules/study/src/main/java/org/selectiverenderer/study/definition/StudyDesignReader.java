package org.selectiverenderer.study.definition;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.LocatedJsonValue;
import org.selectiverenderer.study.definition.StudyQuestionnairesReader.FileOfKey;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.StimulusList;
import org.selectiverenderer.study.design.StimulusListReader;
import org.selectiverenderer.study.design.StudyDesign;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialBlock.PracticeCriterion;
import org.selectiverenderer.study.design.TrialBlock.TrialStaircase;
import org.selectiverenderer.study.design.TrialColumns;
import org.selectiverenderer.study.design.TrialSequencer;
import org.selectiverenderer.study.questionnaire.QuestionKind;

/** Reads the keys {@code factors}, {@code blocks} and {@code analysis} of a study. */
final class StudyDesignReader {
  private static final String FACTOR = "[A-Za-z][0-9A-Za-z_]*";
  private static final String LEVEL = "[0-9A-Za-z][0-9A-Za-z_.-]*";
  private static final String BLOCK = "[0-9A-Za-z]+";

  private static final int MOST_GROUPS = 1000;

  /** More trials take no participant through a session. */
  private static final int MOST_TRIALS = 20_000;

  private final FileOfKey files;
  private final TrialSettingsReader settings;
  private final TrialPhaseReader phases;
  private final ProblemCollector problems;

  /**
   * @param files resolves the names of files
   * @param texts reads texts in the participant's language
   * @param problems receives the faults of stimulus lists and tables of choices
   */
  StudyDesignReader(FileOfKey files, QuestionKind.Texts texts, ProblemCollector problems) {
    this.files = files;
    this.problems = problems;
    settings = new TrialSettingsReader(files, problems);
    phases = new TrialPhaseReader(files, texts);
  }

  /**
   * Reads the design.
   *
   * @param conditions the groups of a study that has conditions instead of factors
   */
  StudyDesign read(JsonObjectReader keys, List<StudyGroup> conditions) {
    Set<String> names = new HashSet<>();
    List<Factor> named = keys.objects("factors", "a factor", each -> factor(each, names));
    if (keys.has("factors") && keys.has("conditions")) {
      keys.fault(
          "conditions",
          "a study has \"conditions\" or \"factors\"; make the conditions the levels of a factor");
    }
    long products =
        named.stream()
            .filter(factor -> factor.scope() == Factor.Scope.BETWEEN)
            .mapToLong(factor -> factor.levels().size())
            .reduce(1, (a, b) -> Math.min(MOST_GROUPS + 1L, a * b));
    if (products > MOST_GROUPS) {
      keys.fault(
          "factors",
          "the levels between participants make more than %d groups".formatted(MOST_GROUPS));
    }
    List<Factor> factors = products > MOST_GROUPS ? List.of() : named;
    List<StudyGroup> groups = keys.has("factors") ? StudyGroup.of(factors) : conditions;
    Set<String> blocks = new HashSet<>();
    StudyDesign design =
        new StudyDesign(
            factors,
            groups.isEmpty() ? StudyGroup.of(List.of()) : groups,
            keys.objects("blocks", "a block", each -> block(each, factors, blocks)));
    return design.with(new PlannedAnalysesReader(design).read(keys));
  }

  private Factor factor(JsonObjectReader keys, Set<String> names) {
    String name = keys.text("name");
    if (!name.isEmpty() && !name.matches(FACTOR)) {
      keys.fault(
          "name",
          "a factor's name must consist of letters, digits and underscores, and begin with a"
              + " letter, as it is a column of tables");
    } else if (TrialColumns.reserved(name)) {
      keys.fault(
          "name",
          "the factor %s cannot be told from a column of the table of trials; give it another name"
              .formatted(name));
    } else if (!names.add(name.toLowerCase(Locale.ROOT))) {
      keys.fault("name", "the factor " + name + " is defined twice");
    }
    if (!keys.has("varies")) {
      keys.fault("a factor needs \"varies\": \"within\" or \"between\" participants");
    }
    Factor.Scope scope =
        keys.choice(
            "varies", List.of(Factor.Scope.values()), Factor.Scope::spelling, Factor.Scope.WITHIN);
    Set<String> levels = new HashSet<>();
    List<Factor.Level> read = keys.objects("levels", "a level", each -> level(each, levels));
    if (read.size() < 2) {
      keys.fault("levels", "a factor needs at least two \"levels\"");
    }
    return new Factor(name, scope, read);
  }

  private Factor.Level level(JsonObjectReader keys, Set<String> names) {
    String name = keys.text("name");
    if (!name.isEmpty() && !name.matches(LEVEL)) {
      keys.fault(
          "name", "a level's name must consist of letters, digits, dots, hyphens and underscores");
    } else if (!names.add(name.toLowerCase(Locale.ROOT))) {
      keys.fault("name", "the level " + name + " is defined twice");
    }
    return new Factor.Level(name, settings.read(keys));
  }

  private TrialBlock block(JsonObjectReader keys, List<Factor> factors, Set<String> names) {
    String name = keys.text("name");
    if (!name.isEmpty() && !name.matches(BLOCK)) {
      keys.fault("name", "a block's name must consist of letters and digits");
    } else if (!names.add(name.toLowerCase(Locale.ROOT))) {
      keys.fault("name", "the block " + name + " is defined twice");
    }
    List<Factor> varied = varied(keys, factors);
    Optional<StimulusList> stimuli = stimuli(keys, varied);
    TrialBlock block =
        new TrialBlock(
            name,
            varied,
            stimuli,
            keys.choice(
                "pairing",
                List.of(TrialBlock.Pairing.values()),
                TrialBlock.Pairing::spelling,
                TrialBlock.Pairing.CROSSED),
            (int) keys.whole("repetitions", 1, 1000, 1),
            keys.choice(
                "order",
                List.of(TrialBlock.Order.values()),
                TrialBlock.Order::spelling,
                TrialBlock.Order.FIXED),
            runs(keys, varied, stimuli),
            settings.read(keys),
            phases.read(keys, columns(factors, stimuli)),
            (int) keys.whole("rest", 1, MOST_TRIALS, 0),
            keys.object("practice", "the practice", StudyDesignReader::practice),
            keys.object("staircase", "the staircase", each -> staircase(each, varied, stimuli)));
    check(keys, block);
    return block;
  }

  private static List<Factor> varied(JsonObjectReader keys, List<Factor> factors) {
    List<Factor> within =
        factors.stream().filter(factor -> factor.scope() == Factor.Scope.WITHIN).toList();
    if (!keys.has("factors")) {
      return within;
    }
    List<Factor> varied = new ArrayList<>();
    List<String> known = within.stream().map(Factor::name).toList();
    for (LocatedJsonValue value : keys.list("factors", false)) {
      int at = known.indexOf(value.toString());
      if (at < 0) {
        keys.fault(
            value,
            "'%s' is no factor that varies within participants%s"
                .formatted(value, near(value.toString(), known)));
      } else if (!varied.contains(within.get(at))) {
        varied.add(within.get(at));
      }
    }
    return varied;
  }

  private static String near(String name, List<String> known) {
    return SpellingSuggester.nearest(name, known)
        .map(near -> "; did you mean '" + near + "'?")
        .orElse(known.isEmpty() ? "" : " (known: " + String.join(", ", known) + ")");
  }

  /** Reads the stimulus list, whose cells in columns of factors must be levels. */
  private Optional<StimulusList> stimuli(JsonObjectReader keys, List<Factor> factors) {
    Optional<Path> file =
        keys.text("stimuli", false).map(name -> files.find(keys, "stimuli", name));
    if (file.isEmpty() || !Files.isRegularFile(file.get())) {
      return Optional.empty();
    }
    Optional<StimulusList> list;
    try {
      list = StimulusListReader.read(file.get(), problems);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    for (StimulusList.Stimulus row : list.map(StimulusList::rows).orElse(List.of())) {
      for (Factor factor : factors) {
        String cell = row.cells().get(factor.name());
        if (cell != null && factor.level(cell).isEmpty()) {
          problems.error(
              new SourceLocation(file.get().toString(), row.line(), 1),
              "'%s' is no level of the factor %s%s; the list is not used"
                  .formatted(
                      cell,
                      factor.name(),
                      near(cell, factor.levels().stream().map(Factor.Level::name).toList())));
        }
      }
    }
    return list;
  }

  private static List<String> columns(List<Factor> factors, Optional<StimulusList> stimuli) {
    List<String> columns = new ArrayList<>(factors.stream().map(Factor::name).toList());
    columns.addAll(stimuli.map(StimulusList::columns).orElse(List.of()));
    return columns;
  }

  private static Map<String, Integer> runs(
      JsonObjectReader keys, List<Factor> factors, Optional<StimulusList> stimuli) {
    Map<String, Integer> runs = new LinkedHashMap<>();
    List<String> known = columns(factors, stimuli);
    keys.object(
        "at_most_in_a_row",
        "the limits of runs",
        each -> {
          for (String name : each.names()) {
            if (!known.contains(name)) {
              each.fault(
                  name,
                  "'%s' is neither a factor of the block nor a column of its stimuli%s"
                      .formatted(name, near(name, known)));
            } else {
              runs.put(name, (int) each.whole(name, 1, MOST_TRIALS, Double.NaN));
            }
          }
          return runs;
        });
    return runs;
  }

  private static PracticeCriterion practice(JsonObjectReader keys) {
    return new PracticeCriterion(
        keys.number("correct", 0, 1, 0), (int) keys.whole("rounds", 1, 100, 1));
  }

  private static TrialStaircase staircase(
      JsonObjectReader keys, List<Factor> factors, Optional<StimulusList> stimuli) {
    List<String> known =
        factors.stream()
            .map(Factor::name)
            .filter(name -> stimuli.map(list -> !list.columns().contains(name)).orElse(true))
            .toList();
    String factor = keys.text("factor");
    if (!factor.isEmpty() && !known.contains(factor)) {
      keys.fault(
          "factor",
          "'%s' is no factor that a staircase of the block can vary%s"
              .formatted(factor, near(factor, known)));
    }
    int reversals = (int) keys.whole("reversals", 2, 100, 8);
    int discarded = (int) keys.whole("discarded", 0, 98, 2);
    if (discarded > reversals - 2) {
      keys.fault(
          "discarded",
          "of %d reversals at least two must be left for the estimate".formatted(reversals));
    }
    return new TrialStaircase(
        factor,
        (int) keys.whole("down", 1, 4, 2),
        reversals,
        Math.max(0, Math.min(discarded, reversals - 2)),
        (int) keys.whole("most", 2, 1000, 60));
  }

  private static void check(JsonObjectReader keys, TrialBlock block) {
    if (!block.runs().isEmpty() && block.order() != TrialBlock.Order.RANDOM) {
      keys.fault("at_most_in_a_row", "\"at_most_in_a_row\" needs \"order\": \"random\"");
    }
    if (block.staircase().isPresent() && block.practice().isPresent()) {
      keys.fault("staircase", "a block is either practice or a staircase");
    }
    long combinations =
        block.factors().stream()
            .filter(
                factor ->
                    block
                        .stimuli()
                        .map(list -> !list.columns().contains(factor.name()))
                        .orElse(true))
            .mapToLong(factor -> factor.levels().size())
            .reduce(1, (a, b) -> Math.min(MOST_TRIALS + 1L, a * b));
    if (block.order() == TrialBlock.Order.FULL && combinations > TrialSequencer.mostOfFullOrder()) {
      keys.fault(
          "order",
          "%d combinations of levels have more orders than participants can go through; use latin-square or random"
              .formatted(combinations));
    }
    long trials =
        (block.pairing() == TrialBlock.Pairing.ROTATED ? 1 : combinations)
            * block.stimuli().map(list -> list.rows().size()).orElse(1)
            * block.repetitions();
    if (trials > MOST_TRIALS) {
      keys.fault(
          "the block %s has %d trials, more than the %d that a block can have"
              .formatted(block.name(), trials, MOST_TRIALS));
    } else if (!keys.has("trial")) {
      keys.fault("a block needs a \"trial\": the list of its phases");
    }
  }
}
