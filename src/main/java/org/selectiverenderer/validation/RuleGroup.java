package org.selectiverenderer.validation;

import java.util.List;

/**
 * Rules of one kind and the checks that find what they say.
 *
 * @param title for the list of rules
 * @param rules in the order of their ids
 */
public record RuleGroup(
    String title,
    List<Rule> rules,
    List<FileCheck> fileChecks,
    List<SceneCheck> sceneChecks,
    List<RunCheck> runChecks) {
  /** Keeps copies, so that it stays as it is. */
  public RuleGroup {
    rules = List.copyOf(rules);
    fileChecks = List.copyOf(fileChecks);
    sceneChecks = List.copyOf(sceneChecks);
    runChecks = List.copyOf(runChecks);
  }

  /** Without checks of whole runs. */
  public RuleGroup(
      String title, List<Rule> rules, List<FileCheck> fileChecks, List<SceneCheck> sceneChecks) {
    this(title, rules, fileChecks, sceneChecks, List.of());
  }
}
