package org.selectiverenderer.study.definition;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.LocatedJsonValue;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.PlannedAnalysis;
import org.selectiverenderer.study.design.PlannedAnalysis.Aggregate;
import org.selectiverenderer.study.design.PlannedAnalysis.Limits;
import org.selectiverenderer.study.design.PlannedAnalysis.Test;
import org.selectiverenderer.study.design.StudyDesign;
import org.selectiverenderer.study.design.TrialColumns;

/**
 * Reads the key {@code analysis} of a study: what is planned before there are data. Whether a
 * measure is a question is known only when the questionnaires are.
 */
final class PlannedAnalysesReader {
  /** More factors have too many interactions to interpret. */
  private static final int MOST_FACTORS = 5;

  private final StudyDesign design;
  private final Set<String> stimuli = new LinkedHashSet<>();
  private final Set<String> names = new HashSet<>();

  PlannedAnalysesReader(StudyDesign design) {
    this.design = design;
    design.blocks().forEach(block -> block.stimuli().ifPresent(s -> stimuli.addAll(s.columns())));
  }

  List<PlannedAnalysis> read(JsonObjectReader keys) {
    if (keys.has("analysis") && design.blocks().isEmpty()) {
      keys.fault("analysis", "\"analysis\" needs \"blocks\" of trials to analyse");
    }
    return keys.objects("analysis", "an analysis", this::analysis);
  }

  private PlannedAnalysis analysis(JsonObjectReader keys) {
    String name = keys.text("name");
    if (!names.add(name.toLowerCase(Locale.ROOT))) {
      keys.fault("name", "the analysis " + name + " is planned twice");
    }
    SourceLocation place =
        keys.value("measure")
            .or(() -> keys.value("name"))
            .map(LocatedJsonValue::at)
            .orElseGet(() -> SourceLocation.of(""));
    String measure = keys.text("measure");
    if (measure.equals(PlannedAnalysis.THRESHOLD)
        && design.blocks().stream().allMatch(block -> block.staircase().isEmpty())) {
      keys.fault("measure", "\"threshold\" needs a block with a \"staircase\"");
    }
    Map<String, String> where =
        keys.object("where", "the trials that count", this::where).orElse(Map.of());
    Map<String, String> signal =
        keys.object("signal", "the signal", each -> signal(each)).orElse(Map.of());
    if (measure.equals(PlannedAnalysis.D_PRIME) != (signal.size() == 1)) {
      keys.fault(
          keys.has("signal") ? "signal" : "measure",
          "\"dprime\", and it alone, needs \"signal\": the column of the stimuli and its cell where"
              + " there is something to detect, such as {\"answer\": \"f\"}");
    }
    Aggregate aggregate =
        keys.choice(
            "aggregate",
            List.of(Aggregate.values()),
            Aggregate::spelling,
            measure.equals(PlannedAnalysis.CORRECT) ? Aggregate.SHARE : Aggregate.MEAN);
    Test test = keys.choice("test", List.of(Test.values()), Test::spelling, Test.ANOVA);
    if (test == Test.MIXED_MODEL
        && Set.of(PlannedAnalysis.D_PRIME, PlannedAnalysis.THRESHOLD).contains(measure)) {
      keys.fault("test", "a mixed model is of single trials, which have no %s".formatted(measure));
    }
    return new PlannedAnalysis(
        name,
        keys.text("hypothesis", false).orElse(""),
        measure,
        where,
        by(keys, measure, where),
        aggregate,
        keys.object("exclude", "the exclusions", PlannedAnalysesReader::exclusions)
            .orElse(Map.of()),
        signal,
        test,
        place);
  }

