package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.session.SessionDesk;
import org.selectiverenderer.app.session.SessionRunner;
import org.selectiverenderer.app.session.SessionShow;
import org.selectiverenderer.app.session.SimulatedDesk;
import org.selectiverenderer.app.session.WindowDesk;
import org.selectiverenderer.control.Condition;
import org.selectiverenderer.experiment.session.Session;
import org.selectiverenderer.experiment.session.SessionFolder;
import org.selectiverenderer.experiment.session.SessionOptions;
import org.selectiverenderer.experiment.session.StudyMaterial;
import org.selectiverenderer.experiment.study.Study;
import org.selectiverenderer.hmd.DisplayProfile;
import org.selectiverenderer.hmd.DisplayProfiles;
import org.selectiverenderer.hmd.EyeGeometry;
import org.selectiverenderer.hmd.Presentation;
import org.selectiverenderer.runtime.render.context.GlAvailability;
import org.selectiverenderer.runtime.render.context.GlUnavailableException;
import org.selectiverenderer.x3d.Problems;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "run",
    description = {
      "Runs a participant's session: form, practice, exposures, questionnaires.",
      "Everything is written to sub-ID/ses-NN in the study's folder as it happens. After a crash"
          + " --resume goes on from the last finished step."
    },
    footer = {
      "  ./selective-renderer experiment run mystudy/study.json --participant 001",
      "  ./selective-renderer experiment run mystudy/study.json --participant 001 --resume"
    })
final class ExperimentRunCommand extends CliCommand {
  @Mixin private StudyArgument study = new StudyArgument();

  @Option(
      names = "--participant",
      paramLabel = "ID",
      description = "letters and digits (default: the next free number)")
  private @Nullable String participant;

  @Option(
      names = "--session",
      defaultValue = "1",
      paramLabel = "N",
      description = "which session of the participant this is (default: ${DEFAULT-VALUE})")
  private int number = 1;

  @Option(names = "--resume", description = "goes on with a session that was cut off or aborted")
  private boolean resume;

  @Option(
      names = "--condition",
      converter = ConditionOptions.Converter.class,
      paramLabel = "NAME",
      description = "instead of the one whose turn it is; this is recorded")
  private @Nullable Condition condition;

  @Option(
      names = "--exposure",
      paramLabel = "S",
      description = "seconds of each exposure instead of the study's, for tests; this is recorded")
  private @Nullable Double exposure;

  @Option(
      names = "--unattended",
      description =
          "a simulated participant takes part, nobody is asked anything, for tests; this is recorded")
  private boolean unattended;

  @Option(
      names = "--operator",
      negatable = true,
      description =
          "a window for the experimenter with what the participant sees (default: unless"
              + " --unattended)")
  private @Nullable Boolean operator;

  @Mixin private TrackerFlags trackerFlags = new TrackerFlags();

  ExperimentRunCommand(Console console) {
    super(console);
  }

  @Override
  ExitStatus run() throws IOException {
    check();
    Problems problems = new Problems(console()::problem);
    Optional<StudyMaterial> found = study.read(problems);
    if (found.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    StudyMaterial material = found.get();
    if (condition != null && !material.study().conditions().contains(condition)) {
      throw CommandFailure.usage(
          "the study has no condition " + condition.spelling() + " for --condition");
    }
    Optional<Presentation> presentation = presentation(material.study(), problems);
    if (presentation.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    try (RunOutput output = RunOutput.open(console(), null);
        Session session = open(material, problems);
        SessionDesk desk = unattended ? new SimulatedDesk() : new WindowDesk(material.wording())) {
      SessionShow show =
          new SessionShow(
              presentation.get(),
              trackerFlags.options(),
              operator == null ? !unattended : operator,
              output);
      console().message("session: " + session.folder().path());
      return ended(new SessionRunner(session, desk, show, console()::message).run(), session);
    } catch (GlUnavailableException e) {
      throw CommandFailure.environment(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw CommandFailure.environment("interrupted; --resume goes on");
    }
  }

  private void check() {
    if (participant != null && !participant.matches(SessionFolder.LABEL)) {
      throw CommandFailure.usage("--participant is made of letters and digits");
    }
    if (resume && participant == null) {
      throw CommandFailure.usage("--resume needs --participant");
    }
    if (number < 1) {
      throw CommandFailure.usage("--session is a number from 1");
    }
    if (exposure != null && !(exposure > 0)) {
      throw CommandFailure.usage("--exposure is a number of seconds above 0");
    }
    GlAvailability.check()
        .ifPresent(
            reason -> {
              throw CommandFailure.environment(reason + "; a session needs windows");
            });
    if (!unattended) {
      LibraryProperties.allowSwing();
    }
  }

  private Session open(StudyMaterial material, Problems problems) throws IOException {
    SessionOptions options =
        new SessionOptions(
            Optional.ofNullable(condition),
            exposure == null ? OptionalDouble.empty() : OptionalDouble.of(exposure),
            unattended,
            new Version().getVersion()[0]);
    String id = participant == null ? SessionFolder.nextId(material.study()) : participant;
    return resume
        ? Session.resume(material, id, number, options, problems)
        : Session.begin(material, id, number, options, problems);
  }

  private static Optional<Presentation> presentation(Study study, Problems problems)
      throws IOException {
    Study.Display display = study.display();
    Optional<DisplayProfile> profile = DisplayProfiles.builtIn(display.hmd());
    if (profile.isEmpty()) {
      profile = DisplayProfiles.read(Path.of(display.hmd()), problems);
    }
    return profile.map(
        known ->
            new Presentation(display.mode(), new EyeGeometry(known, display.ipd() / 1000), false));
  }

  private ExitStatus ended(SessionRunner.Outcome outcome, Session session) {
    console()
        .message(
            switch (outcome) {
              case FINISHED -> "the session is finished";
              case ABORTED ->
                  "the session was aborted; --resume goes on from its last finished step";
              case REFUSED ->
                  "the participant does not take part; " + session.folder().path() + " says so";
            });
    return outcome == SessionRunner.Outcome.FINISHED ? ExitStatus.DONE : ExitStatus.PROBLEMS;
  }
}
