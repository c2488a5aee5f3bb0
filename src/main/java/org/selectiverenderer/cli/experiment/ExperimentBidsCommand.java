package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.ProgramVersion;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.study.bids.BidsDataset;
import org.selectiverenderer.study.dataset.RecordedStudy;
import org.selectiverenderer.study.session.LoadedStudy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "bids",
    description = {
      "Writes a study as a BIDS dataset: motion, events, answers, participants, each with what its "
          + "columns mean. The study's folder stays as it is.",
      "All sessions are in it, unfinished ones too; sessions.tsv says how each ended."
    },
    footer = {
      "  ./selective-renderer experiment bids mystudy --output mystudy-bids \\",
      "      --author \"A. Zotos\"",
      "  bids-validator-deno mystudy-bids"
    })
final class ExperimentBidsCommand extends CliCommand {
  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  @Option(
      names = "--output",
      required = true,
      paramLabel = "DIR",
      description = "folder of the dataset, a new or an empty one")
  private Path output = Path.of("");

  @Option(
      names = "--author",
      paramLabel = "NAME",
      description = "author of the study, named in the dataset; can be repeated")
  private List<String> authors = List.of();

  ExperimentBidsCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<LoadedStudy> material = study.read(trust, console(), problems);
    if (material.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    BidsDataset written =
        BidsDataset.write(
            RecordedStudy.read(material.get(), problems),
            new BidsDataset.Origin(ProgramVersion.PROGRAM, ProgramVersion.number(), authors),
            output,
            problems);
    console()
        .message(
            "BIDS dataset: %s, %s in %s"
                .formatted(
                    Pluralizer.of(written.sessions(), "session"),
                    Pluralizer.of(written.files(), "file"),
                    output));
    return ExitStatus.of(problems);
  }
}
