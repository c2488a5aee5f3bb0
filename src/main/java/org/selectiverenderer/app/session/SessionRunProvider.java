package org.selectiverenderer.app.session;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import org.selectiverenderer.app.head.HeadSampleListener;
import org.selectiverenderer.app.metrics.RunMetrics;
import org.selectiverenderer.app.narration.Narration;
import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.app.run.RunRequest;
import org.selectiverenderer.app.run.RunSequence;
import org.selectiverenderer.app.settings.DisplaySettings;
import org.selectiverenderer.app.settings.HeadLogSettings;
import org.selectiverenderer.app.settings.MotionSettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.hmd.HeadsetViewSettings;
import org.selectiverenderer.openxr.HeadsetEvent;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.QualityRule;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.BlockProgress;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialSettings;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;
import org.selectiverenderer.walkthrough.timeline.TimelineJson;

/** Provides the steps of a session that show a scene as the runs of one {@link RunSequence}. */
final class SessionRunProvider implements RunSequence.Runs {
  /** The length of an unattended practice in seconds. */
  private static final double UNATTENDED_PRACTICE = 2;

  private final Session session;
  private final SessionDisplaySettings show;
  private final ExperimenterControls controls;
  private final ExposureQualityCheck quality;
  private final Narration narration;
  private final Set<String> brokenLogs = ConcurrentHashMap.newKeySet();
  private Optional<DisplayConfiguration> opened = Optional.empty();
  private boolean reopens;

  SessionRunProvider(
      Session session,
      SessionDisplaySettings show,
      ExperimenterControls controls,
      Narration narration) {
    this.narration = narration;
    this.session = session;
    this.show = show;
    this.controls = controls;
    quality = new ExposureQualityCheck(session, show.listener()::problem);
  }

  private Optional<SessionStep> upcoming() {
    return session.remaining().stream().findFirst().filter(this::shows);
  }

  /**
   * Returns whether a step is shown in the windows of the chain: a scene, or questions inside the
   * headset.
   */
  boolean shows(SessionStep step) {
    return step.shows()
        || show.presentation().headset().isPresent() && session.material().insideHeadset(step);
  }

  /** Returns whether the next step is shown in the windows of the chain. */
  boolean wanted() {
    return upcoming().isPresent();
  }

  /** Forgets the display of the last chain of runs, as another one begins with its own windows. */
  void chainBegins() {
    opened = Optional.empty();
    reopens = false;
  }

  /** Returns whether the chain has ended because the next step needs other windows. */
  boolean reopens() {
    return reopens;
  }

  @Override
  public Optional<RunRequest> next() throws IOException {
    Optional<SessionStep> step = upcoming();
    if (step.isPresent() && step.get() instanceof SessionStep.Block block && !controls.aborted()) {
      BlockProgress progress = session.progress(block);
      Optional<Trial> trial = progress.next();
      if (trial.isEmpty()) {
        end(block, progress);
        return next();
      }
      return trial(trial.get(), progress);
    }
    if (step.isEmpty()
        || controls.aborted()
        || !fits(show.presentation().withIpd(session.ipd() / 1000))) {
      return Optional.empty();
    }
    if (step.get() instanceof SessionStep.Questions questions) {
      return Optional.of(asking(questions));
    }
    Path log = session.headLog(step.get());
    session.began(step.get(), true);
    RunListener listener = listener(step.get(), Optional.of(log));
    return Optional.of(
        new RunRequest(
            settings(step.get(), scene(step.get()), Optional.of(new HeadLogSettings(log))),
            listener,
            guide(step.get(), listener)));
  }

  /** Returns whether a display is that of the open windows, which it becomes if there are none. */
  private boolean fits(DisplayConfiguration wanted) {
    reopens = opened.filter(known -> !known.equals(wanted)).isPresent();
    if (!reopens) {
      opened = Optional.of(wanted);
    }
    return !reopens;
  }

