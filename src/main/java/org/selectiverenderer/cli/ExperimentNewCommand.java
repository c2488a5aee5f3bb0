package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.experiment.study.StudyTemplate;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "new",
    description = {
      "Writes a new study: study.json with comments, the items of its questionnaires, and a pilot"
          + " study beside it.",
      "It is the thesis's: practice, then kitchen, lounge and office for 45 s each, rendered high,"
          + " high-low or selective, 54 participants."
    },
    footer = {
      "  ./selective-renderer experiment new mystudy",
      "  ./selective-renderer experiment run mystudy/study.json --participant 001"
    })
final class ExperimentNewCommand extends CliCommand {
  @Parameters(paramLabel = "DIR", description = "the study's folder; made if it is not there")
  private Path folder = Path.of("");

  @Option(
      names = "--scene",
      defaultValue = "scenes/apartment.x3d",
      paramLabel = "SCENE",
      description = "that the study shows, with practice.x3d beside it (default: ${DEFAULT-VALUE})")
  private Path scene = Path.of("");

  ExperimentNewCommand(Console console) {
    super(console);
  }

  @Override
  ExitStatus run() throws IOException {
    for (Path needed : List.of(scene, scene.resolveSibling("practice.x3d"))) {
      if (!Files.isRegularFile(needed)) {
        throw CommandFailure.usage("there is no scene " + needed + ": give --scene");
      }
    }
    console().message("study: " + StudyTemplate.write(folder, scene));
    return ExitStatus.DONE;
  }
}
