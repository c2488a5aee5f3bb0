package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.paper.DataEntryTemplate;
import org.selectiverenderer.study.questionnaire.paper.PaperQuestionnaireHtml;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.ParticipantsFile;
import org.selectiverenderer.study.session.SessionFolder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "paper",
    description = {
      "Writes a participant's questionnaires as a page to print, and as a table to type the answers"
          + " into.",
      "The questions come in the order in which the participant would see them on the screen."
    },
    footer = {
      "  ./selective-renderer experiment paper mystudy --participant 001 \\",
      "      --output 001.html --csv 001.csv"
    })
final class ExperimentPaperCommand extends CliCommand {
  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  @Option(
      names = "--participant",
      required = true,
      paramLabel = "ID",
      description = "id of the participant, letters and digits")
  private String participant = "";

  @Option(
      names = "--condition",
      paramLabel = "NAME",
      description =
          "condition of the participant, for the table (default: the assigned one, "
              + "else left empty)")
  private @Nullable String condition;

  @Mixin private LanguageOption language = new LanguageOption();

  @Option(
      names = "--output",
      paramLabel = "F.html",
      description = "file of the page to print (default: standard output)")
  private @Nullable Path output;

  @Option(
      names = "--csv",
      paramLabel = "F.csv",
      description = "file of the table to type the answers into")
  private @Nullable Path csv;

  ExperimentPaperCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    if (!participant.matches(SessionFolder.LABEL)) {
      throw CommandException.usage("--participant must consist of letters and digits");
    }
    OutputFile.check("--output", output, ".html");
    OutputFile.check("--csv", csv, ".csv");
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<LoadedStudy> material = study.read(language.typed(), trust, console(), problems);
    if (material.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    if (condition != null && material.get().study().design().group(condition).isEmpty()) {
      throw CommandException.usage("the study has no group " + condition + " for --condition");
    }
    List<Questionnaire> asked = new ArrayList<>();
    if (material.get().study().questionnaires().form().isPresent()) {
      asked.add(material.get().form());
    }
    asked.addAll(material.get().questionnaires(participant));
    String page = PaperQuestionnaireHtml.html(asked, material.get().wording(), participant);
    if (output != null) {
      OutputFile.write(output, page);
    } else {
      console().out().print(page);
    }
    if (csv != null) {
      OutputFile.writeOnce(
          "--csv",
          csv,
          DataEntryTemplate.text(
              asked, material.get().wording(), participant, group(material.get())));
    }
    return ExitStatus.of(problems);
  }

  private String group(LoadedStudy material) throws IOException {
    if (condition != null) {
      return condition;
    }
    return new ParticipantsFile(material.study())
        .of(participant)
        .map(ParticipantsFile.Assigned::group)
        .orElse("");
  }
}
