package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.export.StudyExport;
import org.selectiverenderer.study.session.LoadedStudy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "export",
    description = {
      "Writes a study as tables for R, JASP and pandas, one for each level of analysis: "
          + "participants, sessions, exposures, gaze, events, responses, ratings, answers, scores, trials; "
          + "a codebook of every column, scripts that read them, and one that analyses them.",
      "Responses, ratings, answers and scores are those that experiment collect takes; the other "
          + "tables have all sessions. Files of an earlier export are replaced."
    },
    footer = {
      "  ./selective-renderer experiment export mystudy --output mystudy-tables",
      "  Rscript -e 'setwd(\"mystudy-tables\"); source(\"tables.R\"); str(read_tables())'"
    })
final class ExperimentExportCommand extends CliCommand {
  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  @Option(
      names = "--output",
      required = true,
      paramLabel = "DIR",
      description = "folder of the tables; made if it is not there")
  private Path output = Path.of("");

  @Mixin private StudyTablesOptions tables = new StudyTablesOptions();

  ExperimentExportCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<LoadedStudy> found = study.read(trust, console(), problems);
    if (found.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    LoadedStudy material = found.get();
    if (Files.exists(output) && Files.isSameFile(output, material.study().folder())) {
      throw CommandException.usage(
          "--output "
              + output
              + ": is the study's folder, in which nothing is written; name another folder");
    }
    Optional<List<DataTable>> all = tables.read(material, problems);
    if (all.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    StudyExport written =
        StudyExport.write(all.get(), StudyTablesOptions.scripts(all.get()), output);
    console().message("tables: %s in %s".formatted(String.join(", ", written.files()), output));
    return ExitStatus.of(problems);
  }
}
