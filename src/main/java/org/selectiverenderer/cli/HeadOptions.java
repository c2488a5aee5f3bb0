package org.selectiverenderer.cli;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.HeadSettings;
import org.selectiverenderer.hmd.TrackedMotion.WhenLost;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import picocli.CommandLine.Option;

/** The options about the head: its tracker and its log. */
final class HeadOptions {
  private enum Lost {
    freeze,
    mouse
  }

  @Option(
      names = "--tracker",
      defaultValue = "none",
      paramLabel = "SPEC",
      description =
          "intertrax2:PORT, fastrak:PORT@BAUD, opentrack:PORT, vrpn:NAME@HOST, tcp:HOST:PORT,"
              + " replay:FILE.csv or none; F4 makes where the head looks straight ahead (default:"
              + " ${DEFAULT-VALUE})")
  private String tracker = "none";

  @Option(
      names = "--tracker-lost",
      defaultValue = "freeze",
      description =
          "what turns the view while the tracker is silent: freeze (nothing) or mouse (default:"
              + " ${DEFAULT-VALUE})")
  private Lost lost = Lost.freeze;

  @Option(
      names = "--head-log",
      paramLabel = "F.csv",
      description =
          "writes frame by frame where the head is, looks and what it looks at; F.json beside it"
              + " describes it")
  private @Nullable Path log;

  @Option(
      names = "--cone",
      defaultValue = "" + HeadSettings.CONE,
      paramLabel = "DEG",
      description =
          "width of the cone about the middle of the view in which the head log names objects"
              + " (default: ${DEFAULT-VALUE})")
  private double cone = HeadSettings.CONE;

  /** Looks at the options before any work begins. */
  void check() {
    OutputFile.check("--head-log", log, ".csv");
    if (!(cone >= 0 && cone <= 90)) {
      throw CommandFailure.usage("--cone is a number of degrees from 0 to 90");
    }
  }

  /** The tracker that was asked for. */
  TrackerSpec tracker() {
    try {
      return TrackerSpec.parse(tracker);
    } catch (IllegalArgumentException e) {
      throw CommandFailure.usage(e.getMessage());
    }
  }

  /**
   * The settings with a tracker.
   *
   * @param options how its angles are taken
   */
  HeadSettings settings(TrackerSpec spec, TrackerOptions options) {
    return new HeadSettings(
        spec,
        options,
        WhenLost.valueOf(lost.name().toUpperCase(Locale.ROOT)),
        Optional.ofNullable(log),
        cone);
  }
}