  private Optional<RunRequest> trial(Trial trial, BlockProgress progress) throws IOException {
    if (!fits(display(trial))) {
      return Optional.empty();
    }
    SessionStep.OneTrial step = new SessionStep.OneTrial(trial);
    Study study = session.material().study();
    Path scene =
        study
            .scene(trial)
            .or(session.material()::scenery)
            .orElseThrow(
                () -> new IOException("the study has no scene in which its trials could be shown"));
    Path log = session.headLog(step);
    session.began(step, progress);
    RunListener listener = listener(step, Optional.of(log));
    return Optional.of(
        new RunRequest(
            settings(
                step,
                scene,
                new SelectiveController.Settings(
                        trial.settings().condition().orElse(Condition.SELECTIVE),
                        lot() + trial.number(),
                        trial.settings().choices())
                    .with(trial.settings().transition().orElse(study.transition()))
                    .with(study.qualities(trial.settings())),
                display(trial),
                Optional.of(new HeadLogSettings(log))),
            listener,
            new TrialController(
                session,
                step,
                progress.restIsDue(),
                controls,
                show.stage(),
                show.presentation().headset().map(HeadsetViewSettings::layout),
                narration,
                listener::problem)));
  }

  /** Returns the display of a trial, with the participant's eyes unless the trial has its own. */
  private DisplayConfiguration display(Trial trial) {
    DisplayConfiguration usual = show.presentation();
    DisplayConfiguration mode = trial.settings().mode().map(usual::as).orElse(usual);
    return mode.withIpd(trial.settings().ipd().orElse(session.ipd()) / 1000);
  }

  private void end(SessionStep.Block block, BlockProgress progress) throws IOException {
    Map<String, Object> more = new LinkedHashMap<>();
    more.put("trials", progress.done());
    if (progress.failed()) {
      quality.flag(
          SessionFlag.PRACTICE_FAILED,
          block,
          Map.of("rounds", progress.round()),
          "the practice did not reach its criterion");
    }
    List<Map<String, Object>> estimates =
        progress.estimates().stream().map(SessionRunProvider::members).toList();
    if (!estimates.isEmpty()) {
      more.put("staircases", estimates);
    }
    session.finished(block, more);
  }

  private static Map<String, Object> members(BlockProgress.StaircaseEstimate estimate) {
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("levels", estimate.levels());
    if (estimate.line() > 0) {
      members.put("line", estimate.line());
    }
    if (!Double.isNaN(estimate.level())) {
      members.put("level", DecimalRounding.to(4, estimate.level()));
    }
    if (!Double.isNaN(estimate.value())) {
      members.put("value", DecimalRounding.to(6, estimate.value()));
    }
    members.put("trials", estimate.trials());
    return members;
  }

  private RunRequest asking(SessionStep.Questions step) throws IOException {
    session.began(step, false);
    Study study = session.material().study();
    return new RunRequest(
        settings(step, session.material().scenery().orElseThrow(), Optional.empty()),
        listener(step, Optional.empty()),
        new HeadsetQuestionController(
            session,
            step,
            controls,
            show.presentation().headset().orElseThrow().layout(),
            study.practice().isEmpty(),
            narration));
  }

  private SceneStepController guide(SessionStep step, RunListener listener) {
    OptionalDouble shortened = session.options().exposure();
    if (step instanceof SessionStep.Exposure exposure) {
      return new SceneStepController(
          session,
          step,
          exposure.area().viewpoint(),
          OptionalDouble.of(shortened.orElse(exposure.area().seconds())),
          controls,
          show.stage(),
          listener::problem);
    }
    return new SceneStepController(
        session,
        step,
        session.material().study().practice().map(Study.Practice::viewpoint).orElse(""),
        session.options().unattended()
            ? OptionalDouble.of(
                Math.min(UNATTENDED_PRACTICE, shortened.orElse(UNATTENDED_PRACTICE)))
            : OptionalDouble.empty(),
        controls,
        show.stage(),
        listener::problem);
  }

  private Path scene(SessionStep step) {
    return step instanceof SessionStep.Practice practice
        ? practice.practice().scene()
        : session.material().study().scene().orElseThrow();
  }

  private RunSettings settings(SessionStep step, Path scene, Optional<HeadLogSettings> log) {
    Study study = session.material().study();
    TrialSettings group =
        session.group().map(StudyGroup::settings).orElse(TrialSettings.NONE);
    return settings(
        step,
        scene,
        new SelectiveController.Settings(
                session.group().map(StudyGroup::condition).orElse(Condition.HIGH), lot())
            .with(group.transition().orElse(study.transition()))
            .with(study.qualities(group)),
        show.presentation().withIpd(session.ipd() / 1000),
        log);
  }

