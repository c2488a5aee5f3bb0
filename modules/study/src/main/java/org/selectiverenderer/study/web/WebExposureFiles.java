package org.selectiverenderer.study.web;

import java.io.IOException;
import java.nio.file.Path;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.joml.Quaterniond;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.definition.QualityCriteria;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.StimulusList;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.headlog.HeadLogMetadata;
import org.selectiverenderer.study.headlog.HeadLogText;
import org.selectiverenderer.study.headlog.HeadSample;
import org.selectiverenderer.study.headlog.SceneMap;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.study.web.ExposureReplay.Seen;
import org.selectiverenderer.study.web.WebExposureLog.Frame;
import org.selectiverenderer.tracker.PoseSample;

/**
 * Makes the head log of an exposure, and what the journal tells of it, of the log of a page and
 * what a replay finds in view.
 */
final class WebExposureFiles {
  /** Frames per second below which an exposure is flagged where the study names no limit. */
  private static final double MIN_FPS = 20;

  /** Limits within which a head counts as idle, as in the program's own head logs. */
  private static final double STILL_ANGLE = Math.toRadians(0.05);

  private static final double STILL_WAY = 1e-3;

  /** The window that is assumed where the page does not tell its size. */
  private static final int WIDTH = 1280;

  private static final int HEIGHT = 800;

  private final LoadedStudy material;
  private final Study study;
  private final ExposureReplay replay;
  private final ProblemCollector problems;
  private final Map<String, Integer> unlisted = new HashMap<>();

  WebExposureFiles(LoadedStudy material, ExposureReplay replay, ProblemCollector problems) {
    this.material = material;
    study = material.study();
    this.replay = replay;
    this.problems = problems;
  }

  /** The two files of a head log, and the events of the scene. */
  record HeadLogTexts(String csv, String json, List<Map<String, Object>> events) {}

  /**
   * Makes the head log.
   *
   * @param device what the page told of the participant's device
   */
  HeadLogTexts headLog(WebRecord record, WebExposureLog log, Map<String, String> device) {
    ExposureReplay.Replayed seen = replayed(record, log, device);
    List<HeadSample> samples = new ArrayList<>();
    Quaterniond before = new Quaterniond();
    Quaterniond turn = new Quaterniond();
    PoseSample angles = new PoseSample();
    double offset = record.logBegan(log);
    for (int i = 0; i < log.frames().size(); i++) {
      Frame frame = log.frames().get(i);
      Seen view = i < seen.frames().size() ? seen.frames().get(i) : Seen.UNKNOWN;
      angles.turn(frame.yaw(), frame.pitch(), frame.roll());
      angles.orientation(turn);
      boolean moved =
          i == 0
              || way(log.frames().get(i - 1), frame) >= STILL_WAY
              || turn.difference(before, new Quaterniond()).angle() >= STILL_ANGLE;
      samples.add(
          new HeadSample(
              frame.t(),
              frame.x(),
              frame.y(),
              frame.z(),
              frame.yaw(),
              frame.pitch(),
              frame.roll(),
              moved,
              view.object(),
              view.distance(),
              view.version(),
              view.cone(),
              view.schemas(),
              frame.ms(),
              new HeadSample.Moment(
                  frame.visible(),
                  record.started().plusNanos(Math.round((offset + frame.t()) * 1e9)),
                  frame.mono()),
              null));
      before.set(turn);
    }
    return new HeadLogTexts(
        HeadLogText.csv(samples),
        seen.description().json(),
        SceneEventMembers.of(log, seen.frames()));
  }

  private static double way(Frame from, Frame to) {
    return Math.sqrt(
        square(to.x() - from.x()) + square(to.y() - from.y()) + square(to.z() - from.z()));
  }

  private static double square(double number) {
    return number * number;
  }

  private ExposureReplay.Replayed replayed(
      WebRecord record, WebExposureLog log, Map<String, String> device) {
    ExposureReplay.Exposure exposure = exposure(record, log, device);
    if (record.step() instanceof SessionStep.OneTrial one && !listed(record)) {
      unlisted.merge(one.trial().block(), 1, Integer::sum);
      return unseen(exposure);
    }
    try {
      return replay.of(study, exposure);
    } catch (IOException e) {
      problems.warning(
          SourceLocation.of(study.file().toString()),
          "what was in view in exposures is not known, as the scene cannot be replayed: "
              + e.getMessage());
      return unseen(exposure);
    }
  }

