package org.selectiverenderer.study.web;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.session.PlannedSession;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.study.session.TrialEvents;

/** Tells when blocks of trials begin and end, and the order of their trials, in a journal. */
final class WebBlockEvents {
  private final Study study;
  private final PlannedSession planned;
  private final Set<String> begun = new HashSet<>();

  /**
   * Prepares to tell.
   *
   * @param planned what the plan has for the session's place
   */
  WebBlockEvents(Study study, PlannedSession planned) {
    this.study = study;
    this.planned = planned;
  }

  /** Tells before the first record of a block, and of each of its rounds, that they begin. */
  void began(WebRecord record, WebSessionJournal journal) {
    if (record.step() instanceof SessionStep.Block block) {
      began(block.id(), journal);
    } else if (record.step() instanceof SessionStep.OneTrial one) {
      Trial trial = one.trial();
      began(trial.block(), journal);
      if (begun.add(trial.block() + "/" + trial.round())) {
        order(trial)
            .ifPresent(
                order -> {
                  Map<String, Object> members =
                      TrialEvents.order(trial.block(), trial.round(), order);
                  members.remove("step"); // the journal itself tells it
                  journal.add(0, "trial-order", trial.block(), members);
                });
      }
    }
  }

  private void began(String block, WebSessionJournal journal) {
    if (begun.add(block)) {
      journal.add(0, "step-began", block, Map.of("run", 1));
    }
  }

  /** Returns the order of a round; empty if the plan of the participant was another one. */
  private Optional<List<Trial>> order(Trial trial) {
    Optional<TrialBlock> block =
        study.design().blocks().stream()
            .filter(known -> known.name().equals(trial.block()))
            .findFirst();
    if (block.isEmpty() || block.get().staircase().isPresent()) {
      return Optional.empty();
    }
    try {
      List<Trial> order = planned.trials(study, block.get(), trial.round());
      return Optional.of(order)
          .filter(
              trials ->
                  trial.number() <= trials.size() && same(trials.get(trial.number() - 1), trial));
    } catch (IllegalArgumentException e) {
      return Optional.empty(); // The study has changed since.
    }
  }

  /** Returns whether a trial is the planned one, and its line still has the stimulus. */
  private static boolean same(Trial planned, Trial trial) {
    return planned.key().equals(trial.key())
        && StimulusRows.cleaned(planned.stimulus()).equals(trial.stimulus());
  }

  /**
   * Tells that a block is over.
   *
   * @param finished ids of the steps and trials that are over
   */
  void finished(WebRecord record, WebSessionJournal journal, Set<String> finished) {
    String block = record.step().id();
    long trials = finished.stream().filter(id -> id.startsWith(block + "-")).count();
    if (record.failed()) {
      journal.flag(record.seconds(), SessionFlag.PRACTICE_FAILED, Map.of());
    }
    journal.add(record.seconds(), "step-finished", block, Map.of("trials", trials));
  }
}
