package org.selectiverenderer.app.rehearsal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.StringJoiner;
import java.util.TreeMap;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.QualityRule;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialSequencer;

/**
 * What a participant sees at the begin of an exposure.
 *
 * @param step name of the area or block, or {@code practice}
 * @param viewpoint DEF of the Viewpoint; empty for the first of the scene
 * @param choices the {@code whichChoice} of Switches by DEF
 * @param qualities what decides the levels of qualities, where the condition does not
 */
record StudyView(
    String step,
    Path scene,
    String viewpoint,
    Condition condition,
    Map<String, Integer> choices,
    Map<Quality, QualityRule> qualities) {

  StudyView {
    qualities = Map.copyOf(qualities);
    choices = Map.copyOf(choices);
  }

  /** Returns the different views of a study, in order. */
  static List<StudyView> of(Study study) {
    Set<StudyView> views = new LinkedHashSet<>();
    study
        .practice()
        .ifPresent(
            practice ->
                views.add(
                    new StudyView(
                        "practice",
                        practice.scene(),
                        practice.viewpoint(),
                        Condition.HIGH,
                        Map.of(),
                        study.qualities())));
    for (StudyGroup group : study.design().groups()) {
      if (study.design().blocks().isEmpty()) {
        for (Study.Area area : study.areas()) {
          study
              .scene()
              .ifPresent(
                  scene ->
                      views.add(
                          new StudyView(
                              area.name(),
                              scene,
                              area.viewpoint(),
                              group.condition(),
                              group.settings().choices(),
                              study.qualities(group.settings()))));
        }
      }
      for (TrialBlock block : study.design().blocks()) {
        new TrialSequencer(block, group, study.seed())
            .trials(0, 1)
            .orElse(List.of())
            .forEach(trial -> views.addAll(of(study, trial)));
      }
    }
    return List.copyOf(views);
  }

  private static List<StudyView> of(Study study, Trial trial) {
    List<StudyView> views = new ArrayList<>();
    Map<String, Integer> choices = new LinkedHashMap<>(trial.settings().choices());
    trial.phases().forEach(phase -> add(study, trial, phase, choices, views));
    return views;
  }

  private static void add(
      Study study,
      Trial trial,
      TrialPhase phase,
      Map<String, Integer> choices,
      List<StudyView> views) {
    if (phase instanceof TrialPhase.Repeat repeat) {
      repeat.phases().forEach(each -> add(study, trial, each, choices, views));
    } else if (phase instanceof TrialPhase.Exposure exposure && study.scene(trial).isPresent()) {
      Map<String, Integer> own = new LinkedHashMap<>(choices);
      exposure.choices().forEach((name, choice) -> number(own, name, choice));
      views.add(
          new StudyView(
              trial.block(),
              study.scene(trial).get(),
              study.viewpoint(trial).orElse(""),
              trial.settings().condition().orElse(Condition.HIGH),
              own,
              study.qualities(trial.settings())));
    }
  }

  private static void number(Map<String, Integer> choices, String name, String choice) {
    if (choice.strip().matches("-?\\d{1,9}")) {
      choices.put(name, Integer.parseInt(choice.strip()));
    }
  }

  /** Describes the view: step, condition, viewpoint, choices. */
  String title() {
    StringJoiner title = new StringJoiner(", ");
    title.add(step).add(condition.spelling()).add(String.valueOf(scene.getFileName()));
    if (!viewpoint.isEmpty()) {
      title.add("from " + viewpoint);
    }
    new TreeMap<>(choices).forEach((name, choice) -> title.add(name + " = " + choice));
    new TreeMap<>(qualities)
        .forEach((quality, rule) -> title.add(quality.spelling() + " " + rule.spelling()));
    return title.toString();
  }
}
