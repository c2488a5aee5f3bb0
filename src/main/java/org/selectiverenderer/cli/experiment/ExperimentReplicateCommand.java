package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.replication.Replication;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "replicate",
    description = {
      "Makes the whole study of the thesis anew: the study with its scene, memory lists and plan,"
          + " sessions of simulated participants with the means that the thesis prints, their answers"
          + " and the analysis.",
      "DIR/index.html has the thesis's Tables 3 to 11 and Figs 92 to 98 beside what comes out."
    },
    footer = {
      "  ./selective-renderer experiment replicate replication",
      "  ./selective-renderer experiment replicate large --participants 540 --seed 7"
    })
final class ExperimentReplicateCommand extends CliCommand {
  private static final int LEAST = 9;
  private static final int MOST = 3000;

  /** The largest seed that a study file may have. */
  private static final long MOST_SEED = 1L << 53;

  @Parameters(
      paramLabel = "DIR",
      description = "folder for all of it; it must not exist, or be empty")
  private Path folder = Path.of("");

  @Option(
      names = "--participants",
      paramLabel = "N",
      defaultValue = "54",
      description = "number of simulated participants, 9 to 3000 (default: ${DEFAULT-VALUE})")
  private int participants;

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "2009",
      description =
          "seed of the plan and of the participants; the same seed gives the same answers"
              + " (default: ${DEFAULT-VALUE})")
  private long seed;

  @Option(
      names = "--scene",
      paramLabel = "SCENE",
      description =
          "scene of the study, with practice.x3d beside it (default: the apartment, as for"
              + " experiment new)")
  private @Nullable Path scene;

  @Mixin private ReportDateOption date = new ReportDateOption();

  ExperimentReplicateCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    if (participants < LEAST || participants > MOST) {
      throw CommandException.usage(
          "--participants must be a whole number from %d to %d".formatted(LEAST, MOST));
    }
    if (seed < 0 || seed > MOST_SEED) {
      throw CommandException.usage("--seed must be a whole number from 0 to " + MOST_SEED);
    }
    Path shown = scene == null ? ExperimentNewCommand.usual() : scene;
    for (Path needed : List.of(shown, shown.resolveSibling("practice.x3d"))) {
      if (!Files.isRegularFile(needed)) {
        throw CommandException.usage(
            "there is no scene %s; %s"
                .formatted(
                    needed,
                    scene == null
                        ? ExperimentNewCommand.GET_EXAMPLES
                        : "name one with --scene, with practice.x3d beside it"));
      }
    }
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Replication replication = new Replication(folder, shown, participants, seed);
    Optional<List<String>> found =
        replication.run(
            date.provenance(), problems, line -> console().message("replicate: " + line));
    if (found.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    NewStudyTrust.remember(replication.study(), console());
    found.get().forEach(line -> console().out().println(line));
    console().message("page: " + folder.resolve(Replication.PAGE));
    return ExitStatus.of(problems);
  }
}
