package org.selectiverenderer.cli.option;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.tracker.EulerAngle;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import picocli.CommandLine.Option;

/** The options for the processing of a tracker's samples. */
public final class TrackerFilterOptions {
  @Option(
      names = "--invert",
      split = ",",
      paramLabel = "ANGLE",
      description = "inverts yaw, pitch or roll, after --swap")
  private List<EulerAngle> inverted = List.of();

  @Option(
      names = "--swap",
      split = ",",
      arity = "1",
      paramLabel = "ANGLE",
      description = "swaps two angles, such as pitch,roll")
  private List<EulerAngle> swapped = List.of();

  @Option(
      names = "--smooth",
      arity = "0..1",
      fallbackValue = "default",
      paramLabel = "HZ[,SPEED]",
      description =
          "smooths jitter with a one-euro filter: cutoff at rest (1.5 Hz) and how "
              + "much it grows with the head's speed (8 Hz per rad/s); default: off")
  private @Nullable String smoothing;

  @Option(
      names = "--predict",
      defaultValue = "0",
      paramLabel = "MS",
      description =
          "predicts where the head will look after MS milliseconds, 0 to 100: the "
              + "known delay of the display; default: off")
  private double predictionMs;

  /** Rejects options that would have no effect. */
  public void check(TrackerSpec spec) {
    boolean none = spec instanceof TrackerSpec.None || spec instanceof TrackerSpec.Headset;
    if (none && options().change()) {
      throw CommandException.usage(
          "--invert, --swap, --smooth and --predict need --tracker"
              + (spec instanceof TrackerSpec.Headset ? "; a headset does this by itself" : ""));
    }
  }

  public TrackerOptions options() {
    try {
      return new TrackerOptions(
          swap(),
          inverted.isEmpty() ? EnumSet.noneOf(EulerAngle.class) : EnumSet.copyOf(inverted),
          Optional.ofNullable(smoothing).map(TrackerOptions.Smoothing::parse),
          predictionMs / 1000);
    } catch (IllegalArgumentException e) {
      throw CommandException.usage(e.getMessage());
    }
  }

  private Optional<TrackerOptions.Swap> swap() {
    if (swapped.isEmpty()) {
      return Optional.empty();
    }
    if (swapped.size() != 2) {
      throw CommandException.usage("--swap needs two angles, such as pitch,roll");
    }
    return Optional.of(new TrackerOptions.Swap(swapped.get(0), swapped.get(1)));
  }
}
