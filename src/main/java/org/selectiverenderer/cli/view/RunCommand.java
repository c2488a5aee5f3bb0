package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.head.Replays;
import org.selectiverenderer.app.headset.HeadsetLink;
import org.selectiverenderer.app.run.RunResult;
import org.selectiverenderer.app.run.RunStop;
import org.selectiverenderer.app.run.SceneRunner;
import org.selectiverenderer.app.settings.DisplaySettings;
import org.selectiverenderer.app.settings.FollowedPath;
import org.selectiverenderer.app.settings.MotionSettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.app.stream.LabStreams;
import org.selectiverenderer.app.timeline.TimelineEvent;
import org.selectiverenderer.base.machine.ParentProcess;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.cli.base.CliCommand;
import org.selectiverenderer.cli.option.AccessOptions;
import org.selectiverenderer.cli.option.ConditionOptions;
import org.selectiverenderer.cli.option.LslOptions;
import org.selectiverenderer.cli.option.SceneArgument;
import org.selectiverenderer.cli.option.TrackerFlags;
import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.cli.output.CommandFiles;
import org.selectiverenderer.cli.output.Console;
import org.selectiverenderer.cli.output.ExitStatus;
import org.selectiverenderer.cli.output.Interruption;
import org.selectiverenderer.cli.output.RunOutput;
import org.selectiverenderer.experiment.headlog.HeadLogFiles;
import org.selectiverenderer.hmd.DisplayMode;
import org.selectiverenderer.hmd.Presentation;
import org.selectiverenderer.lsl.LslLibrary;
import org.selectiverenderer.openxr.HeadsetUnavailableException;
import org.selectiverenderer.runtime.render.context.GlAvailability;
import org.selectiverenderer.runtime.render.context.GlUnavailableException;
import org.selectiverenderer.runtime.viewer.CameraPath;
import org.selectiverenderer.runtime.viewer.CameraPathReader;
import org.selectiverenderer.runtime.walk.MouseMapping;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.x3d.files.ContentAccess;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "run",
    description = {
      "Shows a scene and renders it selectively.",
      "To walk, hold the left mouse button (right: backward) and move the mouse to "
          + "steer, or use the arrow keys or W A S D. Page Up and Page Down go to other "
          + "viewpoints, Home returns to the present one. F1 shows figures, F2 changes the "
          + "way of moving, F3 switches collisions on or off, F4 makes the present "
          + "direction of a tracked head straight ahead, F5 shows the whole scene, F11 fills the "
          + "screen, Escape ends the run."
    },
    footer = {
      "  ./selective-renderer run scenes/trashcan.x3d",
      "  ./selective-renderer run scenes/trashcan.x3d --offscreen \\",
      "      --screenshot office.png",
      "  ./selective-renderer run scenes/apartment.x3d --display dual \\",
      "      --tracker intertrax2:/dev/ttyUSB0"
    })
public final class RunCommand extends CliCommand {
  private enum Mouse {
    walk,
    experiment,
    off
  }

  @Mixin private SceneArgument scene = new SceneArgument();

  @Mixin private AccessOptions access = new AccessOptions();

  @Mixin private ConditionOptions condition = new ConditionOptions();

  @Option(
      names = "--mouse",
      paramLabel = "EFFECT",
      defaultValue = "walk",
      description =
          "effect of the mouse buttons: walk (left forward, right backward), "
              + "experiment (the other way round), off (default: ${DEFAULT-VALUE})")
  private Mouse mouse = Mouse.walk;

  @Option(names = "--duration", paramLabel = "S", description = "ends the run after S seconds")
  private @Nullable Double duration;

  @Option(
      names = "--path",
      paramLabel = "P.csv",
      description = "moves the viewer along a recorded path: t,x,y,z[,yaw,pitch,roll]")
  private @Nullable Path path;

  @Option(
      names = "--offscreen",
      description = "draws without a window, as fast as possible; still needs a display")
  private boolean offscreen;

  @Option(names = "--mute", description = "leaves out the sounds of the scene")
  private boolean mute;

  @Mixin private ViewOptions view = new ViewOptions();

  @Mixin private DisplayOptions display = new DisplayOptions();

  @Mixin private HeadOptions head = new HeadOptions();

  @Mixin private TrackerFlags trackerFlags = new TrackerFlags();

  @Mixin private LslOptions lsl = new LslOptions();

  @Option(
      names = "--size",
      converter = PixelSize.Converter.class,
      paramLabel = "WxH",
      description = "size of the picture (default: 1024x768, or that of the display)")
  private @Nullable PixelSize size;

  @Option(
      names = "--samples",
      paramLabel = "N",
      description =
          "samples per pixel that smooth edges, 0 for none (default: 4, but 0 for "
              + "moving pictures without a graphics card)")
  private @Nullable Integer samples;

  @Mixin private RecordOptions records = new RecordOptions();

