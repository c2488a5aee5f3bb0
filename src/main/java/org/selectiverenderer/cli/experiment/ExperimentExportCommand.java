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
import org.selectiverenderer.formats.json.JsonSettingsReader;
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
      "Writes a study as tables, as a page for web browsers, or as a study archive of JATOS.",
      "Tables (--output DIR) are for R, JASP and pandas, one for each level of analysis: "
          + "participants, sessions, exposures, gaze, events, responses, ratings, answers, scores, trials; "
          + "a codebook of every column, scripts that read them, and one that analyses them.",
      "Responses, ratings, answers and scores are those that experiment collect takes; the other "
          + "tables have all sessions. Files of an earlier export are replaced.",
      "--to web DIR writes a page that runs the study in a web browser, for any web server; what a"
          + " browser cannot do is refused with its line in the study file, and nothing is written.",
      "--to jatos FILE writes the same page as a study archive (.jzip), which JATOS imports."
    },
    footer = {
      "  ./selective-renderer experiment export mystudy --output mystudy-tables",
      "  Rscript -e 'setwd(\"mystudy-tables\"); source(\"tables.R\"); str(read_tables())'",
      "  ./selective-renderer experiment export mystudy --to web mystudy-page",
      "  ./selective-renderer experiment export mystudy --to jatos mystudy.jzip"
    })
final class ExperimentExportCommand extends CliCommand {
  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  /** Spellings are those of the option. */
  private enum Form {
    tables,
    web,
    jatos
  }

  @Parameters(
      paramLabel = "DIR|FILE",
      index = "1",
      arity = "0..1",
      description =
          "with --to web: folder to write, new or empty; with --to jatos: new file to write")
  private @Nullable Path page;

  @Option(
      names = "--to",
      paramLabel = "FORM",
      description =
          "what is written: tables (the default), web, a page that runs the study in a web browser,"
              + " or jatos, the page as a study archive of JATOS")
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
    if (form == Form.jatos) {
      if (page == null || output != null) {
        throw CommandException.usage("--to jatos: name the archive as FILE, without --output");
      }
      return writeArchive(page, problems);
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
    Optional<StudyFolder> made =
        languages.isPresent() ? made(languages.get(), problems) : Optional.empty();
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
    tell(
        folder.resolve("index.html") + ": the study for any web server",
        languages.orElseThrow().get(0).study());
    Study first = languages.orElseThrow().get(0).study();
    console().line("  the receiver of its data, with the address of your web server as --origin:");
    console().line("    " + receiver(first, folder));
    console()
        .line(
            "  set \"receiver\" in %s to its address; as it is, answers stay with the participant"
                .formatted(folder.resolve(StudyFolder.SETTINGS)));
    return ExitStatus.of(problems);
  }

  /** Returns the command that starts the receiver of a study's data. */
  private static String receiver(Study study, Path folder) {
    String name = String.valueOf(folder.toAbsolutePath().normalize().getFileName());
    return "tools/web-receiver/receive.py %s --study %s --slots %d --origin https://lab.example.org"
        .formatted(quoted(name + ".sqlite"), quoted(study.name()), study.participants());
  }

  /** Returns an argument as a POSIX shell reads it. */
  private static String quoted(String argument) {
    return argument.matches("[\\w./-]+") ? argument : "'" + argument.replace("'", "'\\''") + "'";
  }

  private ExitStatus writeArchive(Path file, ProblemCollector problems) throws IOException {
    if (Files.exists(file)) {
      throw CommandException.environment(
          "FILE %s: is there already; name a new file, such as study.jzip".formatted(file));
    }
    Optional<List<LoadedStudy>> languages = study.readToCopy(trust, console(), problems);
    Optional<StudyFolder> made =
        languages.isPresent() ? made(languages.get(), problems) : Optional.empty();
    if (made.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    PackageWriter.intoZip(made.get().jatosArchive(), file, share -> {}).keep();
    tell(file + ": the study for JATOS", languages.orElseThrow().get(0).study());
    return ExitStatus.of(problems);
  }

  private Optional<StudyFolder> made(List<LoadedStudy> languages, ProblemCollector problems)
      throws IOException {
    WebPage runner =
        WebPage.ofStudy()
            .orElseThrow(
                () ->
                    CommandException.environment(
                        ("--to %s: this program was built without the page; install Node.js 20 or"
                                + " later with npm, and build it again")
                            .formatted(form)));
    StudyFolder.Host host =
        form == Form.jatos ? StudyFolder.Host.JATOS : StudyFolder.Host.WEB_SERVER;
    return StudyFolder.of(runner, host, languages, problems);
  }

  private void tell(String what, Study first) throws IOException {
    console()
        .line(
            "%s, with places for %s"
                .formatted(what, Pluralizer.of(first.participants(), "participant")));
    if (first.scene().isPresent()) {
      console()
          .line(
              "  scenes are shown in one picture with the field of view of their viewpoints"
                  + (hasDisplay(first) ? "; the study's \"display\" is not used" : ""));
    }
  }

  /** Returns whether the study file sets a display, rather than leaving it as it is by default. */
  private static boolean hasDisplay(Study study) throws IOException {
    return new JsonSettingsReader("a study", "the study is not exported")
        .read(
            study.file(),
            new ProblemCollector(),
            keys -> {
              keys.names(); // all are known to the reader of the study
              return keys.value("display").isPresent();
            })
        .orElse(false);
  }
}
