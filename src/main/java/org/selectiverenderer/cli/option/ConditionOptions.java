package org.selectiverenderer.cli.option;

import java.util.Optional;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.schema.Condition;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The options for the rendering condition of a scene. */
public final class ConditionOptions {
  @Option(
      names = "--condition",
      defaultValue = "selective",
      converter = Converter.class,
      paramLabel = "NAME",
      description =
          "versions of the objects to show: selective, high, high-low or random "
              + "(default: ${DEFAULT-VALUE})")
  private Condition condition = Condition.SELECTIVE;

  @Option(
      names = "--seed",
      defaultValue = "0",
      paramLabel = "N",
      description =
          "seed of the random choice that --condition random makes (default: "
              + "${DEFAULT-VALUE})")
  private long seed;

  public SelectiveController.Settings settings() {
    return new SelectiveController.Settings(condition, seed);
  }

  /** Converts the thesis's name of a condition. */
  public static final class Converter implements ITypeConverter<Condition> {
    @Override
    public Condition convert(String value) {
      Optional<Condition> condition = Condition.of(value);
      if (condition.isEmpty()) {
        throw new TypeConversionException(
            "'" + value + "' is unknown; choose selective, high, high-low or random");
      }
      return condition.get();
    }
  }
}
