package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.threshold.SimulatedTrialPresenter;
import org.selectiverenderer.app.threshold.ThresholdStimuli;
import org.selectiverenderer.app.threshold.TrialPresenter;
import org.selectiverenderer.app.threshold.WindowTrialPresenter;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.trust.PermissionRequests;
import org.selectiverenderer.cli.option.FormatOption;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.LibraryProperties;
import org.selectiverenderer.command.ProgramInvocation;
import org.selectiverenderer.command.ProgramVersion;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.command.trust.TrustPrompt;
import org.selectiverenderer.render.context.GlAvailability;
import org.selectiverenderer.render.context.GlUnavailableException;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.session.SessionFolder;
import org.selectiverenderer.study.threshold.ThresholdReport;
import org.selectiverenderer.study.threshold.ThresholdResults;
import org.selectiverenderer.study.threshold.ThresholdSession;
import org.selectiverenderer.study.threshold.ThresholdStudy;
import org.selectiverenderer.study.threshold.ThresholdStudyReader;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "threshold",
    description = {
      "Runs the threshold pilot (thesis 4.2.1): with how few polygons is an object still what it"
          + " was?",
      "A participant compares or names pictures of an object's versions; what comes next depends on"
          + " the answers. Each answer is written to threshold/sub-ID beside the settings at once."
          + " --results prints the thresholds of all participants and the commands that make such"
          + " versions."
    },
    footer = {
      "  ./selective-renderer experiment threshold mystudy/pilot --participant 001",
      "  ./selective-renderer experiment threshold mystudy/pilot --results"
    })
final class ExperimentThresholdCommand extends CliCommand {
  private static final String FILE = "threshold.json";

  @Parameters(
      paramLabel = "PILOT.json",
      description = "settings of the pilot, or the folder that contains threshold.json")
  private Path file = Path.of("");

  @Mixin private TrustOption trust = new TrustOption();

  @Option(
      names = "--participant",
      paramLabel = "ID",
      description = "id of the participant, letters and digits")
  private @Nullable String participant;

  @Option(names = "--resume", description = "continues a participant's pilot that was cut off")
  private boolean resume;

  @Option(
      names = "--unattended",
      description = "runs with a simulated observer, for tests; this is recorded")
  private boolean unattended;

  @Option(names = "--results", description = "prints the results of all participants")
  private boolean results;

  @Option(
      names = "--commands",
      paramLabel = "F",
      description = "with --results: writes the commands that make the versions to a file as well")
  private @Nullable Path commands;

  @Mixin private FormatOption format = new FormatOption();

  ExperimentThresholdCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    check();
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<ThresholdStudy> found =
        ThresholdStudyReader.read(Files.isDirectory(file) ? file.resolve(FILE) : file, problems);
    if (found.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    ThresholdStudy study = found.get();
    PermissionRequests all = study.permissions();
    if (results) {
      return results(study, problems); // reads answers, and neither the scene nor messages
    }
    trust.require(
        study.file(),
        all,
        unattended ? TrustPrompt.NOBODY : TrustPrompt.onTerminal(console()).or(TrustWindow::ask),
        console());
    return session(study, problems);
  }

  private void check() {
    if (results && (participant != null || resume || unattended)) {
      throw CommandException.usage(
          "--results prints the results of all participants; leave out --participant, --resume"
              + " and --unattended");
    }
    if (commands != null && !results) {
      throw CommandException.usage("--commands needs --results");
    }
    if (!results && participant == null) {
      throw CommandException.usage("--participant ID or --results is needed");
    }
    if (participant != null && !participant.matches(SessionFolder.LABEL)) {
      throw CommandException.usage("--participant must consist of letters and digits");
    }
  }

  private ExitStatus results(ThresholdStudy study, ProblemCollector problems) throws IOException {
    ThresholdResults thresholds = ThresholdResults.read(study, problems);
    Path here = Path.of("").toAbsolutePath();
    Path scene = study.scene().toAbsolutePath();
    String name =
        (scene.getRoot() != null && scene.getRoot().equals(here.getRoot())
                ? here.relativize(scene)
                : scene)
            .toString()
            .replace('\\', '/');
    console()
        .out()
        .print(
            format.json()
                ? ThresholdReport.json(thresholds)
                : ThresholdReport.text(thresholds, ProgramInvocation.name(), name));
    if (commands != null) {
      OutputFile.write(commands, thresholds.commands(ProgramInvocation.name(), name));
    }
    return ExitStatus.of(problems);
  }

  private ExitStatus session(ThresholdStudy study, ProblemCollector problems) throws IOException {
    GlAvailability.check()
        .ifPresent(
            reason -> {
              throw CommandException.environment(reason + "; the pilot needs pictures");
            });
    if (!unattended) {
      LibraryProperties.allowSwing();
    }
    Path settings = study.file().toAbsolutePath().getParent();
    Optional<ParticipantMessages> wording =
        ParticipantMessages.of(
            study.language(), settings == null ? Path.of("") : settings, problems);
    Optional<ThresholdStimuli> pictures =
        wording.isEmpty()
            ? Optional.empty()
            : ThresholdStimuli.of(study, console()::message, problems);
    if (wording.isEmpty() || pictures.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    String id = String.valueOf(participant);
    ThresholdSession.Opening opening =
        new ThresholdSession.Opening(
            id,
            pictures.get().checksum(),
            new ProgramVersion().getVersion()[0],
            unattended,
            resume);
    try (TrialPresenter dialogue =
            unattended
                ? new SimulatedTrialPresenter(study, pictures.get(), id)
                : new WindowTrialPresenter(study, pictures.get(), wording.get());
        ThresholdSession session =
            ThresholdSession.open(study, pictures.get().ladders(), opening, problems)) {
      boolean through = TrialPresenter.run(session, dialogue);
      console()
          .message(
              through
                  ? "the pilot of participant "
                      + id
                      + " is finished after "
                      + session.pilot().trials()
                      + " trials"
                  : "the pilot was ended; --resume continues it");
      return through ? ExitStatus.of(problems) : ExitStatus.PROBLEMS;
    } catch (GlUnavailableException e) {
      throw CommandException.environment(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw CommandException.environment("interrupted; --resume continues the pilot");
    }
  }
}
