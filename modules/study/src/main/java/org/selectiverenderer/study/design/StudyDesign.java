package org.selectiverenderer.study.design;

import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * The design of a study.
 *
 * @param factors the factors; none in a study that has conditions
 * @param groups the groups of participants, at least one
 * @param blocks the blocks of trials, in order; none in a study whose areas are shown once each
 * @param analyses what is planned to be analysed, in order
 */
public record StudyDesign(
    List<Factor> factors,
    List<StudyGroup> groups,
    List<TrialBlock> blocks,
    List<PlannedAnalysis> analyses) {
  public StudyDesign {
    factors = List.copyOf(factors);
    groups = List.copyOf(groups);
    blocks = List.copyOf(blocks);
    analyses = List.copyOf(analyses);
  }

  /** A design without planned analyses. */
  public StudyDesign(List<Factor> factors, List<StudyGroup> groups, List<TrialBlock> blocks) {
    this(factors, groups, blocks, List.of());
  }

  /** Returns the design with planned analyses. */
  public StudyDesign with(List<PlannedAnalysis> planned) {
    return new StudyDesign(factors, groups, blocks, planned);
  }

  /** Returns the names of the factors, which are columns of the table of trials. */
  public List<String> factorNames() {
    return factors.stream().map(Factor::name).toList();
  }

  /** Returns the columns of all stimulus lists that are not factors, in their order. */
  public Set<String> stimulusColumns() {
    Set<String> columns = new LinkedHashSet<>();
    blocks.forEach(block -> block.stimuli().ifPresent(list -> columns.addAll(list.columns())));
    factorNames().forEach(columns::remove);
    return columns;
  }

  /** Returns the sound files of the instructions. */
  public List<Path> audio() {
    return blocks.stream()
        .flatMap(block -> block.phases().stream())
        .flatMap(StudyDesign::audio)
        .distinct()
        .toList();
  }

  private static Stream<Path> audio(TrialPhase phase) {
    return phase instanceof TrialPhase.Instruction instruction
        ? instruction.audio().stream()
        : phase instanceof TrialPhase.Repeat repeat
            ? repeat.phases().stream().flatMap(StudyDesign::audio)
            : Stream.of();
  }

  /** Returns the group with a name. */
  public Optional<StudyGroup> group(String name) {
    return groups.stream().filter(group -> group.name().equals(name)).findFirst();
  }
}
