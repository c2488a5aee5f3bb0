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
import org.selectiverenderer.app.head.ReplayLogFormat;
import org.selectiverenderer.app.headset.HeadsetConnection;
import org.selectiverenderer.app.run.RunCancellation;
import org.selectiverenderer.app.run.RunResult;
import org.selectiverenderer.app.run.SceneRunner;
import org.selectiverenderer.app.settings.DisplaySettings;
import org.selectiverenderer.app.settings.MotionSettings;
import org.selectiverenderer.app.settings.PathPlaybackSettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.app.stream.LslStreams;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.MouseButtonMapping;
import org.selectiverenderer.base.platform.ParentProcessWatcher;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.cli.option.BudgetOption;
import org.selectiverenderer.cli.option.ConditionOptions;
import org.selectiverenderer.cli.option.LslOptions;
import org.selectiverenderer.cli.option.QualityOptions;
import org.selectiverenderer.cli.option.SwitchOption;
import org.selectiverenderer.cli.option.TrackerFilterOptions;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.option.AccessOptions;
import org.selectiverenderer.command.option.SceneArgument;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.InterruptHandler;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.lsl.LslLibrary;
import org.selectiverenderer.openxr.HeadsetUnavailableException;
import org.selectiverenderer.render.context.GlAvailability;
import org.selectiverenderer.render.context.GlUnavailableException;
import org.selectiverenderer.study.headlog.HeadLogFiles;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;
import org.selectiverenderer.walkthrough.timeline.TimelineText;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
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

  @Mixin private SwitchOption change = new SwitchOption();

  @Mixin private QualityOptions qualities = new QualityOptions();

  @Mixin private BudgetOption budget = new BudgetOption();

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

  @Mixin private HeadTrackerOptions head = new HeadTrackerOptions();

  @Mixin private TrackerFilterOptions trackerFlags = new TrackerFilterOptions();

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

  @Mixin private RunOutputOptions records = new RunOutputOptions();

  public RunCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    // A run that the enricher started ends with it, as by Ctrl-C, with complete files.
    ParentProcessWatcher.whenItEnds(() -> System.exit(ExitStatus.FAILURE.code()));
    if (view.listed()) {
      return ViewOptions.list(scene.file(), console());
    }
    budget.in(qualities.with(condition.settings()), true);
    TrackerSpec tracker = head.tracker(display.worn());
    CommandFileCheck files = check(tracker);
    ProblemCollector pathProblems = new ProblemCollector(console()::problem);
    boolean session =
        tracker instanceof TrackerSpec.Replay replay && ReplayLogFormat.hasPositions(replay.file());
    Path walkedFile = session ? ((TrackerSpec.Replay) tracker).file() : path;
    Optional<CameraPath> walked =
        walkedFile == null ? Optional.empty() : CameraPathReader.read(walkedFile, pathProblems);
    if (walkedFile != null && walked.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    walked.ifPresent(known -> checkPath(known, tracker, session));
    TrackerSettings tracking =
        head.tracking(session ? new TrackerSpec.None() : tracker, trackerFlags.options());
    Optional<DisplayConfiguration> presentation = display.presentation(pathProblems);
    if (presentation.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    ContentAccessPolicy allowed = access.access();
    RunSettings settings =
        new RunSettings(
                scene.file(),
                budget.in(qualities.with(condition.settings()).with(change.transition()), true))
            .allowing(allowed)
            .muted(mute)
            .with(motion(walked, session))
            .with(display(presentation.get()))
            .with(tracking, head.recorded())
            .lasting(duration == null ? OptionalDouble.empty() : OptionalDouble.of(duration));
    RunCancellation stop = new RunCancellation();
    AtomicReference<ExitStatus> ended = new AtomicReference<>(ExitStatus.DONE);
    InterruptHandler.stops(
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
        MouseButtonMapping.valueOf(mouse.name().toUpperCase(Locale.ROOT)),
        walked.map(
            path ->
                session
                    ? PathPlaybackSettings.rows(path)
                    : PathPlaybackSettings.at(PathPlaybackSettings.RATE, path)),
        view.viewpoint(),
        view.collisions());
  }

  private DisplaySettings display(DisplayConfiguration wanted) {
    DisplaySettings suited =
        DisplaySettings.of(shown(wanted))
            .samples(samples == null ? OptionalInt.empty() : OptionalInt.of(samples))
            .style(view.style())
            .operator(display.operator())
            .saved(records.pictures().ofScene());
    return size == null ? suited : suited.sized(size.width(), size.height());
  }

  private void checkPath(CameraPath walked, TrackerSpec tracker, boolean session) {
    FrameCountCheck.check(walked, PathPlaybackSettings.RATE);
    if (session && path != null) {
      throw CommandException.usage(
          "--path cannot be combined with a replayed head log, which has positions of "
              + "its own; leave --path out");
    }
    if (session && head.placed()) {
      throw CommandException.usage(
          "--tracker-position cannot be combined with a replayed head log, whose positions are "
              + "always used; leave it out");
    }
    boolean turned = walked.at(walked.start()).orientation().isPresent();
    if (!session && turned && !(tracker instanceof TrackerSpec.None)) {
      throw CommandException.usage(
          "--tracker and --display openxr cannot be combined with a path that turns the view; "
              + "leave yaw, pitch and roll out of the path");
    }
  }

  /**
   * Returns the presentation: off-screen rendering has neither monitors nor quad buffers, so it
   * shows both eyes side by side.
   */
  private DisplayConfiguration shown(DisplayConfiguration wanted) {
    boolean windows = wanted.mode() == DisplayMode.DUAL || wanted.mode() == DisplayMode.QUAD;
    if (!offscreen || !windows) {
      return wanted;
    }
    console().message("--offscreen draws both eyes side by side instead");
    return wanted.as(DisplayMode.SIDE_BY_SIDE);
  }

  /** Checks the options, and returns the input and output files. */
  private CommandFileCheck check(TrackerSpec tracker) throws IOException {
    if (duration != null && !(duration > 0)) {
      throw CommandException.usage("--duration must be a number of seconds above 0");
    }
    if (samples != null && (samples < 0 || samples > 16)) {
      throw CommandException.usage("--samples must be a whole number from 0 to 16");
    }
    records.check();
    display.check(offscreen, records.pictures().ofOperator());
    trackerFlags.check(tracker);
    CommandFileCheck files =
        new CommandFileCheck()
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
  private RunResult show(
      RunSettings settings, ConsoleRunListener.Beginning begun, RunCancellation stop)
      throws IOException {
    try (LslStreams streams = streams();
        TimelineFileWriter file = records.timeline().orElse(null)) {
      Consumer<TimelineEvent> written = file == null ? this::waiting : file;
      ConsoleRunListener output =
          new ConsoleRunListener(
              console(),
              written.andThen(streams::happened),
              streams.samples(),
              file != null || streams.samples().isPresent(),
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
      throw CommandException.environment("interrupted");
    }
  }

  /** Tells what waited in vain, to somebody who has no time line. */
  private void waiting(TimelineEvent event) {
    if (event instanceof TimelineEvent.End end && !end.waiting().isEmpty()) {
      console().message(new TimelineText().line(end).strip());
    }
  }

  private static HeadsetConnection headset(RunSettings settings)
      throws HeadsetUnavailableException {
    return HeadsetConnection.find(settings.display().presentation().headset().orElseThrow());
  }

  private LslStreams streams() throws IOException {
    Optional<LslLibrary> library = lsl.library(false);
    return library.isEmpty()
        ? LslStreams.none()
        : LslStreams.sending(
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
    throw CommandException.environment(reason + "; " + advice);
  }
}
