package org.selectiverenderer.study.design;

import java.util.List;
import java.util.Optional;

/**
 * The design of a study.
 *
 * @param factors the factors; none in a study that has conditions
 * @param groups the groups of participants, at least one
 * @param blocks the blocks of trials, in order; none in a study whose areas are shown once each
 */
public record StudyDesign(List<Factor> factors, List<StudyGroup> groups, List<TrialBlock> blocks) {
  public StudyDesign {
    factors = List.copyOf(factors);
    groups = List.copyOf(groups);
    blocks = List.copyOf(blocks);
  }

  /** Returns the group with a name. */
  public Optional<StudyGroup> group(String name) {
    return groups.stream().filter(group -> group.name().equals(name)).findFirst();
  }
}
