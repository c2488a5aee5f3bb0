package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.statistics.script.RScriptGenerator;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.dataset.RecordedStudy;
import org.selectiverenderer.study.export.StudyExport;
import org.selectiverenderer.study.session.CollectedAnswers;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PaperAnswers;
import org.selectiverenderer.study.site.SiteTables;
import org.selectiverenderer.study.site.StudySites;
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

  @Mixin private PaperTablesOption paper = new PaperTablesOption();

  @Mixin private SitesOption sites = new SitesOption();

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
    Optional<List<DataTable>> tables = tables(material, problems);
    if (tables.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    StudyExport written = StudyExport.write(tables.get(), scripts(tables.get()), output);
    console().message("tables: %s in %s".formatted(String.join(", ", written.files()), output));
    return ExitStatus.of(problems);
  }

  private Optional<List<DataTable>> tables(LoadedStudy material, ProblemCollector problems)
      throws IOException {
    if (sites.any()) {
      if (!paper.tables().isEmpty()) {
        throw CommandException.usage(
            "--paper and --from: answers on paper are exported at their site, without --from");
      }
      Optional<StudySites> all = sites.read(material, problems);
      return all.isEmpty() ? Optional.empty() : Optional.of(SiteTables.export(all.get(), problems));
    }
    CollectedAnswers answers =
        CollectedAnswers.of(
            material,
            OptionalInt.empty(),
            PaperAnswers.read(material, paper.tables(), problems),
            problems);
    return Optional.of(
        StudyExport.tables(
            RecordedStudy.read(material, problems), StudyExport.Answers.of(answers), problems));
  }

  /** Returns the R script that analyses recognition answers, if there are any. */
  private static Map<String, String> scripts(List<DataTable> tables) {
    return tables.stream()
            .anyMatch(
                table ->
                    (table.name() + ".csv").equals(StudyExport.RESPONSES)
                        && !table.rows().isEmpty())
        ? Map.of(RScriptGenerator.NAME, RScriptGenerator.analysis(StudyExport.RESPONSES))
        : Map.of();
  }
}
