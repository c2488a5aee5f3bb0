package org.selectiverenderer.cli.option;

import java.util.LinkedHashMap;
import java.util.Map;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.QualityRule;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The option for qualities that the condition does not decide. */
public final class QualityOptions {
  @Option(
      names = "--quality",
      split = ",",
      converter = {QualityConverter.class, RuleConverter.class},
      paramLabel = "NAME=RULE",
      description =
          "sets one quality apart from the condition: polygons, textures, shading, light or "
              + "animation = selective, high or low; several with commas")
  private Map<Quality, QualityRule> rules = new LinkedHashMap<>();

  /** Returns the settings of the condition with the rules of these options. */
  public SelectiveController.Settings with(SelectiveController.Settings settings) {
    return settings.with(rules);
  }

  /** Converts the name of a quality. */
  public static final class QualityConverter implements ITypeConverter<Quality> {
    @Override
    public Quality convert(String value) {
      return Quality.of(value)
          .orElseThrow(
              () ->
                  new TypeConversionException(
                      "'" + value + "' is no quality; choose " + Quality.spellings()));
    }
  }

  /** Converts the name of a rule. */
  public static final class RuleConverter implements ITypeConverter<QualityRule> {
    @Override
    public QualityRule convert(String value) {
      return QualityRule.of(value)
          .orElseThrow(
              () ->
                  new TypeConversionException(
                      "'" + value + "' is unknown; choose selective, high or low"));
    }
  }
}
