package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.run.RunResult;
import org.selectiverenderer.app.run.SceneRunner;
import org.selectiverenderer.app.settings.DisplaySettings;
import org.selectiverenderer.app.settings.MotionSettings;
import org.selectiverenderer.app.settings.PathPlaybackSettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.base.files.FileFinder;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.cli.batch.BatchOutputFormat;
import org.selectiverenderer.cli.batch.BatchRunner;
import org.selectiverenderer.cli.option.BudgetOption;
import org.selectiverenderer.cli.option.ConditionOptions;
import org.selectiverenderer.cli.option.FileArguments;
import org.selectiverenderer.cli.option.FormatOption;
import org.selectiverenderer.cli.option.QualityOptions;
import org.selectiverenderer.cli.option.ScenesArgument;
import org.selectiverenderer.cli.option.SwitchOption;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.option.AccessOptions;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.schema.SwitchTransition;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;
import org.selectiverenderer.walkthrough.timeline.TimelineJson;
import org.selectiverenderer.walkthrough.timeline.TimelineText;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "simulate",
    description = {
      "Walks a recorded path through a scene without a display and prints what happens.",
      "Processes several scenes in parallel, one on each processor."
    },
    footer = {
      "  ./selective-renderer simulate scenes/trashcan.x3d \\",
      "      --path scenes/paths/desk-visit.csv",
      "  ./selective-renderer simulate scenes/ --path scenes/paths/desk-visit.csv \\",
      "      --format json",
      "  ./selective-renderer simulate scenes/apartment.x3d \\",
      "      --path scenes/paths/apartment-tour.csv --chart polygons.svg"
    })
public final class SimulateCommand extends CliCommand {
  @Mixin private ScenesArgument scenes = new ScenesArgument();

  @Option(
      names = "--path",
      required = true,
      paramLabel = "P.csv",
      description =
          "recorded path: t,x,y,z or t,x,y,z,yaw,pitch,roll in seconds, metres and "
              + "degrees; linear in between")
  private Path path = Path.of("");

  @Option(
      names = "--rate",
      defaultValue = "60",
      paramLabel = "HZ",
      description = "frames per second of the path's time (default: ${DEFAULT-VALUE})")
  private double rate;

  @Mixin private AccessOptions access = new AccessOptions();

  @Option(
      names = "--viewpoint",
      paramLabel = "NAME",
      description = "viewpoint that is bound at first, by its DEF name or description")
  private @Nullable String viewpoint;

  @Mixin private ConditionOptions condition = new ConditionOptions();

  @Mixin private SwitchOption change = new SwitchOption();

  @Option(
      names = "--size",
      converter = PixelSize.Converter.class,
      paramLabel = "WxH",
      description =
          "size of the picture in which what the viewer would see is counted (default: 1024x768)")
  private @Nullable PixelSize size;

  @Mixin private QualityOptions qualities = new QualityOptions();

  @Mixin private BudgetOption budget = new BudgetOption();

  @Mixin private PolygonCurveOptions curve = new PolygonCurveOptions();

  @Mixin private FormatOption format = new FormatOption();

  private ContentAccessPolicy allowed = ContentAccessPolicy.none();

  public SimulateCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    if (!(rate > 0) || Double.isInfinite(rate)) {
      throw CommandException.usage("--rate must be a number of frames per second above 0");
    }
    budget.in(qualities.with(condition.settings()), false);
    ProblemCollector pathProblems = new ProblemCollector(console()::problem);
    Optional<CameraPath> walked = CameraPathReader.read(path, pathProblems);
    if (walked.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    FrameCountCheck.check(walked.get(), rate);
    allowed = access.access();
    FileArguments files = scenes.files();
    List<Path> all = files.one() ? List.of(files.file()) : files.files(FileFinder.SCENES);
    curve.check(all, path);
    ExitStatus status = simulate(files, all, walked.get());
    curve.write(all, path);
    return pathProblems.any() ? ExitStatus.PROBLEMS : status;
  }

  private Optional<String> viewpoint() {
    return Optional.ofNullable(viewpoint);
  }

  private DisplaySettings display() {
    return size == null
        ? DisplaySettings.WINDOW
        : DisplaySettings.WINDOW.sized(size.width(), size.height());
  }

  /** Returns whether the text tells what the viewer sees of changes; JSON always does. */
  private boolean sights() {
    return !change.transition().equals(SwitchTransition.AT_ONCE);
  }

  private ExitStatus simulate(FileArguments files, List<Path> all, CameraPath walked)
      throws IOException {
    if (!files.one()) {
      return new BatchRunner(
              console(), format.json() ? BatchOutputFormat.LINES : BatchOutputFormat.TEXTS)
          .run(
              all,
              (scene, own) -> {
                if (!format.json()) {
                  own.line(scene.toString());
                }
                return simulate(scene, walked, new TimelineJson(scene.toString()), own);
              });
    }
    try {
      return simulate(files.file(), walked, new TimelineJson(), console());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw CommandException.environment("interrupted");
    } finally {
      console().out().flush();
    }
  }

  private ExitStatus simulate(Path scene, CameraPath walked, TimelineJson json, Console to)
      throws IOException, InterruptedException {
    Function<TimelineEvent, String> text =
        format.json() ? json::line : new TimelineText(sights())::line;
    RunSettings settings =
        new RunSettings(
                scene,
                budget.in(qualities.with(condition.settings()).with(change.transition()), false))
            .allowing(allowed)
            .with(MotionSettings.following(PathPlaybackSettings.at(rate, walked)).from(viewpoint()))
            .with(display());
    RunResult result =
        SceneRunner.simulated(
            settings,
            new ConsoleRunListener(
                to,
                event -> to.line(text.apply(event)),
                Optional.empty(),
                format.json() || sights(),
                () -> {},
                (t, polygons) -> curve.stepped(scene, t, polygons)));
    return result.problems() ? ExitStatus.PROBLEMS : ExitStatus.DONE;
  }
}
