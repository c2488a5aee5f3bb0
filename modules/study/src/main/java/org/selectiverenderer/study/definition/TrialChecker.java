package org.selectiverenderer.study.definition;

import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.Consumer;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialSequencer;

/**
 * Checks that all trials of a study can be shown: that each has a scene, a viewpoint and a
 * duration, and that the scene has what they name.
 */
final class TrialChecker {
  /** Number of trials of a block that are checked; more take too long. */
  private static final int MOST_CHECKED = 50_000;

  private final Study study;
  private final BiPredicate<Path, String> lacks;
  private final BiPredicate<Path, String> lacksSwitch;
  private final Set<String> faults = new LinkedHashSet<>();

  /**
   * @param lacks whether a scene has no node with a DEF, as far as that can be seen
   * @param lacksSwitch the same of a scene with what it inlines
   */
  TrialChecker(
      Study study, BiPredicate<Path, String> lacks, BiPredicate<Path, String> lacksSwitch) {
    this.study = study;
    this.lacks = lacks;
    this.lacksSwitch = lacksSwitch;
  }

  /** Passes each fault on once. */
  void check(Consumer<String> fault) {
    for (TrialBlock block : study.design().blocks()) {
      for (StudyGroup group : study.design().groups()) {
        TrialSequencer sequencer = new TrialSequencer(block, group, study.seed());
        // Other turns have other trials where pairs rotate, and other chances where runs are short.
        boolean differ = block.pairing() == TrialBlock.Pairing.ROTATED || !block.runs().isEmpty();
        int turns = differ ? 1 + (study.participants() - 1) / study.design().groups().size() : 1;
        int checked = 0;
        for (int turn = 0; turn < turns && checked < MOST_CHECKED; turn++) {
          Optional<List<Trial>> trials = sequencer.trials(turn, 1);
          if (trials.isEmpty()) {
            faults.add(
                "no order of the trials of the block %s keeps \"at_most_in_a_row\"; allow more in a row"
                    .formatted(block.name()));
            break;
          }
          trials.get().forEach(this::check);
          checked += trials.get().size();
        }
      }
    }
    faults.forEach(fault);
  }

  private void check(Trial trial) {
    Optional<String> area = trial.settings().area();
    Optional<Study.Area> place = area.flatMap(study::area);
    if (area.isPresent() && place.isEmpty()) {
      faults.add(
          "a trial of the block %s is in the area %s, which the study's \"areas\" do not have"
              .formatted(trial.block(), area.get()));
      return;
    }
    boolean exposes = trial.phases().stream().anyMatch(TrialChecker::exposes);
    Optional<Path> scene = study.scene(trial);
    if (exposes && scene.isEmpty()) {
      faults.add(
          "the block %s shows a scene and has none: give the study, a level or the stimuli a \"scene\""
              .formatted(trial.block()));
      return;
    }
    trial.phases().forEach(phase -> duration(trial, phase));
    scene.ifPresent(file -> names(trial, file));
  }

  private void names(Trial trial, Path scene) {
    study
        .viewpoint(trial)
        .filter(name -> lacks.test(scene, name))
        .ifPresent(
            name ->
                faults.add(
                    "the scene %s has no Viewpoint with the DEF '%s', which the block %s needs"
                        .formatted(scene.getFileName(), name, trial.block())));
    Set<String> switches = new LinkedHashSet<>(trial.settings().choices().keySet());
    trial.phases().forEach(phase -> switches(phase, switches));
    switches.stream()
        .filter(name -> lacksSwitch.test(scene, name))
        .forEach(
            name ->
                faults.add(
                    "the scene %s has no Switch with the DEF '%s', whose choice the block %s sets"
                        .formatted(scene.getFileName(), name, trial.block())));
  }

  private static void switches(TrialPhase phase, Set<String> names) {
    if (phase instanceof TrialPhase.Exposure exposure) {
      names.addAll(exposure.choices().keySet());
    } else if (phase instanceof TrialPhase.Repeat repeat) {
      repeat.phases().forEach(each -> switches(each, names));
    }
  }

  private static boolean exposes(TrialPhase phase) {
    return phase instanceof TrialPhase.Exposure
        || phase instanceof TrialPhase.Repeat repeat
            && repeat.phases().stream().anyMatch(TrialChecker::exposes);
  }

  private void duration(Trial trial, TrialPhase phase) {
    if (phase instanceof TrialPhase.Repeat repeat) {
      repeat.phases().forEach(each -> duration(trial, each));
    } else if (phase instanceof TrialPhase.Exposure exposure
        && study.seconds(trial, exposure).isEmpty()
        && exposure.response().keys().isEmpty()
        && !exposure.sceneEnds()) {
      faults.add(
          "an exposure of the block %s never ends: give it \"seconds\", \"keys\", or \"until\": \"scene\""
              .formatted(trial.block()));
    }
  }
}
