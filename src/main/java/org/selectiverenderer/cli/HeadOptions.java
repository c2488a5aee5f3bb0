package org.selectiverenderer.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.HeadSettings;
import org.selectiverenderer.experiment.headlog.HeadLogFiles;
import org.selectiverenderer.hmd.TrackedMotion.WhenLost;
import org.selectiverenderer.polygon.versions.FileTransaction;
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
      description =
          "what turns the view while the tracker is silent: freeze (nothing) or mouse (default:"
              + " freeze)")
  private @Nullable Lost lost;

  @Option(
      names = "--head-log",
      paramLabel = "F.csv",
      description =
          "writes frame by frame where the head is, looks and what it looks at; F.json beside it"
              + " describes it")
  private @Nullable Path log;

  @Option(names = "--force", description = "replaces a head log that is there already")
  private boolean force;

  @Option(
      names = "--cone",
      paramLabel = "DEG",
      description =
          "width of the cone about the middle of the view in which the head log names objects"
              + " (default: "
              + HeadSettings.CONE
              + ")")
  private @Nullable Double cone;

  /**
   * Looks at the options before any work begins.
   *
   * @param files takes those that are written
   */
  void check(TrackerSpec spec, RunFiles files) {
    if (cone != null && !(cone >= 0 && cone <= 90)) {
      throw CommandFailure.usage("--cone is a number of degrees from 0 to 90");
    }
    if (lost != null && spec instanceof TrackerSpec.None) {
      throw CommandFailure.usage("--tracker-lost goes with --tracker");
    }
    if (log == null) {
      if (cone != null || force) {
        throw CommandFailure.usage((force ? "--force" : "--cone") + " goes with --head-log");
      }
      return;
    }
    if (FileTransaction.sink(log)) {
      throw CommandFailure.usage(
          "--head-log " + log + ": is no file of a disk, beside which F.json could lie");
    }
    OutputFile.check("--head-log", log, ".csv");
    HeadLogFiles.of(log).forEach(file -> files.writes("--head-log", file));
  }

  /** Refuses to replace a log unless asked to. */
  void checkNew() {
    for (Path file : log == null || force ? List.<Path>of() : HeadLogFiles.of(log)) {
      if (Files.exists(file)) {
        throw CommandFailure.environment(
            "--head-log " + log + ": " + file + " is there already (--force replaces it)");
      }
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
        lost == null ? WhenLost.FREEZE : WhenLost.valueOf(lost.name().toUpperCase(Locale.ROOT)),
        Optional.ofNullable(log),
        cone == null ? HeadSettings.CONE : cone,
        force);
  }
}
