package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.HeadSettings;
import org.selectiverenderer.app.OffscreenRun;
import org.selectiverenderer.app.Replays;
import org.selectiverenderer.app.RunResult;
import org.selectiverenderer.app.RunSettings;
import org.selectiverenderer.app.RunStop;
import org.selectiverenderer.app.WindowRun;
import org.selectiverenderer.experiment.headlog.HeadLogFiles;
import org.selectiverenderer.hmd.DisplayMode;
import org.selectiverenderer.hmd.Presentation;
import org.selectiverenderer.runtime.navigation.CameraPath;
import org.selectiverenderer.runtime.navigation.CameraPathReader;
import org.selectiverenderer.runtime.navigation.MouseMapping;
import org.selectiverenderer.runtime.render.context.GlAvailability;
import org.selectiverenderer.runtime.render.context.GlUnavailableException;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.x3d.Problems;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "run",
    description = {
      "Shows a scene and renders it selectively.",
      "Walk: hold the left mouse button (right: backward) and move the mouse to steer, or use the"
          + " arrow keys or W A S D. Page Up and Page Down go from viewpoint to viewpoint, Home back"
          + " to the present one. F1 shows figures, F2 changes the way of moving, F3 switches"
          + " collisions, F4 makes where a tracked head looks straight ahead, F11 fills the"
          + " screen, Escape ends."
    },
    footer = {
      "  ./selective-renderer run scenes/trashcan.x3d",
      "  ./selective-renderer run scenes/trashcan.x3d --offscreen --screenshot office.png",
      "  ./selective-renderer run scenes/apartment.x3d --display dual --tracker intertrax2:/dev/ttyUSB0"
    })
final class RunCommand extends CliCommand {
  private enum Mouse {
    walk,
    experiment,
    off
  }

  @Parameters(paramLabel = "SCENE", description = "the X3D scene (.x3d, .x3dz)")
  private Path scene = Path.of("");

  @Mixin private ConditionOptions condition = new ConditionOptions();

  @Option(
      names = "--mouse",
      defaultValue = "walk",
      description =
          "what the buttons do: walk (left forward, right backward), experiment (the other way"
              + " round), off (default: ${DEFAULT-VALUE})")
  private Mouse mouse = Mouse.walk;

  @Option(names = "--duration", paramLabel = "S", description = "ends the run after S seconds")
  private @Nullable Double duration;

  @Option(
      names = "--path",
      paramLabel = "P.csv",
      description = "the viewer follows a recorded path: t,x,y,z[,yaw,pitch,roll]")
  private @Nullable Path path;

  @Option(
      names = "--offscreen",
      description =
          "without a window, as fast as frames can be drawn; needs a display all the same")
  private boolean offscreen;

  @Mixin private DisplayOptions display = new DisplayOptions();

  @Mixin private HeadOptions head = new HeadOptions();

  @Mixin private TrackerFlags trackerFlags = new TrackerFlags();

  @Option(
      names = "--size",
      converter = PixelSize.Converter.class,
      paramLabel = "WxH",
      description = "of the picture (default: 1024x768, or what the display has)")
  private @Nullable PixelSize size;

  @Option(
      names = "--samples",
      paramLabel = "N",
      description =
          "per pixel against jagged edges, 0 for none (default: 4, but none for moving pictures"
              + " where there is no graphics card)")
  private @Nullable Integer samples;

  @Option(
      names = "--screenshot",
      paramLabel = "F.png",
      description = "writes the last picture to a file")
  private @Nullable Path screenshot;

  @Option(
      names = "--operator-screenshot",
      paramLabel = "F.png",
      description = "writes the last picture of the operator's window to a file")
  private @Nullable Path operatorScreenshot;

  @Option(
      names = "--timeline",
      paramLabel = "F.jsonl",
      description = "writes what happened, one JSON object a line, as simulate does")
  private @Nullable Path timeline;

  @Option(names = "--stats", paramLabel = "F.json", description = "writes the figures of the run")
  private @Nullable Path stats;

  RunCommand(Console console) {
    super(console);
  }

