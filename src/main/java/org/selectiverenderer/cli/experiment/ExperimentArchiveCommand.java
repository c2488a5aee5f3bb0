package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.ProgramVersion;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.study.archive.ArchiveLicence;
import org.selectiverenderer.study.archive.ArchivePackage;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.session.LoadedStudy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "archive",
    description = {
      "Writes a study as an anonymised package for an archive, such as OSF or Zenodo: README, "
          + "licence, tables with their codebook, the study's files, checksums.",
      "Participants get ids by chance, which nothing keeps, and their times are moved. Personal "
          + "answers, notes, free texts, names of machines and places in the schedule are left out."
    },
    footer = {
      "  ./selective-renderer experiment archive mystudy --output mystudy.zip \\",
      "      --licence CC-BY-4.0 --author \"A. Zotos\"",
      "  unzip mystudy.zip -d look && cd look && sha256sum -c SHA256SUMS"
    })
final class ExperimentArchiveCommand extends CliCommand {
  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  @Option(
      names = "--output",
      required = true,
      paramLabel = "F.zip",
      description = "the package; an existing one is replaced")
  private Path output = Path.of("");

  @Option(
      names = "--licence",
      required = true,
      paramLabel = "ID",
      description =
          "licence of the data by its SPDX identifier: CC0-1.0, CC-BY-4.0, CC-BY-SA-4.0,"
              + " CC-BY-NC-4.0, CC-BY-NC-SA-4.0, ODC-By-1.0, ODbL-1.0 or PDDL-1.0")
  private String licence = "";

  @Option(
      names = "--author",
      paramLabel = "NAME",
      description = "author of the study, named in the README; can be repeated")
  private List<String> authors = List.of();

  @Option(
      names = "--free-texts",
      description =
          "takes answers in participants' own words, too; read them first: they may name people")
  private boolean freeTexts;

  @Mixin private StudyTablesOptions tables = new StudyTablesOptions();

  ExperimentArchiveCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    ArchiveLicence chosen =
        ArchiveLicence.of(licence)
            .orElseThrow(
                () ->
                    CommandException.usage(
                        "--licence %s: is none of %s"
                            .formatted(licence, String.join(", ", ArchiveLicence.ids()))));
    OutputFile.check("--output", output, ".zip");
    new CommandFileCheck().writes("--output", output).check();
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<LoadedStudy> material = study.read(trust, console(), problems);
    if (material.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    Optional<List<DataTable>> all = tables.read(material.get(), problems);
    if (all.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    ArchivePackage written =
        ArchivePackage.write(
            material.get(),
            all.get(),
            StudyTablesOptions.scripts(all.get()),
            new ArchivePackage.Origin(
                chosen, authors, ProgramVersion.PROGRAM + " " + ProgramVersion.number(), freeTexts),
            new SecureRandom(),
            output,
            problems);
    if (!written.outside().isEmpty()) {
      console()
          .message(
              "not in the package, since not in the study's folder: "
                  + String.join(", ", written.outside()));
    }
    console()
        .message(
            "package: %s, %s in %s; look at study/ and tables/participants.csv in it before you"
                    .formatted(
                        Pluralizer.of(written.participants(), "participant"),
                        Pluralizer.of(written.files(), "file"),
                        output)
                + " publish it");
    return ExitStatus.of(problems);
  }
}