  private Map<String, String> where(JsonObjectReader keys) {
    Map<String, String> where = new LinkedHashMap<>();
    List<String> known = new ArrayList<>(List.of("group", "block", "response", "correct"));
    known.addAll(design.factorNames());
    known.addAll(stimuli);
    for (String column : keys.names()) {
      String cell = keys.text(column);
      // The column of a question has a dot; whether there is one is checked with the measures.
      if (!known.contains(column) && column.indexOf('.') < 0) {
        keys.fault(column, unknown(column, known, "is no column of the table of trials"));
      }
      Optional<Factor> factor = factor(column);
      if (factor.isPresent() && factor.get().level(cell).isEmpty()) {
        keys.fault(
            column,
            unknown(
                cell,
                factor.get().levels().stream().map(Factor.Level::name).toList(),
                "is no level of the factor " + column));
      }
      if (column.equals("block")
          && design.blocks().stream().noneMatch(block -> block.name().equals(cell))) {
        keys.fault(
            column,
            unknown(cell, design.blocks().stream().map(b -> b.name()).toList(), "is no block"));
      }
      if (column.equals("correct") && !cell.matches("yes|no")) {
        keys.fault(column, "\"correct\" is \"yes\" or \"no\", not '%s'".formatted(cell));
      }
      where.put(column, cell);
    }
    return where;
  }

  private Map<String, String> signal(JsonObjectReader keys) {
    Map<String, String> signal = new LinkedHashMap<>();
    List<String> known = new ArrayList<>(stimuli);
    known.addAll(design.factorNames());
    for (String column : keys.names()) {
      if (!known.contains(column)) {
        keys.fault(
            column, unknown(column, known, "is neither a column of the stimuli nor a factor"));
      }
      signal.put(column, keys.text(column));
    }
    return signal;
  }

  private List<String> by(JsonObjectReader keys, String measure, Map<String, String> where) {
    List<String> by = new ArrayList<>();
    List<String> known = new ArrayList<>(design.factorNames());
    if (known.isEmpty() && design.groups().size() > 1) {
      known.add("group");
    }
    known.addAll(stimuli.stream().filter(column -> !known.contains(column)).toList());
    for (LocatedJsonValue value : keys.list("by", true)) {
      String name = value.toString();
      if (!known.contains(name)) {
        keys.fault(value, unknown(name, known, "is neither a factor nor a column of the stimuli"));
      } else if (by.contains(name)) {
        keys.fault(value, "the factor %s is named twice".formatted(name));
      } else if (where.containsKey(name)) {
        keys.fault(value, "of the factor %s only one level counts by \"where\"".formatted(name));
      } else if (measure.equals(PlannedAnalysis.THRESHOLD) && varied(name)) {
        keys.fault(value, "the staircase itself chooses the level of the factor " + name);
      } else {
        by.add(name);
      }
    }
    if (by.isEmpty() && keys.has("by")) {
      keys.fault("by", "an analysis needs a factor, or a column of the stimuli, to compare by");
    } else if (by.size() > MOST_FACTORS) {
      keys.fault("by", "at most %d factors can be analysed together".formatted(MOST_FACTORS));
    }
    return by;
  }

  private boolean varied(String factor) {
    return design.blocks().stream()
        .flatMap(block -> block.staircase().stream())
        .anyMatch(staircase -> staircase.factor().equals(factor));
  }

  private static Map<String, Limits> exclusions(JsonObjectReader keys) {
    Map<String, Limits> exclusions = new LinkedHashMap<>();
    for (String column : keys.names()) {
      if (!column.equals(PlannedAnalysis.MILLISECONDS) && TrialColumns.reserved(column)) {
        keys.fault(column, "'%s' has no values to exclude by their size".formatted(column));
      }
      keys.object(
              column,
              "the limits of " + column,
              each ->
                  new Limits(
                      each.number("below", -1e12, 1e12, Double.NEGATIVE_INFINITY),
                      each.number("above", -1e12, 1e12, Double.POSITIVE_INFINITY)))
          .ifPresent(limits -> exclusions.put(column, limits));
    }
    return exclusions;
  }

  private Optional<Factor> factor(String name) {
    return design.factors().stream().filter(factor -> factor.name().equals(name)).findFirst();
  }

  private static String unknown(String name, List<String> known, String what) {
    return "'%s' %s%s"
        .formatted(
            name,
            what,
            SpellingSuggester.nearest(name, known)
                .map(near -> "; did you mean '" + near + "'?")
                .orElse(known.isEmpty() ? "" : " (known: " + String.join(", ", known) + ")"));
  }
}
