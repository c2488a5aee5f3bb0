package org.selectiverenderer.validation;

import java.util.List;

/**
 * A group of related rules with the checks that find their violations.
 *
 * @param title heading in lists of rules
 * @param rules the rules in the order of their ids
 */
public record RuleGroup(
    String title,
    List<Rule> rules,
    List<FileCheck> fileChecks,
    List<SceneCheck> sceneChecks,
    List<CrossSceneCheck> runChecks) {
  /** Makes defensive copies, so that the record is immutable. */
  public RuleGroup {
    rules = List.copyOf(rules);
    fileChecks = List.copyOf(fileChecks);
    sceneChecks = List.copyOf(sceneChecks);
    runChecks = List.copyOf(runChecks);
  }

  /** Creates a group without checks of whole runs. */
  public RuleGroup(
      String title, List<Rule> rules, List<FileCheck> fileChecks, List<SceneCheck> sceneChecks) {
    this(title, rules, fileChecks, sceneChecks, List.of());
  }
}
