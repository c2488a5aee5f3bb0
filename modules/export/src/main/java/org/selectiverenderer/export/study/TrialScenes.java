package org.selectiverenderer.export.study;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PlannedSession;

/** Finds the scenes that the trials of a study show, and what the trials need of each. */
final class TrialScenes {
  /** The plan may have so many trials; the page loads all of it. */
  private static final int MOST_TRIALS = 2_000_000;

  private final LoadedStudy material;
  private final Map<Path, Needs> scenes = new LinkedHashMap<>();

  /**
   * The trials need these nodes of a scene.
   *
   * @param viewpoints DEFs of Viewpoints
   * @param switches DEFs of Switches whose choices trials set
   */
  record Needs(Set<String> viewpoints, Set<String> switches) {}

  /**
   * Finds the scenes.
   *
   * @throws IllegalArgumentException if the trials have no order or are too many, with a sentence
   */
  TrialScenes(LoadedStudy material) {
    this.material = material;
    List<TrialBlock> blocks = material.study().design().blocks();
    long number = 0;
    for (PlannedSession session :
        blocks.isEmpty() ? List.<PlannedSession>of() : PlannedSession.all(material)) {
      for (TrialBlock block : blocks) {
        int rounds = block.practice().map(TrialBlock.PracticeCriterion::rounds).orElse(1);
        for (int round = 1; round <= rounds; round++) { // each has an order of its own
          List<Trial> trials = session.trials(material.study(), block, round);
          number += trials.size();
          if (number > MOST_TRIALS) {
            throw new IllegalArgumentException(
                "the plan has more than %d trials, which the page cannot load; plan fewer \"participants\""
                    .formatted(MOST_TRIALS));
          }
          trials.forEach(this::add);
        }
      }
    }
  }

  private void add(Trial trial) {
    Needs needs =
        scenes.computeIfAbsent(
            TrialDescription.scene(material, trial),
            scene -> new Needs(new TreeSet<>(), new TreeSet<>()));
    material.study().viewpoint(trial).ifPresent(needs.viewpoints()::add);
    needs.switches().addAll(trial.settings().choices().keySet());
    trial.phases().forEach(phase -> add(phase, needs));
  }

  private static void add(TrialPhase phase, Needs needs) {
    if (phase instanceof TrialPhase.Exposure exposure) {
      needs.switches().addAll(exposure.choices().keySet());
    } else if (phase instanceof TrialPhase.Repeat repeat) {
      repeat.phases().forEach(inner -> add(inner, needs));
    }
  }

  /** Returns what trials need of each scene, by its file. */
  Map<Path, Needs> needs() {
    return scenes;
  }
}
