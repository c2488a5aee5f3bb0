package org.selectiverenderer.app.session;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.selectiverenderer.app.metrics.RunMetrics;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.openxr.HeadsetEvent;
import org.selectiverenderer.study.definition.QualityCriteria;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;

/**
 * Flags a session whose exposure did not meet the quality limits of the study, by the measurements
 * of the run and the events of the headset.
 */
final class ExposureQualityCheck {
  private final Session session;
  private final Consumer<Problem> told;
  private final Set<String> said = new HashSet<>();

  /**
   * @param told receives a message for the experimenter about each flag; the same message only once
   */
  ExposureQualityCheck(Session session, Consumer<Problem> told) {
    this.session = session;
    this.told = told;
  }

  /** Checks the measurements of a run; to be called before its step is finished. */
  void check(SessionStep step, RunMetrics figures) {
    if (!(step instanceof SessionStep.Exposure)) {
      return;
    }
    QualityCriteria quality = session.material().study().quality();
    double fps = figures.times().framesPerSecond();
    double slow = figures.times().shareAbove(quality.slowMs());
    List<String> why = quality.tooSlow(fps, slow);
    if (!why.isEmpty()) {
      Map<String, Object> more = new LinkedHashMap<>();
      more.put("fps", DecimalRounding.to(1, fps));
      more.put("slow_frames", DecimalRounding.to(4, slow));
      flag(SessionFlag.LOW_FRAME_RATE, step, more, String.join(", and ", why));
    }
    double silence = figures.trackerSilence();
    if (silence > quality.trackerSilence()) {
      flag(
          SessionFlag.TRACKER_LOST,
          step,
          Map.of("seconds", DecimalRounding.to(2, silence)),
          String.format(Locale.ROOT, "the tracker was silent for %.1f s", silence));
    }
  }

  /** Checks an event of the headset during a step. */
  void check(SessionStep step, HeadsetEvent news) {
    boolean gone = news.kind() == HeadsetEvent.Kind.AWAY || news.kind() == HeadsetEvent.Kind.LOST;
    if (gone && step instanceof SessionStep.Exposure) {
      String what = news.kind().name().toLowerCase(Locale.ROOT);
      flag(SessionFlag.HEADSET_LOST, step, Map.of("what", what), news.text());
    }
  }

  /**
   * Flags the session in its journal and tells the experimenter.
   *
   * @param why the reason as text
   */
  void flag(SessionFlag flag, SessionStep step, Map<String, ?> more, String why) {
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("step", step.id());
    members.putAll(more);
    members.put("why", why);
    session.journal().flag(flag, members);
    if (!said.add(flag.spelling() + why)) {
      return;
    }
    told.accept(
        new Problem(
            Problem.Severity.WARNING,
            SourceLocation.of(session.folder().journal().toString()),
            "%s: %s; the session is flagged %s".formatted(step.id(), why, flag.spelling())));
  }
}
