package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.session.SessionDialogue;
import org.selectiverenderer.app.session.SessionRunner;
import org.selectiverenderer.app.session.SessionShow;
import org.selectiverenderer.app.session.SimulatedDialogue;
import org.selectiverenderer.app.session.WindowDialogue;
import org.selectiverenderer.app.stream.LabStreams;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.cli.base.CliCommand;
import org.selectiverenderer.cli.base.LibraryProperties;
import org.selectiverenderer.cli.base.ProgramVersion;
import org.selectiverenderer.cli.option.ConditionOptions;
import org.selectiverenderer.cli.option.LslOptions;
import org.selectiverenderer.cli.option.TrackerFlags;
import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.cli.output.Console;
import org.selectiverenderer.cli.output.ExitStatus;
import org.selectiverenderer.cli.output.RunOutput;
import org.selectiverenderer.control.Condition;
import org.selectiverenderer.experiment.session.Session;
import org.selectiverenderer.experiment.session.SessionFolder;
import org.selectiverenderer.experiment.session.SessionOptions;
import org.selectiverenderer.experiment.session.StudyMaterial;
import org.selectiverenderer.experiment.study.Study;
import org.selectiverenderer.experiment.study.StudyStreams;
import org.selectiverenderer.hmd.DisplayProfile;
import org.selectiverenderer.hmd.DisplayProfiles;
import org.selectiverenderer.hmd.EyeGeometry;
import org.selectiverenderer.hmd.Presentation;
import org.selectiverenderer.lsl.LslLibrary;
import org.selectiverenderer.runtime.render.context.GlAvailability;
import org.selectiverenderer.runtime.render.context.GlUnavailableException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "run",
    description = {
      "Runs a participant's session: form, practice, exposures, questionnaires.",
      "Everything is written to sub-ID/ses-NN in the study's folder as it happens. "
          + "After a crash --resume continues after the last finished step."
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
      description = "id of the participant, letters and digits (default: the next free number)")
  private @Nullable String participant;

  @Option(
      names = "--session",
      defaultValue = "1",
      paramLabel = "N",
      description = "number of the participant's session (default: ${DEFAULT-VALUE})")
  private int number = 1;

  @Option(names = "--resume", description = "continues a session that was cut off or aborted")
  private boolean resume;

  @Option(
      names = "--condition",
      converter = ConditionOptions.Converter.class,
      paramLabel = "NAME",
      description = "condition to assign instead of the next one; this is recorded")
  private @Nullable Condition condition;

  @Option(
      names = "--exposure",
      paramLabel = "S",
      description = "seconds of each exposure instead of the study's, for tests; this is recorded")
  private @Nullable Double exposure;

  @Option(
      names = "--unattended",
      description =
          "runs with a simulated participant and asks nobody anything, for tests; "
              + "this is recorded")
  private boolean unattended;

  @Option(
      names = "--operator",
      negatable = true,
      description =
          "opens a window for the experimenter that shows the participant's picture "
              + "(default: unless --unattended)")
  private @Nullable Boolean operator;

  @Mixin private TrackerFlags trackerFlags = new TrackerFlags();

  @Mixin private LslOptions lsl = new LslOptions();

  ExperimentRunCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
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
    StudyStreams wanted =
        lsl.asked() ? material.study().streams().sending() : material.study().streams();
    Optional<LslLibrary> library = lsl.library(wanted.wanted()); // before anything has begun
    try (Session session = open(material, problems);
        LabStreams streams = streams(wanted, library, session);
        SessionDialogue dialogue =
            unattended ? new SimulatedDialogue() : new WindowDialogue(material.wording())) {
      SessionShow show =
          new SessionShow(
              presentation.get(),
              trackerFlags.options(),
              operator == null ? !unattended : operator,
              new RunOutput(console(), event -> {}, streams.samples()));
      session.journal().listen(streams::event);
      console().message("session: " + session.folder().path());
      return ended(new SessionRunner(session, dialogue, show, console()::message).run(), session);
    } catch (GlUnavailableException e) {
      throw CommandFailure.environment(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw CommandFailure.environment("interrupted; --resume continues the session");
    }
  }

  private LabStreams streams(StudyStreams wanted, Optional<LslLibrary> library, Session session)
      throws IOException {
    if (library.isEmpty()) {
      return LabStreams.none();
    }
    Map<String, Object> about = new LinkedHashMap<>();
    about.put("study", session.material().study().name());
    about.put("participant", session.folder().participant());
    about.put("session", session.folder().number());
    LabStreams streams =
        wanted.lsl()
            ? LabStreams.sending(library.get(), about, session.journal()::tell)
            : LabStreams.none();
    if (!wanted.record().isEmpty()) {
      try {
        streams.record(
            library.get(),
            wanted.record(),
            session.folder().path().resolve("streams"),
            (event, more) -> told(session, event, more));
      } catch (IOException e) {
        streams.close();
        throw e;
      }
    }
    return streams;
  }

  /** The journal keeps it; what is not as asked for the experimenter reads at once. */
  private void told(Session session, String event, Map<String, ?> more) {
    session.journal().tell(event, more);
    if (event.equals("problem")) {
      console().message(String.valueOf(more.get("text")));
    } else if (event.equals("stream-began")) {
      console().message("stream: " + more.get("stream") + " is recorded as " + more.get("file"));
    }
  }

  private void check() {
    if (participant != null && !participant.matches(SessionFolder.LABEL)) {
      throw CommandFailure.usage("--participant must consist of letters and digits");
    }
    if (resume && participant == null) {
      throw CommandFailure.usage("--resume needs --participant");
    }
    if (number < 1) {
      throw CommandFailure.usage("--session must be a whole number of at least 1");
    }
    if (exposure != null && !(exposure > 0)) {
      throw CommandFailure.usage("--exposure must be a number of seconds above 0");
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
            new ProgramVersion().getVersion()[0]);
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
                  "the session was aborted; --resume continues after its last finished step";
              case REFUSED ->
                  "the participant does not take part; " + session.folder().path() + " says so";
            });
    return outcome == SessionRunner.Outcome.FINISHED ? ExitStatus.DONE : ExitStatus.PROBLEMS;
  }
}
