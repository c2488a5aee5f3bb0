package org.selectiverenderer.cli.option;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.control.budget.RenderingBudget;
import org.selectiverenderer.schema.Quality;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The option for what a frame may cost. */
public final class BudgetOption {
  @Option(
      names = "--budget",
      converter = Converter.class,
      paramLabel = "triangles:N|ms:T",
      description =
          "shows the versions that lose least while the scene has at most N triangles, or a frame "
              + "takes at most T milliseconds, which only run measures; areas then say only what "
              + "is consistent (default: areas choose the versions)")
  private @Nullable RenderingBudget budget;

  /**
   * Returns settings with the budget, if there is one.
   *
   * @param measured whether the time of frames is measured, so that milliseconds can be kept
   */
  public SelectiveController.Settings in(SelectiveController.Settings settings, boolean measured) {
    if (budget == null) {
      return settings;
    }
    if (!settings.condition().switches()) {
      throw CommandException.usage(
          "--budget chooses the versions itself, --condition %s chooses others; leave one out"
              .formatted(settings.condition().spelling()));
    }
    if (settings.qualities().containsKey(Quality.POLYGONS)) {
      throw CommandException.usage(
          "--budget chooses how many polygons objects have; leave polygons out of --quality");
    }
    if (budget.unit() == RenderingBudget.Unit.MS && !measured) {
      throw CommandException.usage(
          "--budget %s needs frames that are drawn, and simulate draws none; give triangles:N, or "
                  .formatted(budget)
              + "use run");
    }
    return settings.within(budget);
  }

  /** Converts a budget. */
  public static final class Converter implements ITypeConverter<RenderingBudget> {
    @Override
    public RenderingBudget convert(String value) {
      return RenderingBudget.of(value)
          .orElseThrow(
              () ->
                  new TypeConversionException(
                      "'%s' is no budget; give triangles:N with a whole number, or ms:T, above 0"
                          .formatted(value)));
    }
  }
}
