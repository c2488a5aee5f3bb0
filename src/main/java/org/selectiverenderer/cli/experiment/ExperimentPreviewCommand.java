package org.selectiverenderer.cli.experiment;

import java.awt.Desktop;
import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.head.SharedHeadTracker;
import org.selectiverenderer.app.rehearsal.PreviewBanner;
import org.selectiverenderer.app.rehearsal.StudyPreviewPage;
import org.selectiverenderer.app.session.OperatorViewSettings;
import org.selectiverenderer.app.session.SessionDisplaySettings;
import org.selectiverenderer.app.session.SessionRunner;
import org.selectiverenderer.app.session.SessionUi;
import org.selectiverenderer.app.session.SimulatedSessionUi;
import org.selectiverenderer.app.session.SwingSessionUi;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.apparatus.DisplayProfileLoader;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.cli.option.TrackerFilterOptions;
import org.selectiverenderer.cli.view.ConsoleRunListener;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.LibraryProperties;
import org.selectiverenderer.command.ProgramVersion;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.command.trust.TrustOption;
import org.selectiverenderer.command.trust.TrustPrompt;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.render.context.GlAvailability;
import org.selectiverenderer.render.context.GlUnavailableException;
import org.selectiverenderer.render.window.Monitor;
import org.selectiverenderer.render.window.Monitors;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PreviewSession;
import org.selectiverenderer.study.session.Session;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "preview",
    description = {
      "Shows all screens of a study on one page, or runs a session from any step with shortened"
          + " times.",
      "Nothing is written to the study's folder: the data of such a session goes to a temporary"
          + " folder, which is named at the end."
    },
    footer = {
      "  ./selective-renderer experiment preview mystudy --output preview",
      "  ./selective-renderer experiment preview mystudy --from exposure-kitchen \\",
      "      --speed 10"
    })
final class ExperimentPreviewCommand extends CliCommand {
  private static final double FASTEST = 1000;

  @Mixin private StudyArgument study = new StudyArgument();

  @Mixin private TrustOption trust = new TrustOption();

  @Option(
      names = "--output",
      paramLabel = "DIR",
      description = "folder in which the page index.html is written")
  private @Nullable Path output;

  @Option(
      names = "--open",
      description = "opens the page in the browser; without --output it is in a temporary folder")
  private boolean open;

  @Option(
      names = "--from",
      paramLabel = "STEP",
      description = "runs a session that begins at this step, such as form, practice, or a block")
  private @Nullable String from;

  @Option(
      names = "--speed",
      paramLabel = "N",
      defaultValue = "10",
      description =
          "with --from: makes exposures, fades and phases N times as short (default:"
              + " ${DEFAULT-VALUE})")
  private double speed = 10;

  @Option(
      names = "--unattended",
      description = "with --from: a simulated participant answers, without dialogs")
  private boolean unattended;

  @Mixin private LanguageOption language = new LanguageOption();

  @Mixin private TrackerFilterOptions trackerFlags = new TrackerFilterOptions();

  ExperimentPreviewCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    if (from == null && output == null && !open) {
      throw CommandException.usage(
          "name a folder for the page by --output, or use --open, or --from for a session");
    }
    if (from != null && (output != null || open)) {
      throw CommandException.usage("--from runs a session; --output and --open are for the page");
    }
    if (!(speed >= 1 && speed <= FASTEST)) {
      throw CommandException.usage("--speed must be a number from 1 to 1000");
    }
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<List<LoadedStudy>> found =
        study.readForSession(
            language.typed(), trust, TrustPrompt.onTerminal(console()), console(), problems);
    if (found.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    List<LoadedStudy> all = found.get();
    if (from != null) {
      return session(all.get(0), from, problems);
    }
    page(language.typed().isPresent() ? all.subList(0, 1) : all);
    return ExitStatus.of(problems);
  }