  /** Returns whether it is known what was shown. */
  private static boolean listed(WebRecord record) {
    return record.trial().map(WebRecord.TrialOutcome::listed).orElse(true);
  }

  /** Reports the trials whose stimuli are no longer in their lists. */
  void tellUnlisted() {
    for (TrialBlock block : study.design().blocks()) {
      int number = unlisted.getOrDefault(block.name(), 0);
      if (number > 0) {
        problems.warning(
            SourceLocation.of(
                block.stimuli().map(StimulusList::file).orElse(study.file()).toString()),
            ("what was in view in %s of the block %s is not known, as the list of its stimuli no"
                    + " longer has the rows that were shown; all else of the records is used")
                .formatted(Pluralizer.of(number, "trial"), block.name()));
      }
    }
  }

  private ExposureReplay.Exposure exposure(
      WebRecord record, WebExposureLog log, Map<String, String> device) {
    StudyGroup group = study.design().group(record.identity().group()).orElseThrow();
    long seed = study.lot(record.identity().participant());
    Optional<Path> scene = study.scene();
    Condition condition = group.condition();
    String viewpoint = "";
    if (record.step() instanceof SessionStep.Exposure exposure) {
      viewpoint = exposure.area().viewpoint();
    } else if (record.step() instanceof SessionStep.OneTrial one) {
      Trial trial = one.trial();
      scene = listed(record) ? study.scene(trial).or(material::scenery) : Optional.empty();
      viewpoint = study.viewpoint(trial).orElse("");
      condition = trial.settings().condition().orElse(Condition.SELECTIVE);
      seed += trial.number();
    }
    return new ExposureReplay.Exposure(
        scene,
        viewpoint,
        condition,
        group,
        seed,
        record
            .started()
            .plusMillis(Math.round(1000 * record.logBegan(log)))
            .atOffset(ZoneOffset.UTC),
        pixels(device.get("width"), WIDTH),
        pixels(device.get("height"), HEIGHT),
        log);
  }

  private static int pixels(@Nullable String text, int otherwise) {
    return text != null && text.matches("[1-9]\\d{1,4}") ? Integer.parseInt(text) : otherwise;
  }

  /** Returns what the page itself told, where the scene cannot be replayed. */
  private ExposureReplay.Replayed unseen(ExposureReplay.Exposure exposure) {
    double tanY = Math.tan(Math.PI / 8); // the default of a Viewpoint's field of view
    HeadLogMetadata description =
        new HeadLogMetadata(
            exposure.started().toString(),
            exposure.scene().map(scene -> String.valueOf(scene.getFileName())).orElse(""),
            exposure.group().name(),
            exposure.seed(),
            exposure.display(),
            "none",
            tanY * exposure.width() / exposure.height(),
            tanY,
            1,
            0,
            false,
            SceneMap.EMPTY);
    return new ExposureReplay.Replayed(description, List.of());
  }

  /** Adds the flags of an exposure to the journal, at its end. */
  void flag(WebRecord record, WebExposureLog log, WebSessionJournal journal) {
    double end = record.seconds();
    if (record.repeated()) {
      journal.flag(end, SessionFlag.REPEATED_EXPOSURE, Map.of());
    }
    double left = DecimalRounding.to(3, record.secondsLeft(log));
    if (left > 0) {
      journal.flag(end, SessionFlag.LEFT_PAGE, Map.of("seconds", left));
    }
    boolean exposed = record.trial().map(outcome -> outcome.exposed().isPresent()).orElse(true);
    if (exposed && !log.seen()) {
      journal.flag(end, SessionFlag.NOT_SEEN, Map.of());
    }
    if (record.headsetLeft(log)) {
      journal.flag(end, SessionFlag.HEADSET_LOST, Map.of());
    }
    QualityCriteria quality = study.quality();
    double fps = log.framesPerSecond();
    double slow = log.shareAbove(quality.slowMs());
    List<String> why =
        quality.minFps().isPresent()
            ? quality.tooSlow(fps, slow)
            : new QualityCriteria(OptionalDouble.of(MIN_FPS), 1, 0, Set.of()).tooSlow(fps, slow);
    if (!why.isEmpty()) {
      Map<String, Object> more = new LinkedHashMap<>();
      more.put("fps", DecimalRounding.to(1, fps));
      more.put("slow_frames", DecimalRounding.to(4, slow));
      more.put("why", String.join(", and ", why));
      journal.flag(end, SessionFlag.LOW_FRAME_RATE, more);
    }
  }
}
