package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.packaging.PackageWriter;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.export.WebPage;
import org.selectiverenderer.export.study.StudyFolder;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.export.StudyExport;
import org.selectiverenderer.study.session.LoadedStudy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "export",
    description = {
      "Writes a study as tables, or as a page for web browsers.",
      "Tables (--output DIR) are for R, JASP and pandas, one for each level of analysis: "
          + "participants, sessions, exposures, gaze, events, responses, ratings, answers, scores, trials; "
          + "a codebook of every column, scripts that read them, and one that analyses them.",
      "Responses, ratings, answers and scores are those that experiment collect takes; the other "
          + "tables have all sessions. Files of an earlier export are replaced.",
      "--to web DIR writes a page that runs the study in a web browser, for any web server; what a"
          + " browser cannot do is refused with its line in the study file, and nothing is written."
    },
    footer = {
      "  ./selective-renderer experiment export mystudy --output mystudy-tables",
      "  Rscript -e 'setwd(\"mystudy-tables\"); source(\"tables.R\"); str(read_tables())'",
      "  ./selective-renderer experiment export mystudy --to web mystudy-page"
    })
final class ExperimentExportCommand extends CliCommand {
  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  /** Spellings are those of the option. */
  private enum Form {
    tables,
    web
  }

  @Parameters(
      paramLabel = "DIR",
      index = "1",
      arity = "0..1",
      description = "with --to web: folder to write, new or empty")
  private @Nullable Path page;

  @Option(
      names = "--to",
      paramLabel = "FORM",
      description =
          "what is written: tables (the default), or web, a page that runs the study in a web browser")
  private Form form = Form.tables;

  @Option(
      names = "--output",
      paramLabel = "DIR",
      description = "folder of the tables; made if it is not there")
  private @Nullable Path output;

  @Mixin private StudyTablesOptions tables = new StudyTablesOptions();

  ExperimentExportCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    ProblemCollector problems = new ProblemCollector(console()::problem);
    if (form == Form.web) {
      if (page == null || output != null) {
        throw CommandException.usage("--to web: name the folder as DIR, without --output");
      }
      return writePage(page, problems);
    }
    if (output == null || page != null) {
      throw CommandException.usage("name the folder of the tables by --output DIR");
    }
    return writeTables(output, problems);
  }

  private ExitStatus writeTables(Path folder, ProblemCollector problems) throws IOException {
    Optional<LoadedStudy> found = study.read(trust, console(), problems);
    if (found.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    LoadedStudy material = found.get();
    if (Files.exists(folder) && Files.isSameFile(folder, material.study().folder())) {
      throw CommandException.usage(
          "--output "
              + folder
              + ": is the study's folder, in which nothing is written; name another folder");
    }
    Optional<List<DataTable>> all = tables.read(material, problems);
    if (all.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    StudyExport written =
        StudyExport.write(all.get(), StudyTablesOptions.scripts(all.get()), folder);
    console().message("tables: %s in %s".formatted(String.join(", ", written.files()), folder));
    return ExitStatus.of(problems);
  }

  private ExitStatus writePage(Path folder, ProblemCollector problems) throws IOException {
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw CommandException.environment("DIR %s: is a file, not a folder".formatted(folder));
    }
    Optional<List<LoadedStudy>> languages = study.readToCopy(trust, console(), problems);
    if (languages.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    WebPage runner =
        WebPage.ofStudy()
            .orElseThrow(
                () ->
                    CommandException.environment(
                        "--to web: this program was built without the page; install Node.js 20 or"
                            + " later with npm, and build it again"));
    Optional<StudyFolder> made = StudyFolder.of(runner, languages.get(), problems);
    if (made.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    List<Path> conflicts = PackageWriter.conflicts(made.get().files(), folder);
    if (!conflicts.isEmpty()) {
      throw CommandException.environment(
          "DIR %s: has another %s already; name a new or empty folder"
              .formatted(folder, folder.relativize(conflicts.get(0))));
    }
    PackageWriter.intoFolder(made.get().files(), folder, share -> {}).keep();
    Study first = languages.get().get(0).study();
    console()
        .line(
            "%s: the study for any web server, with places for %s"
                .formatted(
                    folder.resolve("index.html"),
                    Pluralizer.of(first.participants(), "participant")));
    if (first.scene().isPresent()) {
      console()
          .line(
              "  scenes are shown in one picture with the field of view of their viewpoints; the"
                  + " study's \"display\" is not used");
    }
    return ExitStatus.of(problems);
  }
}
