package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.head.SharedHeadTracker;
import org.selectiverenderer.app.session.OperatorViewSettings;
import org.selectiverenderer.app.session.SessionDisplaySettings;
import org.selectiverenderer.app.session.SessionHeadset;
import org.selectiverenderer.app.session.SessionRunner;
import org.selectiverenderer.app.session.SessionUi;
import org.selectiverenderer.app.session.SimulatedSessionUi;
import org.selectiverenderer.app.session.SwingSessionUi;
import org.selectiverenderer.app.stream.LslStreams;
import org.selectiverenderer.app.trigger.TriggerSender;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.apparatus.DisplayProfileLoader;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.camera.MirroredEye;
import org.selectiverenderer.cli.option.LslOptions;
import org.selectiverenderer.cli.option.TrackerFilterOptions;
import org.selectiverenderer.cli.view.ConsoleRunListener;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.LibraryProperties;
import org.selectiverenderer.command.ProgramVersion;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.command.trust.TrustPrompt;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.hmd.HeadsetLayout;
import org.selectiverenderer.hmd.HeadsetViewSettings;
import org.selectiverenderer.lsl.LslLibrary;
import org.selectiverenderer.render.context.GlAvailability;
import org.selectiverenderer.render.context.GlUnavailableException;
import org.selectiverenderer.render.context.OffscreenContext;
import org.selectiverenderer.render.window.Monitor;
import org.selectiverenderer.render.window.Monitors;
import org.selectiverenderer.study.definition.LslSettings;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.session.DiskRoom;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.ParticipantLanguage;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionFolder;
import org.selectiverenderer.study.session.SessionOptions;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.tracker.TrackerSpec;
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
      "  ./selective-renderer experiment run mystudy/study.json --participant 001 \\",
      "      --resume"
    })