  private RunSettings settings(
      SessionStep step,
      Path scene,
      SelectiveController.Settings rendering,
      DisplayConfiguration presentation,
      Optional<HeadLogSettings> log) {
    Study study = session.material().study();
    Study.Display display = study.display();
    int width = display.width() > 0 ? display.width() : show.presentation().width();
    int height = display.height() > 0 ? display.height() : show.presentation().height();
    return new RunSettings(scene, rendering)
        .allowing(study.access())
        .muted(study.mute() || step instanceof SessionStep.Questions)
        .with(MotionSettings.walking(study.mouse()))
        .with(
            DisplaySettings.of(presentation)
                .filling(width, height)
                .operator(show.operator())
                .operatorOn(show.stage().monitor())
                // The scene's name may tell what a participant must not know.
                .titled(Optional.of(session.material().wording().of("form.title"))))
        .with(show.tracker(session.tracker()), log);
  }

  /** Returns the seed of the random condition, which is fixed for each participant. */
  private long lot() {
    return session.material().study().lot(session.folder().participant());
  }

  private RunListener listener(SessionStep step, Optional<Path> log) {
    TimelineJson lines = new TimelineJson();
    return new RunListener() {
      @Override
      public void problem(Problem problem) {
        session.journal().tell("problem", Map.of("step", step.id(), "text", problem.toString()));
        if (log.filter(file -> problem.location().file().equals(file.toString())).isPresent()) {
          brokenLogs.add(step.id()); // The log's thread reports this before the log is closed.
        }
        show.listener().problem(problem);
      }

      @Override
      public void displayFallback(String told) {
        quality.flag(SessionFlag.DISPLAY_FALLBACK, step, Map.of(), told);
      }

      @Override
      public void headset(HeadsetEvent news) {
        session
            .journal()
            .tell(
                "headset",
                Map.of(
                    "step",
                    step.id(),
                    "what",
                    news.kind().name().toLowerCase(Locale.ROOT),
                    "text",
                    news.text()));
        quality.check(step, news);
        show.listener().headset(news);
      }

      @Override
      public void happened(TimelineEvent event) {
        session.journal().tell("scene", Map.of("step", step.id(), "what", read(lines.line(event))));
      }

      @Override
      public Optional<HeadSampleListener> samples() {
        return show.listener().samples();
      }

      @Override
      public void printed(String text) {
        show.listener().printed(text);
      }
    };
  }

  private Object read(String text) {
    try {
      return JsonTree.parse(text);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException(e);
    }
  }

  @Override
  public void ended(RunRequest run, RunMetrics figures) throws IOException {
    if (controls.aborted()) {
      return;
    }
    if (run.guide() instanceof TrialController trial) {
      ended(run, trial, figures);
      return;
    }
    SessionStep step = upcoming().orElseThrow();
    if (run.guide() instanceof HeadsetQuestionController asked) {
      asked.told().check();
      if (asked.through()) {
        session.finished(step, Map.of());
      } else {
        controls.abort();
      }
      return;
    }
    session.finished(step, figures(step, run, figures));
  }

  private void ended(RunRequest run, TrialController trial, RunMetrics figures) throws IOException {
    trial.check();
    if (!trial.through()) {
      controls.abort();
      return;
    }
    Map<String, Object> more = figures(trial.step(), run, figures);
    more.put("phases", trial.shown());
    session.finished(trial.step(), trial.result(), more);
  }

  /** Returns the members that the end of a shown step has, and flags it if it is due. */
  private Map<String, Object> figures(SessionStep step, RunRequest run, RunMetrics figures) {
    Map<String, Object> more = new LinkedHashMap<>();
    more.put("condition", run.settings().scene().rendering().condition().spelling());
    Map<Quality, QualityRule> rules = run.settings().scene().rendering().qualities();
    if (!rules.isEmpty()) {
      Map<String, String> qualities = new TreeMap<>();
      rules.forEach((quality, rule) -> qualities.put(quality.spelling(), rule.spelling()));
      more.put("qualities", qualities);
    }
    more.put("lot", run.settings().scene().rendering().seed());
    more.put("figures", read(figures.json()));
    more.put(
        "display", List.of(run.settings().display().width(), run.settings().display().height()));
    quality.check(step, figures);
    if (brokenLogs.remove(step.id())) {
      more.put("head_log_incomplete", true);
      session.journal().flag(SessionFlag.HEAD_LOG_INCOMPLETE, Map.of("step", step.id()));
    }
    return more;
  }
}
