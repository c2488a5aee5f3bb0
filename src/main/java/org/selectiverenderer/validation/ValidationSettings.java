package org.selectiverenderer.validation;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.x3d.files.ContentAccess;

/**
 * What a user decides.
 *
 * @param ignored ids of rules, or beginnings of ids ({@code SR2} for a group)
 * @param severities by id of rule, instead of the rule's own
 * @param megabytes that a scene and all its files may have
 * @param access what scenes may name besides their own files
 * @param file that they were read from; null for none
 */
public record ValidationSettings(
    Set<String> ignored,
    Map<String, Severity> severities,
    List<Budget> budgets,
    double megabytes,
    ContentAccess access,
    @Nullable Path file) {
  /** Keeps copies, so that it stays as it is. */
  public ValidationSettings {
    ignored = Set.copyOf(ignored);
    severities = Map.copyOf(severities);
    budgets = List.copyOf(budgets);
  }

  /** Some three times what the thesis's apartment has. */
  public static final double MEGABYTES = 100;

  /** All rules as they are, no budgets. */
  public static ValidationSettings standard() {
    return new ValidationSettings(
        Set.of(), Map.of(), List.of(), MEGABYTES, ContentAccess.none(), null);
  }

  /** Whether findings of a rule are not wanted. */
  public boolean ignores(String id) {
    return ignored.stream().anyMatch(id::startsWith);
  }

  /** The same, with more rules ignored. */
  public ValidationSettings ignoring(Set<String> more) {
    Set<String> all = new HashSet<>(ignored);
    all.addAll(more);
    return new ValidationSettings(all, severities, budgets, megabytes, access, file);
  }

  /** The same for scenes that may name other files besides their own. */
  public ValidationSettings allowing(ContentAccess wanted) {
    return new ValidationSettings(ignored, severities, budgets, megabytes, wanted, file);
  }

  /** The severity that findings of a rule are to have. */
  public Severity severity(Rule rule) {
    return severities.getOrDefault(rule.id(), rule.severity());
  }
}
