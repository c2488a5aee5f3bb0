package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.rehearsal.StudyCheck;
import org.selectiverenderer.app.rehearsal.StudyCheckReport;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.cli.option.FormatOption;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.command.trust.TrustPrompt;
import org.selectiverenderer.study.session.LoadedStudy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "check",
    description = {
      "Checks everything that a session of a study needs, before anybody comes: files, texts,"
          + " scenes with their Inlines, areas, viewpoints, objects, display, disk, and orders.",
      "It also tells the balance of the plan, the polygons, and how long a session takes."
    },
    footer = {
      "  ./selective-renderer experiment check mystudy",
      "  ./selective-renderer experiment check mystudy --output check.html"
    })
final class ExperimentCheckCommand extends CliCommand {
  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  @Mixin private FormatOption format = new FormatOption();

  @Option(
      names = "--output",
      paramLabel = "F.html",
      description = "writes the report, with a picture of the plan, as a page")
  private @Nullable Path output;

  ExperimentCheckCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    OutputFile.check("--output", output, ".html");
    new CommandFileCheck().writes("--output", output).check();
    ProblemCollector problems =
        new ProblemCollector(format.json() ? problem -> {} : console()::problem);
    Optional<List<LoadedStudy>> material =
        study.readForSession(
            Optional.empty(), trust, TrustPrompt.onTerminal(console()), console(), problems);
    if (material.isEmpty()) {
      if (format.json()) {
        console().out().print(StudyCheckReport.json(problems.list()));
      }
      if (output != null) {
        OutputFile.writePrivate(output, StudyCheckReport.html(problems.list()));
      }
      return ExitStatus.PROBLEMS;
    }
    StudyCheck check = StudyCheck.of(material.get(), problems);
    List<Problem> found = problems.list();
    console()
        .out()
        .print(
            format.json()
                ? StudyCheckReport.json(check, found)
                : StudyCheckReport.text(check, found));
    console().out().flush();
    if (output != null) {
      OutputFile.writePrivate(output, StudyCheckReport.html(check, found));
    }
    return ExitStatus.of(problems);
  }
}
