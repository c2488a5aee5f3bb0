package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.sai.SaiRunner;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.cli.option.ConditionOptions;
import org.selectiverenderer.cli.option.QualityOptions;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.LibraryProperties;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;
import org.web3d.x3d.sai.X3DException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/**
 * Runs other browsers, see docs/xj3d.md; hidden in the help, since {@code run} offers more with the
 * embedded browser.
 */
@Command(
    name = "sai",
    hidden = true,
    description = {
      "Runs the controller in the browser that the Scene Access Interface finds, "
          + "such as Xj3D, and prints what happens.",
      "Ends when the browser's window is closed; without a window, at the end of "
          + "standard input."
    },
    footer = "  ./selective-renderer sai scenes/trashcan.x3d")
public final class SaiCommand extends CliCommand {
  @Parameters(paramLabel = "SCENE", description = "X3D scene")
  private Path scene = Path.of("");

  @Mixin private ConditionOptions condition = new ConditionOptions();

  @Mixin private QualityOptions qualities = new QualityOptions();

  @Option(
      names = "--path",
      paramLabel = "P.csv",
      description = "recorded path that a Viewpoint is moved along; the run ends with it")
  private @Nullable Path path;

  @Option(
      names = "--timeline",
      paramLabel = "F.jsonl",
      description = "file for the time line, as JSON lines; with --path it counts from its start")
  private @Nullable Path timeline;

  @Option(
      names = "--sai-parameter",
      paramLabel = "KEY=VALUE",
      description = {
        "parameter for the browser; TRUE and FALSE are truth values. Can be given several times.",
        "Xj3D_DisableAudio=TRUE is given unless another value is"
      })
  private Map<String, String> parameters = Map.of();

  @Option(
      names = "--observe",
      description = {
        "leave the scene to itself, such as an exported one with a Script of its own, and only",
        "print what happens"
      })
  private boolean observe;

  private final InputStream in;

  /**
   * @param in standard input; without a window, the run ends at its end
   */
  public SaiCommand(Console console, InputStream in) {
    super(console);
    this.in = in;
  }

  @Override
  public ExitStatus run() throws IOException {
    if (!Files.isRegularFile(scene)) {
      throw new IOException(scene + ": the file does not exist");
    }
    new CommandFileCheck()
        .reads("the scene", scene)
        .reads("--path", path)
        .writes("--timeline", timeline)
        .check();
    ProblemCollector pathProblems = new ProblemCollector(console()::problem);
    Optional<CameraPath> walked =
        path == null ? Optional.empty() : CameraPathReader.read(path, pathProblems);
    if (path != null && walked.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    LibraryProperties.swingFirst(); // The browser may be a Swing panel.
    ExitStatus status = pathProblems.any() ? ExitStatus.PROBLEMS : ExitStatus.DONE;
    if (timeline == null) {
      return show(walked, event -> {}, status);
    }
    try (TimelineFileWriter file = new TimelineFileWriter(timeline)) {
      file.open();
      return show(walked, file, status);
    }
  }

  private ExitStatus show(
      Optional<CameraPath> walked, Consumer<TimelineEvent> events, ExitStatus status)
      throws IOException {
    CountDownLatch closed = new CountDownLatch(1);
    String url = scene.toAbsolutePath().normalize().toUri().toString();
    try (SaiRunner runner = SaiRunner.open(url, settings(), parameters(), this::print, events)) {
      boolean window = runner.showWindow(closed::countDown);
      if (walked.isPresent()) {
        runner.follow(walked.get(), closed);
      } else if (window) {
        closed.await();
      } else {
        in.transferTo(OutputStream.nullOutputStream());
      }
      return status;
    } catch (X3DException e) {
      throw new IOException(scene + ": " + e.getMessage(), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return ExitStatus.DONE;
    }
  }

  private SelectiveController.Settings settings() {
    SelectiveController.Settings settings = qualities.with(condition.settings());
    if (!observe) {
      return settings;
    }
    if (!settings.equals(SelectiveController.Settings.SELECTIVE)) {
      throw CommandException.usage(
          "--observe leaves the choices to the scene; leave out --condition and --seed");
    }
    return SelectiveController.Settings.OBSERVING;
  }

  private Map<String, Object> parameters() {
    Map<String, Object> typed = new HashMap<>();
    parameters.forEach(
        (key, value) ->
            typed.put(
                key,
                value.equalsIgnoreCase("true") || value.equalsIgnoreCase("false")
                    ? Boolean.valueOf(value)
                    : value));
    return typed;
  }

  private void print(String line) {
    console().line(line);
    console().out().flush();
  }
}