  private void page(List<LoadedStudy> material) throws IOException {
    Optional<String> lacking = GlAvailability.check();
    lacking.ifPresent(reason -> console().message(reason + "; scenes are not drawn"));
    String html;
    try {
      html = StudyPreviewPage.html(material, lacking.isEmpty(), console()::message);
    } catch (GlUnavailableException e) {
      console().message(e.getMessage() + "; scenes are not drawn");
      html = StudyPreviewPage.html(material, false, console()::message);
    }
    Path folder =
        output != null
            ? Files.createDirectories(output)
            : Files.createTempDirectory("selective-renderer-preview");
    Path page = folder.resolve("index.html");
    OutputFile.writePrivate(page, html);
    console().message("preview: " + page);
    if (open) {
      LibraryProperties.allowSwing();
      if (GraphicsEnvironment.isHeadless() || !Desktop.isDesktopSupported()) {
        console().message("this desktop opens no pages; open it by hand");
      } else {
        Desktop.getDesktop().browse(page.toUri());
      }
    }
  }

  private ExitStatus session(LoadedStudy material, String first, ProblemCollector problems)
      throws IOException {
    GlAvailability.check()
        .ifPresent(
            reason -> {
              throw CommandException.environment(reason + "; a session needs windows");
            });
    Optional<DisplayConfiguration> presentation = presentation(material.study(), problems);
    if (presentation.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    List<Monitor> monitors = Monitors.all(); // This starts JOGL; Swing may start only afterwards.
    OperatorViewSettings stage =
        OperatorViewSettings.of(
            material.study(),
            presentation.get(),
            Optional.empty(),
            true,
            monitors,
            console()::message);
    if (!unattended) {
      LibraryProperties.allowSwing();
    }
    SessionDisplaySettings show =
        new SessionDisplaySettings(
            presentation.get(),
            trackerFlags.options(),
            false,
            stage,
            new ConsoleRunListener(console(), event -> {}));
    Path folder = Files.createTempDirectory("selective-renderer-preview");
    console().message("PREVIEW: nothing is written to the study's folder");
    try (SharedHeadTracker tracker = new SharedHeadTracker();
        Session session = begin(material, folder, first, problems);
        SessionUi dialogue =
            unattended
                ? new SimulatedSessionUi()
                : new PreviewBanner(new SwingSessionUi(material.wording(), stage))) {
      SessionRunner.Outcome outcome =
          new SessionRunner(session, dialogue, show, tracker, console()::message).run();
      console().message("PREVIEW: the data of this session is in " + folder);
      return outcome == SessionRunner.Outcome.FINISHED ? ExitStatus.DONE : ExitStatus.PROBLEMS;
    } catch (GlUnavailableException e) {
      throw CommandException.environment(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw CommandException.environment("interrupted");
    }
  }

  private Session begin(LoadedStudy material, Path folder, String first, ProblemCollector problems)
      throws IOException {
    try {
      return PreviewSession.begin(
          material,
          folder,
          first,
          speed,
          unattended,
          new ProgramVersion().getVersion()[0],
          problems);
    } catch (IllegalArgumentException e) {
      throw CommandException.usage("--from: " + e.getMessage());
    }
  }

  /** Returns the study's display; a headset's scenes are shown in a window. */
  private static Optional<DisplayConfiguration> presentation(Study study, ProblemCollector problems)
      throws IOException {
    Study.Display display = study.display();
    String name = display.mode() == DisplayMode.OPENXR ? "desk" : display.hmd();
    Optional<DisplayProfile> profile = DisplayProfileLoader.builtIn(name);
    if (profile.isEmpty()) {
      profile = DisplayProfileLoader.read(Path.of(name), problems);
    }
    DisplayMode mode = display.mode() == DisplayMode.OPENXR ? DisplayMode.WINDOW : display.mode();
    return profile.map(
        known ->
            new DisplayConfiguration(mode, new EyeGeometry(known, display.ipd() / 1000), false));
  }
}
