package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.StimulusList;
import org.selectiverenderer.study.design.StudyDesign;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialSettings;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * A session that is no participant's: it begins at a step of the study, its times are shortened,
 * and its data goes to a folder of its own, so that nobody is assigned and nothing of it is
 * collected.
 */
public final class PreviewSession {
  /** Id of the participant of a preview. */
  public static final String PARTICIPANT = "preview";

  private PreviewSession() {}

  /**
   * Begins a preview.
   *
   * @param folder an empty folder, outside of the study's, for the data
   * @param from id of the first step; those before it count as finished
   * @param speed by which exposures, fades and phases are shorter, at least 1
   * @param unattended whether a simulated participant takes part
   * @param software name and version of the program
   * @throws IllegalArgumentException with a sentence if the study has no such step
   * @throws IOException if a file cannot be written
   */
  public static Session begin(
      LoadedStudy material,
      Path folder,
      String from,
      double speed,
      boolean unattended,
      String software,
      ProblemCollector problems)
      throws IOException {
    List<String> steps = material.steps().stream().map(SessionStep::id).toList();
    if (!steps.contains(from)) {
      throw new IllegalArgumentException(
          "the study has no step '%s'; its steps are %s".formatted(from, String.join(", ", steps)));
    }
    Path file = folder.resolve(String.valueOf(material.study().file().getFileName()));
    Files.copy(material.study().file(), file);
    LoadedStudy apart =
        new LoadedStudy(
            shortened(material.study(), file, speed),
            material.form(),
            material.asked(),
            material.wording());
    Session session =
        Session.begin(
            apart,
            PARTICIPANT,
            1,
            new SessionOptions(
                Optional.empty(),
                OptionalDouble.empty(),
                unattended,
                Optional.of(new TrackerSpec.None()),
                software),
            problems);
    try {
      for (SessionStep step : apart.steps()) {
        if (step.id().equals(from)) {
          break;
        }
        session.began(step, false);
        if (step instanceof SessionStep.Form) {
          session.assign("");
        }
        session.journal().keep("step-finished", Map.of("step", step.id()));
      }
      return session;
    } catch (IOException | RuntimeException e) {
      session.close();
      throw e;
    }
  }

  private static Study shortened(Study study, Path file, double speed) {
    return new Study(
        file,
        study.name(),
        study.scene(),
        new StudyDesign(
            study.design().factors().stream().map(factor -> shortened(factor, speed)).toList(),
            study.design().groups().stream()
                .map(
                    group ->
                        new StudyGroup(
                            group.name(), group.levels(), shortened(group.settings(), speed)))
                .toList(),
            study.design().blocks().stream().map(block -> shortened(block, speed)).toList()),
        study.participants(),
        study.assignment(),
        study.block(),
        study.seed(),
        study.practice(),
        study.areas().stream()
            .map(
                area ->
                    new Study.Area(
                        area.name(),
                        area.viewpoint(),
                        area.seconds() / speed,
                        area.stay(),
                        area.within()))
            .toList(),
        study.fade() / speed,
        study.display(),
        study.tracker(),
        study.mouse(),
        study.language(),
        study.languages(),
        study.questionnaires(),
        study.quality(),
        study.course(),
        study.streams(),
        study.access(),
        study.mute(),
        Optional.empty(),
        study.transition(),
        study.qualities());
  }

  private static OptionalDouble shortened(OptionalDouble seconds, double speed) {
    return seconds.isPresent()
        ? OptionalDouble.of(seconds.getAsDouble() / speed)
        : OptionalDouble.empty();
  }

  private static Factor shortened(Factor factor, double speed) {
    return new Factor(
        factor.name(),
        factor.scope(),
        factor.levels().stream()
            .map(level -> new Factor.Level(level.name(), shortened(level.settings(), speed)))
            .toList());
  }

  private static TrialSettings shortened(TrialSettings settings, double speed) {
    return new TrialSettings(
        settings.condition(),
        settings.choices(),
        settings.scene(),
        settings.area(),
        settings.viewpoint(),
        shortened(settings.seconds(), speed),
        settings.headlight(),
        settings.mode(),
        settings.ipd(),
        settings.transition(),
        settings.qualities());
  }

  private static TrialBlock shortened(TrialBlock block, double speed) {
    return new TrialBlock(
        block.name(),
        block.factors().stream().map(factor -> shortened(factor, speed)).toList(),
        block
            .stimuli()
            .map(
                list ->
                    new StimulusList(
                        list.file(),
                        list.columns(),
                        list.rows().stream()
                            .map(
                                row ->
                                    new StimulusList.Stimulus(
                                        row.line(), row.cells(), shortened(row.settings(), speed)))
                            .toList())),
        block.pairing(),
        block.repetitions(),
        block.order(),
        block.runs(),
        shortened(block.settings(), speed),
        block.phases().stream().map(phase -> shortened(phase, speed)).toList(),
        block.rest(),
        block.practice(),
        block.staircase());
  }

  private static TrialPhase shortened(TrialPhase phase, double speed) {
    if (phase instanceof TrialPhase.Fixation fixation) {
      return new TrialPhase.Fixation(fixation.seconds() / speed);
    } else if (phase instanceof TrialPhase.Blank blank) {
      return new TrialPhase.Blank(shortened(blank.seconds(), speed), blank.response());
    } else if (phase instanceof TrialPhase.Exposure exposure) {
      return new TrialPhase.Exposure(
          shortened(exposure.seconds(), speed),
          exposure.choices(),
          exposure.response(),
          exposure.sceneEnds());
    } else if (phase instanceof TrialPhase.Feedback feedback) {
      return new TrialPhase.Feedback(
          feedback.correct(), feedback.wrong(), feedback.missing(), feedback.seconds() / speed);
    } else if (phase instanceof TrialPhase.Repeat repeat) {
      return new TrialPhase.Repeat(
          repeat.phases().stream().map(each -> shortened(each, speed)).toList(), repeat.most());
    }
    return phase;
  }
}
