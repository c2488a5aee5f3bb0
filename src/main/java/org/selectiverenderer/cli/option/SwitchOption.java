package org.selectiverenderer.cli.option;

import org.selectiverenderer.schema.SwitchTransition;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The option for how the version of an object gives way to another one. */
public final class SwitchOption {
  @Option(
      names = "--switch",
      defaultValue = "at-once",
      converter = Converter.class,
      paramLabel = "HOW",
      description =
          "how objects change their versions: at-once, fade:MS (cross-faded in MS milliseconds) or "
              + "unseen[:DEG_PER_S] (when the object is out of view or hidden, or the head turns "
              + "faster than that, 180 if left out) (default: ${DEFAULT-VALUE})")
  private SwitchTransition transition = SwitchTransition.AT_ONCE;

  public SwitchTransition transition() {
    return transition;
  }

  /** Converts the spelling of a transition. */
  public static final class Converter implements ITypeConverter<SwitchTransition> {
    @Override
    public SwitchTransition convert(String value) {
      return SwitchTransition.of(value)
          .orElseThrow(
              () ->
                  new TypeConversionException(
                      "'%s' is unknown; choose at-once, fade:MS (up to %.0f) or unseen[:DEG_PER_S]"
                          .formatted(value, SwitchTransition.LONGEST_FADE)));
    }
  }
}
