package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.app.Simulation;
import org.selectiverenderer.app.TimelineEvent;
import org.selectiverenderer.app.TimelineJson;
import org.selectiverenderer.app.TimelineText;
import org.selectiverenderer.app.Walkthrough;
import org.selectiverenderer.runtime.navigation.CameraPath;
import org.selectiverenderer.runtime.navigation.CameraPathReader;
import org.selectiverenderer.x3d.Problems;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "simulate",
    description =
        "Walks a recorded path through a scene without a display and prints what happens.",
    footer =
        "  ./selective-renderer simulate scenes/trashcan.x3d --path scenes/paths/desk-visit.csv")
final class SimulateCommand extends CliCommand {
  private enum Format {
    text,
    json
  }

  @Parameters(paramLabel = "SCENE", description = "the X3D scene (.x3d, .x3dz)")
  private Path scene = Path.of("");

  @Option(
      names = "--path",
      required = true,
      paramLabel = "P.csv",
      description = "t,x,y,z or t,x,y,z,yaw,pitch,roll: s, m, degrees; linear in between")
  private Path path = Path.of("");

  @Option(
      names = "--rate",
      defaultValue = "60",
      paramLabel = "HZ",
      description = "frames per second of the path's time (default: ${DEFAULT-VALUE})")
  private double rate;

  @Mixin private ConditionOptions condition = new ConditionOptions();

  @Option(
      names = "--format",
      defaultValue = "text",
      description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  SimulateCommand(Console console) {
    super(console);
  }

  @Override
  ExitStatus run() throws IOException {
    if (!(rate > 0) || Double.isInfinite(rate)) {
      throw CommandFailure.usage("--rate is a number of frames per second above 0");
    }
    Problems pathProblems = new Problems(console()::problem);
    Optional<CameraPath> walked = CameraPathReader.read(path, pathProblems);
    if (walked.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    Frames.check(walked.get(), rate);
    Function<TimelineEvent, String> text =
        format == Format.json ? new TimelineJson()::line : new TimelineText()::line;
    try (Walkthrough walk =
        Walkthrough.open(
            scene,
            condition.settings(),
            console()::problem,
            event -> console().out().println(text.apply(event)),
            console()::message)) {
      Simulation.run(walk, walked.get(), rate);
      return pathProblems.any() ? ExitStatus.PROBLEMS : ExitStatus.of(walk.problems());
    } finally {
      console().out().flush();
    }
  }
}
