package org.selectiverenderer.statistics.script;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.statistics.data.Measurement;

/**
 * A script for R that repeats the analyses of a study's trials, and the table that it reads. Names
 * of analyses, factors, levels and participants are strings in them, never code: in models the
 * factors are {@code f1}, {@code f2} and so on.
 *
 * @param models the analyses, in order
 */
public record DesignScript(List<Model> models) {
  private static final Pattern PLAIN = Pattern.compile("[0-9A-Za-z][0-9A-Za-z_. -]{0,99}");

  /** The largest number of factors of an analysis. */
  private static final int MOST_FACTORS = 5;

  /**
   * An analysis.
   *
   * @param factors names of the factors
   * @param between those of them that vary between participants
   * @param median whether a participant's values at the same levels become their median, else mean
   * @param mixed whether a mixed model of the single values is fitted, too
   * @param binary whether all values are 0 or 1
   * @param values with the levels in the order of the factors
   */
  public record Model(
      String name,
      List<String> factors,
      List<String> between,
      boolean median,
      boolean mixed,
      boolean binary,
      List<Measurement> values) {
    /** Copies the lists. */
    public Model {
      factors = List.copyOf(factors);
      between = List.copyOf(between);
      values = List.copyOf(values);
    }
  }

  /** Copies the models. */
  public DesignScript {
    models = List.copyOf(models);
  }

  /**
   * Returns the script.
   *
   * @param dataFile name of the table of {@link #data}, in the script's folder
   */
  public String script(String dataFile) {
    return RScriptGenerator.template("design.R")
        .replace("@DATA@", RScriptGenerator.quoted(dataFile))
        .replace(
            "@ANALYSES@",
            models.stream().map(DesignScript::list).collect(Collectors.joining(",\n")));
  }

  private static String list(Model model) {
    return "  list(name = %s, labels = %s, between = %s, median = %s, mixed = %s, binary = %s)"
        .formatted(
            RScriptGenerator.quoted(model.name()),
            model.factors().stream()
                .map(RScriptGenerator::quoted)
                .collect(Collectors.joining(", ", "c(", ")")),
            model.factors().stream()
                .map(factor -> truth(model.between().contains(factor)))
                .collect(Collectors.joining(", ", "c(", ")")),
            truth(model.median()),
            truth(model.mixed()),
            truth(model.binary()));
  }

  private static String truth(boolean value) {
    return value ? "TRUE" : "FALSE";
  }

  /**
   * Returns the table of all values, as CSV. A participant or level whose name R's tables or models
   * may not keep has a number in its place.
   */
  public String data() {
    CsvWriter table = CsvWriter.bare();
    table.row("analysis", "participant", "f1", "f2", "f3", "f4", "f5", "value");
    Map<String, String> names = new HashMap<>();
    for (int i = 0; i < models.size(); i++) {
      for (Measurement value : models.get(i).values()) {
        List<Object> row = new ArrayList<>(List.of(i + 1));
        row.add(name(value.participant(), names));
        for (int factor = 0; factor < MOST_FACTORS; factor++) {
          row.add(factor < value.levels().size() ? name(value.levels().get(factor), names) : "");
        }
        row.add(Double.toString(value.value()));
        table.row(row);
      }
    }
    return table.toString();
  }

  private static String name(String name, Map<String, String> names) {
    return names.computeIfAbsent(
        name, first -> PLAIN.matcher(name).matches() ? name : "unnamed " + (names.size() + 1));
  }

  /**
   * Returns the name of an effect in R's results, such as {@code f1:f2}, with the factors' names.
   */
  public static String effect(Model model, String inScript) {
    return Arrays.stream(inScript.split(":"))
        .map(
            part -> {
              int at = part.matches("f[1-5]") ? part.charAt(1) - '1' : MOST_FACTORS;
              return at < model.factors().size() ? model.factors().get(at) : part;
            })
        .collect(Collectors.joining(" x "));
  }
}
