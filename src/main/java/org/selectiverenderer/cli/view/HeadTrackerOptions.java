package org.selectiverenderer.cli.view;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.settings.HeadLogSettings;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.hmd.HeadTrackedMotion.WhenLost;
import org.selectiverenderer.study.headlog.HeadLogFiles;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import picocli.CommandLine.Option;

/** The options for the head tracker and the head log. */
final class HeadTrackerOptions {
  private enum Lost {
    freeze,
    mouse
  }

  @Option(
      names = "--tracker",
      defaultValue = "none",
      paramLabel = "SPEC",
      description =
          "tracker of the head: intertrax2:PORT, fastrak:PORT@BAUD, "
              + "opentrack:PORT, vrpn:NAME@HOST, tcp:HOST:PORT, replay:FILE.csv or "
              + "none; F4 makes the present direction of the head straight ahead "
              + "(default: ${DEFAULT-VALUE})")
  private String tracker = "none";

  @Option(
      names = "--tracker-lost",
      paramLabel = "SOURCE",
      description =
          "source that turns the view while the tracker is silent: freeze (nothing) "
              + "or mouse (default: freeze)")
  private @Nullable Lost lost;

  private enum Placed {
    on,
    off
  }

  @Option(
      names = "--tracker-position",
      paramLabel = "on|off",
      description =
          "use of the head's position, if the tracker reports it (opentrack, vrpn, fastrak,"
              + " replay): on or off (default: off; a headset's is always used)")
  private @Nullable Placed placed;

  @Option(
      names = "--head-log",
      paramLabel = "F.csv",
      description =
          "writes a table with position, direction and target of the head's view in "
              + "each frame; F.json beside it describes the columns")
  private @Nullable Path log;

  @Option(names = "--force", description = "replaces an existing head log")
  private boolean force;

  @Option(
      names = "--cone",
      paramLabel = "DEG",
      description =
          "width of the cone about the middle of the view in which the head log lists objects"
              + " (default: "
              + HeadLogSettings.CONE
              + ")")
  private @Nullable Double cone;

  /**
   * Checks the options before any work begins.
   *
   * @param files receives the output files
   */
  void check(TrackerSpec spec, CommandFileCheck files) {
    if (cone != null && !(cone >= 0 && cone <= 90)) {
      throw CommandException.usage("--cone must be a number of degrees from 0 to 90");
    }
    if (lost != null && spec instanceof TrackerSpec.None) {
      throw CommandException.usage("--tracker-lost needs --tracker");
    }
    if (placed != null) {
      checkPlaced(spec);
    }
    if (log == null) {
      if (cone != null || force) {
        throw CommandException.usage((force ? "--force" : "--cone") + " needs --head-log");
      }
      return;
    }
    if (FileTransaction.sink(log)) {
      throw CommandException.usage(
          "--head-log " + log + ": is not a file on a disk, so F.json cannot be written beside it");
    }
    OutputFile.check("--head-log", log, ".csv");
    HeadLogFiles.of(log).forEach(file -> files.writes("--head-log", file));
  }

  /** Returns whether the head's position is used. */
  boolean placed() {
    return placed == Placed.on;
  }

  private void checkPlaced(TrackerSpec spec) {
    if (spec instanceof TrackerSpec.Headset) {
      throw CommandException.usage(
          "--tracker-position: the position of a headset is always used; leave it out with "
              + "--display openxr");
    }
    if (placed()
        && !(spec instanceof TrackerSpec.OpenTrack
            || spec instanceof TrackerSpec.Vrpn
            || spec instanceof TrackerSpec.Fastrak
            || spec instanceof TrackerSpec.Replay)) {
      throw CommandException.usage(
          "--tracker-position on needs a tracker that reports positions: opentrack, vrpn, "
              + "fastrak or a replay of one");
    }
  }

  /** Rejects an existing log unless it may be replaced. */
  void checkNew() {
    for (Path file : log == null || force ? List.<Path>of() : HeadLogFiles.of(log)) {
      if (Files.exists(file)) {
        throw CommandException.environment(
            "--head-log " + log + ": " + file + " exists already (--force replaces it)");
      }
    }
  }

  /**
   * Returns the tracker that the options ask for.
   *
   * @param worn whether the scene is shown in a headset, which is a tracker itself
   */
  TrackerSpec tracker(boolean worn) {
    try {
      TrackerSpec spec = TrackerSpec.parse(tracker);
      if (worn && !(spec instanceof TrackerSpec.None)) {
        throw CommandException.usage(
            "--display openxr has the headset's own tracker; leave --tracker out");
      }
      return worn ? new TrackerSpec.Headset() : spec;
    } catch (IllegalArgumentException e) {
      throw CommandException.usage(e.getMessage());
    }
  }

  /**
   * Returns the settings of a tracker.
   *
   * @param options how its angles are taken
   */
  TrackerSettings tracking(TrackerSpec spec, TrackerOptions options) {
    return new TrackerSettings(
        spec,
        options,
        lost == null ? WhenLost.FREEZE : WhenLost.valueOf(lost.name().toUpperCase(Locale.ROOT)),
        placed());
  }

  /** Returns the settings of the head log. */
  Optional<HeadLogSettings> recorded() {
    return Optional.ofNullable(log)
        .map(file -> new HeadLogSettings(file, cone == null ? HeadLogSettings.CONE : cone, force));
  }
}
