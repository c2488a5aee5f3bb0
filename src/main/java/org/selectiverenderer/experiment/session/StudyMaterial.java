package org.selectiverenderer.experiment.session;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.experiment.questionnaire.ItemsReader;
import org.selectiverenderer.experiment.questionnaire.QuestionItem;
import org.selectiverenderer.experiment.questionnaire.Screen;
import org.selectiverenderer.experiment.questionnaire.Wording;
import org.selectiverenderer.experiment.study.QuestionKind;
import org.selectiverenderer.experiment.study.Study;
import org.selectiverenderer.experiment.study.StudyReader;

/**
 * A study with all that its questionnaires ask, in their words.
 *
 * @param items by questionnaire, in the study's order
 */
public record StudyMaterial(
    Study study, Map<QuestionKind, List<QuestionItem>> items, Wording wording) {

  /**
   * Reads a study file and the files that it names.
   *
   * @return empty when there are faults, which are then in {@code problems}
   * @throws IOException if a file cannot be read at all
   */
  public static Optional<StudyMaterial> read(Path file, Problems problems) throws IOException {
    Optional<Study> study = StudyReader.read(file, problems);
    if (study.isEmpty()) {
      return Optional.empty();
    }
    Optional<Wording> wording = Wording.of(study.get().language(), study.get().folder(), problems);
    Map<QuestionKind, List<QuestionItem>> items = new EnumMap<>(QuestionKind.class);
    for (Study.Questionnaire questionnaire : study.get().questionnaires()) {
      ItemsReader.read(questionnaire, study.get().language(), problems)
          .ifPresent(found -> items.put(questionnaire.kind(), found));
    }
    boolean whole = items.size() == study.get().questionnaires().size();
    return wording
        .filter(words -> whole)
        .map(words -> new StudyMaterial(study.get(), items, words));
  }

  /** The steps of a session, in the order of the study's file. */
  public List<SessionStep> steps() {
    return steps(study.areas());
  }

  /**
   * The steps of a session, in order.
   *
   * @param areas all of the study's, in the order in which they are shown
   */
  List<SessionStep> steps(List<Study.Area> areas) {
    List<SessionStep> steps = new ArrayList<>();
    steps.add(new SessionStep.Form());
    study.practice().ifPresent(practice -> steps.add(new SessionStep.Practice(practice)));
    areas.forEach(area -> steps.add(new SessionStep.Exposure(area)));
    for (Study.Questionnaire questionnaire : study.questionnaires()) {
      QuestionKind kind = questionnaire.kind();
      for (String area : Screen.areas(items.getOrDefault(kind, List.of()))) {
        steps.add(new SessionStep.Questions(kind, area));
      }
    }
    return List.copyOf(steps);
  }

  /** What a participant is asked in a step. */
  public Screen screen(SessionStep.Questions step, String participant) {
    return Screen.of(
        step.kind(),
        step.area(),
        items.getOrDefault(step.kind(), List.of()),
        study.seed(),
        participant);
  }

  /** All screens of a participant. */
  public List<Screen> screens(String participant) {
    return steps().stream()
        .filter(SessionStep.Questions.class::isInstance)
        .map(step -> screen((SessionStep.Questions) step, participant))
        .toList();
  }
}