  @Override
  ExitStatus run() throws IOException {
    TrackerSpec tracker = head.tracker();
    check(tracker);
    Problems pathProblems = new Problems(console()::problem);
    boolean session =
        tracker instanceof TrackerSpec.Replay replay && Replays.hasPositions(replay.file());
    Path walkedFile = session ? ((TrackerSpec.Replay) tracker).file() : path;
    Optional<CameraPath> walked =
        walkedFile == null ? Optional.empty() : CameraPathReader.read(walkedFile, pathProblems);
    if (walkedFile != null && walked.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    walked.ifPresent(known -> checkPath(known, tracker, session));
    HeadSettings headSettings =
        head.settings(session ? new TrackerSpec.None() : tracker, trackerFlags.options());
    Optional<Presentation> presentation = display.presentation(pathProblems);
    if (presentation.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    Presentation shown = shown(presentation.get());
    PixelSize pixels = size == null ? new PixelSize(shown.width(), shown.height()) : size;
    RunSettings settings =
        new RunSettings(
            scene,
            condition.settings(),
            walked,
            duration == null ? OptionalDouble.empty() : OptionalDouble.of(duration),
            pixels.width(),
            pixels.height(),
            samples == null ? OptionalInt.empty() : OptionalInt.of(samples),
            MouseMapping.valueOf(mouse.name().toUpperCase(java.util.Locale.ROOT)),
            shown,
            session,
            headSettings,
            display.operator(),
            size != null);
    RunStop stop = new RunStop();
    AtomicReference<ExitStatus> ended = new AtomicReference<>(ExitStatus.DONE);
    Interruption.stops(
        stop::stop,
        () -> {
          RunResult result = show(settings, stop);
          write(result);
          if (result.problems() || pathProblems.any()) {
            ended.set(ExitStatus.PROBLEMS);
          }
        });
    return ended.get();
  }

  private void write(RunResult result) throws IOException {
    if (stats != null) {
      Files.writeString(stats, result.figures().json() + "\n", StandardCharsets.UTF_8);
    }
    if (screenshot != null && result.screenshot().isPresent()) {
      result.screenshot().get().writePng(screenshot);
    }
    if (operatorScreenshot != null && result.operator().isPresent()) {
      result.operator().get().writePng(operatorScreenshot);
    } else if (operatorScreenshot != null) {
      console()
          .message(
              "--operator-screenshot "
                  + operatorScreenshot
                  + ": there was no operator's window; nothing is written");
    }
  }

  private void checkPath(CameraPath walked, TrackerSpec tracker, boolean session) {
    Frames.check(walked, RunSettings.PATH_RATE);
    if (session && path != null) {
      throw CommandFailure.usage("a head log has positions of its own: leave --path away");
    }
    boolean turned = walked.at(walked.start()).orientation().isPresent();
    if (!session && turned && !(tracker instanceof TrackerSpec.None)) {
      throw CommandFailure.usage(
          "a path that turns the view and --tracker exclude one another: leave yaw, pitch and roll"
              + " out of the path");
    }
  }

  /** What there is without a window has neither monitors nor buffers of its own. */
  private Presentation shown(Presentation wanted) {
    boolean windows = wanted.mode() == DisplayMode.DUAL || wanted.mode() == DisplayMode.QUAD;
    if (!offscreen || !windows) {
      return wanted;
    }
    console().message("--offscreen draws both eyes side by side instead");
    return wanted.as(DisplayMode.SIDE_BY_SIDE);
  }

  private void check(TrackerSpec tracker) throws IOException {
    if (duration != null && !(duration > 0)) {
      throw CommandFailure.usage("--duration is a number of seconds above 0");
    }
    if (samples != null && (samples < 0 || samples > 16)) {
      throw CommandFailure.usage("--samples is a number from 0 to 16");
    }
    OutputFile.check("--screenshot", screenshot, ".png");
    OutputFile.check("--operator-screenshot", operatorScreenshot, ".png");
    OutputFile.check("--timeline", timeline, "");
    OutputFile.check("--stats", stats, "");
    display.check(offscreen, operatorScreenshot);
    trackerFlags.check(tracker);
    RunFiles files =
        new RunFiles()
            .reads("the scene", scene)
            .reads("--path", path)
            .reads("--hmd", display.file())
            .writes("--screenshot", screenshot)
            .writes("--operator-screenshot", operatorScreenshot)
            .writes("--timeline", timeline)
            .writes("--stats", stats);
    if (tracker instanceof TrackerSpec.Replay replay) {
      HeadLogFiles.of(replay.file()).forEach(file -> files.reads("--tracker", file));
    }
    head.check(tracker, files);
    files.check();
    head.checkNew();
    GlAvailability.check().ifPresent(this::noDisplay);
  }

  private RunResult show(RunSettings settings, RunStop stop) throws IOException {
    try (RunOutput output = RunOutput.open(console(), timeline)) {
      return offscreen
          ? new OffscreenRun(settings).run(output, stop)
          : WindowRun.run(settings, output, stop);
    } catch (GlUnavailableException e) {
      noDisplay(e.getMessage());
      throw e;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw CommandFailure.environment("interrupted");
    }
  }

  private void noDisplay(String reason) {
    String advice =
        offscreen
            ? "simulate walks a path through a scene without a display"
            : "simulate walks a path through a scene without a display, and run --offscreen draws"
                + " without a window where there is a display such as Xvfb";
    throw CommandFailure.environment(reason + "; " + advice);
  }
}