final class ExperimentRunCommand extends CliCommand {
  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  @Mixin private ParticipantOptions participant = new ParticipantOptions();

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
      paramLabel = "NAME",
      description = "group or condition to assign instead of the next one; this is recorded")
  private @Nullable String condition;

  @Option(
      names = "--exposure",
      paramLabel = "S",
      description = "seconds of each exposure instead of the study's, for tests; this is recorded")
  private @Nullable Double exposure;

  @Option(
      names = "--unattended",
      description =
          "runs with a simulated participant and without dialogs, for tests; " + "this is recorded")
  private boolean unattended;

  @Option(
      names = "--operator",
      negatable = true,
      description =
          "opens a window for the experimenter that shows the participant's picture "
              + "(default: where there is a second monitor, unless --unattended)")
  private @Nullable Boolean operator;

  @Option(
      names = "--without-tracker",
      description = "runs without the head tracker that the study has; this is recorded")
  private boolean withoutTracker;

  @Option(
      names = "--operator-monitor",
      paramLabel = "M",
      description =
          "number, from 0, or name of the monitor for the experimenter's windows "
              + "(default: the study's, else one that no eye uses)")
  private @Nullable String operatorMonitor;

  @Option(
      names = "--show-condition",
      description =
          "shows the experimenter the participant's condition, even if the study is blind")
  private boolean showCondition;

  @Mixin private LanguageOption language = new LanguageOption();

  @Mixin private TrackerFilterOptions trackerFlags = new TrackerFilterOptions();

  @Mixin private LslOptions lsl = new LslOptions();

  ExperimentRunCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    check();
    if (!unattended && System.getProperty("os.name", "").startsWith("Windows")) {
      // Java for Windows asks whether it may open windows when it reads the first picture of a
      // questionnaire, and remembers the answer; elsewhere it asks when the first window opens.
      Monitors.all(); // This starts JOGL; Swing may start only afterwards.
      LibraryProperties.allowSwing();
    }
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<List<LoadedStudy>> found =
        study.readForSession(language.typed(), trust, prompt(), console(), problems);
    if (found.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    LoadedStudy material = spoken(found.get());
    if (condition != null && material.study().design().group(condition).isEmpty()) {
      throw CommandException.usage(
          "the study has no group %s for --condition; it has %s"
              .formatted(
                  condition,
                  material.study().design().groups().stream()
                      .map(StudyGroup::name)
                      .collect(Collectors.joining(", "))));
    }
    Optional<String> lacking = material.lackingScene();
    if (lacking.isPresent()) {
      throw CommandException.environment(lacking.get() + "; nothing has begun");
    }
    DiskRoom.of(material.study()).warning().ifPresent(console()::message);
    Optional<DisplayConfiguration> presentation = presentation(material.study(), problems);
    if (presentation.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    List<Monitor> monitors = Monitors.all(); // This starts JOGL; Swing may start only afterwards.
    OperatorViewSettings stage = stage(material.study(), presentation.get(), monitors);
    SessionDisplaySettings plain =
        new SessionDisplaySettings(
            presentation.get(),
            trackerFlags.options(),
            operator == null ? !unattended && viewFits(monitors) : operator,
            stage,
            new ConsoleRunListener(console(), event -> {}));
    LslSettings wanted =
        lsl.asked() ? material.study().streams().sending() : material.study().streams();
    Optional<LslLibrary> library = lsl.library(wanted.wanted()); // before anything has begun
    requireGl(material);
    Optional<SessionHeadset> headset = headset(presentation.get(), material);
    try (SharedHeadTracker tracker =
            headset
                .map(worn -> new SharedHeadTracker((settings, hears) -> worn.tracker(hears)))
                .orElseGet(SharedHeadTracker::new);
        TriggerSender triggers = TriggerSender.of(material.study().triggers());
        Session session = open(material, plain, tracker, problems);
        // Closed before the session, whose journal it tells what was sent.
        TriggerSender following = triggers.follow(session.journal(), console()::message);
        LslStreams streams = streams(wanted, library, session);
        SessionUi dialogue =
            unattended ? new SimulatedSessionUi() : new SwingSessionUi(material.wording(), stage)) {
      SessionDisplaySettings show =
          plain.heardBy(new ConsoleRunListener(console(), event -> {}, streams.samples()));
      session
          .journal()
          .listen(
              event -> {
                following.event(event);
                streams.event(event);
              });
      console().message("session: " + session.folder().path());
      return ended(
          new SessionRunner(session, dialogue, show, tracker, headset, console()::message).run(),
          session);
    } catch (GlUnavailableException e) {
      throw CommandException.environment(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw CommandException.environment("interrupted; --resume continues the session");
    }
  }

  /** Chooses the language: as typed, else that of the participant's sessions, else the first. */
  private LoadedStudy spoken(List<LoadedStudy> all) throws IOException {
    LoadedStudy first = all.get(0);
    if (language.typed().isPresent() || participant.typed().isEmpty()) {
      return first;
    }
    Optional<String> used =
        ParticipantLanguage.of(first.study(), participant.typed().get(), number);
    return all.stream()
        .filter(one -> used.equals(Optional.of(one.study().language())))
        .findFirst()
        .orElse(first);
  }

  /** Asks on the terminal, else by a window, as sessions have windows; never where unattended. */
  private TrustPrompt prompt() {
    return unattended ? TrustPrompt.NOBODY : TrustPrompt.onTerminal(console()).or(TrustWindow::ask);
  }

  /** Returns the study's headset, checked before the session begins; empty for other displays. */
  private Optional<SessionHeadset> headset(DisplayConfiguration presentation, LoadedStudy material)
      throws IOException {
    if (presentation.headset().isEmpty()) {
      return Optional.empty();
    }
    if (!(material.study().tracker() instanceof TrackerSpec.None)) {
      throw CommandException.usage(
          "the study's display is a headset, which is a tracker itself; leave \"tracker\" out of"
              + " the study");
    }
    SessionHeadset worn = new SessionHeadset(presentation.headset().get());
    if (material.steps().stream().anyMatch(SessionStep::shows)) {
      console().message(worn.require());
    }
    return Optional.of(worn);
  }

  private LslStreams streams(LslSettings wanted, Optional<LslLibrary> library, Session session)
      throws IOException {
    if (library.isEmpty()) {
      return LslStreams.none();
    }
    Map<String, Object> about = new LinkedHashMap<>();
    about.put("study", session.material().study().name());
    about.put("participant", session.folder().participant());
    about.put("session", session.folder().number());
    LslStreams streams =
        wanted.lsl()
            ? LslStreams.sending(library.get(), about, session.journal()::tell)
            : LslStreams.none();
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

  /**
   * Records an event of the streams in the journal, and prints problems and new streams for the
   * experimenter.
   */
  private void told(Session session, String event, Map<String, ?> more) {
    session.journal().tell(event, more);
    if (event.equals("problem")) {
      console().message(String.valueOf(more.get("text")));
    } else if (event.equals("stream-began")) {
      console().message("stream: " + more.get("stream") + " is recorded as " + more.get("file"));
    }
  }

  private void check() {
    participant.check();
    if (resume && participant.typed().isEmpty()) {
      throw CommandException.usage("--resume needs --participant");
    }
    if (number < 1) {
      throw CommandException.usage("--session must be a whole number of at least 1");
    }
    if (exposure != null && !(exposure > 0)) {
      throw CommandException.usage("--exposure must be a number of seconds above 0");
    }
    GlAvailability.check()
        .ifPresent(
            reason -> {
              throw CommandException.environment(reason + "; a session needs windows");
            });
  }

  /**
   * Opens OpenGL once before the session begins: otherwise a participant would have a condition and
   * would have filled in the form when the first window fails.
   */
  private static void requireGl(LoadedStudy material) {
    if (material.steps().stream().anyMatch(SessionStep::shows)) {
      try {
        OffscreenContext.open().close();
      } catch (GlUnavailableException e) {
        throw CommandException.environment(e.getMessage() + "; nothing has begun");
      }
    }
  }

  private boolean viewFits(List<Monitor> monitors) {
    if (OperatorViewSettings.viewFits(monitors)) {
      return true;
    }
    console()
        .message(
            "there is one monitor, on which the experimenter's view would cover the participant's"
                + " picture: it is left out; --operator opens it");
    return false;
  }

  /** Chooses the operator's monitors. JOGL has started with them, so Swing may start afterwards. */
  private OperatorViewSettings stage(
      Study study, DisplayConfiguration presentation, List<Monitor> monitors) {
    try {
      return OperatorViewSettings.of(
          study,
          presentation,
          Optional.ofNullable(operatorMonitor),
          showCondition,
          monitors,
          console()::message);
    } catch (IllegalArgumentException e) {
      throw CommandException.usage(
          e.getMessage()
              + (operatorMonitor == null
                  ? " by --operator-monitor, or in the study's \"display\""
                  : " by --operator-monitor"));
    } finally {
      if (!unattended) {
        LibraryProperties.allowSwing();
      }
    }
  }

  /**
   * Opens the session. The tracker must have sent a sample before the participant is assigned a
   * condition.
   */
  private Session open(
      LoadedStudy material,
      SessionDisplaySettings show,
      SharedHeadTracker tracker,
      ProblemCollector problems)
      throws IOException, InterruptedException {
    SessionOptions options =
        new SessionOptions(
            Optional.ofNullable(condition),
            exposure == null ? OptionalDouble.empty() : OptionalDouble.of(exposure),
            unattended,
            TrackerReadinessCheck.instead(
                material.study().tracker(), withoutTracker, console()::message),
            new ProgramVersion().getVersion()[0]);
    String id = participant.of(material.study(), resume, console()::ask);
    TrackerReadinessCheck presence = new TrackerReadinessCheck(tracker, show);
    if (!resume) {
      SessionFolder folder = new SessionFolder(material.study().folder(), id, number);
      Session.requireNew(folder, options.software());
      presence.require(options, material.study().tracker(), material.steps());
      return Session.begin(material, id, number, options, problems);
    }
    Session session = Session.resume(material, id, number, options, problems);
    try {
      presence.require(options, material.study().tracker(), session.remaining());
      return session;
    } catch (IOException | InterruptedException | RuntimeException e) {
      session.close();
      throw e;
    }
  }

  private static Optional<DisplayConfiguration> presentation(Study study, ProblemCollector problems)
      throws IOException {
    Study.Display display = study.display();
    if (display.mode() == DisplayMode.OPENXR) {
      Study.Worn worn = display.worn();
      return Optional.of(
          DisplayConfiguration.in(
              new HeadsetViewSettings(
                  worn.seated(),
                  worn.scale(),
                  Math.toRadians(worn.turn()),
                  MirroredEye.BOTH,
                  new HeadsetLayout(worn.scale()))));
    }
    Optional<DisplayProfile> profile = DisplayProfileLoader.builtIn(display.hmd());
    if (profile.isEmpty()) {
      profile = DisplayProfileLoader.read(Path.of(display.hmd()), problems);
    }
    return profile.map(
        known ->
            new DisplayConfiguration(
                display.mode(), new EyeGeometry(known, display.ipd() / 1000), false));
  }

  private ExitStatus ended(SessionRunner.Outcome outcome, Session session) {
    console()
        .message(
            switch (outcome) {
              case FINISHED -> "the session is finished";
              case ABORTED ->
                  "the session was aborted; --resume continues after its last finished step";
              case REFUSED ->
                  "the participant declined to take part; see " + session.folder().path();
            });
    return outcome == SessionRunner.Outcome.FINISHED ? ExitStatus.DONE : ExitStatus.PROBLEMS;
  }
}