  public RunCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    // A run that the enricher started ends with it, as by Ctrl-C, with complete files.
    ParentProcess.whenItEnds(() -> System.exit(ExitStatus.FAILURE.code()));
    if (view.listed()) {
      return ViewOptions.list(scene.file(), console());
    }
    TrackerSpec tracker = head.tracker(display.worn());
    CommandFiles files = check(tracker);
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
    TrackerSettings tracking =
        head.tracking(session ? new TrackerSpec.None() : tracker, trackerFlags.options());
    Optional<Presentation> presentation = display.presentation(pathProblems);
    if (presentation.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    ContentAccess allowed = access.access();
    RunSettings settings =
        new RunSettings(scene.file(), condition.settings())
            .allowing(allowed)
            .muted(mute)
            .with(motion(walked, session))
            .with(display(presentation.get()))
            .with(tracking, head.recorded())
            .lasting(duration == null ? OptionalDouble.empty() : OptionalDouble.of(duration));
    RunStop stop = new RunStop();
    AtomicReference<ExitStatus> ended = new AtomicReference<>(ExitStatus.DONE);
    Interruption.stops(
        stop::stop,
        () -> {
          RunResult result = show(settings, () -> files.check(allowed.named()), stop);
          files.check(allowed.named()); // A running scene may have loaded more files.
          records.write(result, console());
          if (result.problems() || pathProblems.any()) {
            ended.set(ExitStatus.PROBLEMS);
          }
        });
    return ended.get();
  }

  private MotionSettings motion(Optional<CameraPath> walked, boolean session) {
    return new MotionSettings(
        MouseMapping.valueOf(mouse.name().toUpperCase(Locale.ROOT)),
        walked.map(
            path -> session ? FollowedPath.rows(path) : FollowedPath.at(FollowedPath.RATE, path)),
        view.viewpoint(),
        view.collisions());
  }

  private DisplaySettings display(Presentation wanted) {
    DisplaySettings suited =
        DisplaySettings.of(shown(wanted))
            .samples(samples == null ? OptionalInt.empty() : OptionalInt.of(samples))
            .style(view.style())
            .operator(display.operator());
    return size == null ? suited : suited.sized(size.width(), size.height());
  }

  private void checkPath(CameraPath walked, TrackerSpec tracker, boolean session) {
    FrameLimits.check(walked, FollowedPath.RATE);
    if (session && path != null) {
      throw CommandFailure.usage(
          "--path cannot be combined with a replayed head log, which has positions of "
              + "its own; leave --path out");
    }
    if (session && head.placed()) {
      throw CommandFailure.usage(
          "--tracker-position cannot be combined with a replayed head log, whose positions are "
              + "always used; leave it out");
    }
    boolean turned = walked.at(walked.start()).orientation().isPresent();
    if (!session && turned && !(tracker instanceof TrackerSpec.None)) {
      throw CommandFailure.usage(
          "--tracker and --display openxr cannot be combined with a path that turns the view; "
              + "leave yaw, pitch and roll out of the path");
    }
  }

  /**
   * Returns the presentation: off-screen rendering has neither monitors nor quad buffers, so it
   * shows both eyes side by side.
   */
  private Presentation shown(Presentation wanted) {
    boolean windows = wanted.mode() == DisplayMode.DUAL || wanted.mode() == DisplayMode.QUAD;
    if (!offscreen || !windows) {
      return wanted;
    }
    console().message("--offscreen draws both eyes side by side instead");
    return wanted.as(DisplayMode.SIDE_BY_SIDE);
  }

  /** Checks the options, and returns the input and output files. */
  private CommandFiles check(TrackerSpec tracker) throws IOException {
    if (duration != null && !(duration > 0)) {
      throw CommandFailure.usage("--duration must be a number of seconds above 0");
    }
    if (samples != null && (samples < 0 || samples > 16)) {
      throw CommandFailure.usage("--samples must be a whole number from 0 to 16");
    }
    records.check();
    display.check(offscreen, records.pictures().ofOperator());
    trackerFlags.check(tracker);
    CommandFiles files =
        new CommandFiles()
            .reads("the scene", scene.file())
            .reads("--path", path)
            .reads("--hmd", display.file());
    records.writes(files);
    if (tracker instanceof TrackerSpec.Replay replay) {
      HeadLogFiles.of(replay.file()).forEach(file -> files.reads("--tracker", file));
    }
    head.check(tracker, files);
    files.check();
    head.checkNew();
    GlAvailability.check().ifPresent(this::noDisplay);
    return files;
  }

  /**
   * @param begun called when the scene has been read
   */
  private RunResult show(RunSettings settings, RunOutput.Beginning begun, RunStop stop)
      throws IOException {
    try (LabStreams streams = streams();
        TimelineFile file = records.timeline().orElse(null)) {
      Consumer<TimelineEvent> written = file == null ? event -> {} : file;
      RunOutput output =
          new RunOutput(
              console(),
              written.andThen(streams::happened),
              streams.samples(),
              () -> {
                begun.begin();
                if (file != null) {
                  file.open();
                }
              });
      if (display.worn()) {
        return SceneRunner.inHeadset(settings, headset(settings), output, stop);
      }
      return offscreen
          ? SceneRunner.offscreen(settings, output, stop)
          : SceneRunner.inWindow(settings, output, stop);
    } catch (GlUnavailableException e) {
      noDisplay(e.getMessage());
      throw e;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw CommandFailure.environment("interrupted");
    }
  }

  private static HeadsetLink headset(RunSettings settings) throws HeadsetUnavailableException {
    return HeadsetLink.find(settings.display().presentation().headset().orElseThrow());
  }

  private LabStreams streams() throws IOException {
    Optional<LslLibrary> library = lsl.library(false);
    return library.isEmpty()
        ? LabStreams.none()
        : LabStreams.sending(
            library.get(),
            Map.of("scene", String.valueOf(scene.file().getFileName())),
            (event, more) -> console().message(String.valueOf(more.get("text"))));
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
