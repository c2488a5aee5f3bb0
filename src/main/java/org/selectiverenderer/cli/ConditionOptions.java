package org.selectiverenderer.cli;

import org.selectiverenderer.control.Condition;
import org.selectiverenderer.control.SelectiveController;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The options that say how a scene is rendered, shared by several commands. */
final class ConditionOptions {
  @Option(
      names = "--condition",
      defaultValue = "selective",
      converter = Converter.class,
      paramLabel = "NAME",
      description =
          "selective, high, high-low or random: which versions of the objects are shown"
              + " (default: ${DEFAULT-VALUE})")
  private Condition condition = Condition.SELECTIVE;

  @Option(
      names = "--seed",
      defaultValue = "0",
      paramLabel = "N",
      description = "of the lot drawn by --condition random (default: ${DEFAULT-VALUE})")
  private long seed;

  SelectiveController.Settings settings() {
    return new SelectiveController.Settings(condition, seed);
  }

  /** Reads a condition by the name that the thesis gives it. */
  static final class Converter implements ITypeConverter<Condition> {
    @Override
    public Condition convert(String value) {
      return Condition.of(value)
          .orElseThrow(
              () ->
                  new TypeConversionException(
                      "'" + value + "' is none of selective, high, high-low, random"));
    }
  }
}
