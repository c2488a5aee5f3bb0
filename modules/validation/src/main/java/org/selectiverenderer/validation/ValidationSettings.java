package org.selectiverenderer.validation;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.base.trust.PermissionRequests;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.OutsideRequests;

/**
 * The settings of a validation run.
 *
 * @param ignored ids of ignored rules, or prefixes of ids ({@code SR2} for a group)
 * @param severities severities that replace those of rules, by rule id
 * @param megabytes largest total size of a scene with all its files, in megabytes
 * @param access further folders and hosts that scenes may refer to
 * @param file the file that the settings were read from; null for none
 */
public record ValidationSettings(
    Set<String> ignored,
    Map<String, Severity> severities,
    List<CostBudget> budgets,
    double megabytes,
    ContentAccessPolicy access,
    @Nullable Path file) {
  /** Makes defensive copies, so that the record is immutable. */
  public ValidationSettings {
    ignored = Set.copyOf(ignored);
    severities = Map.copyOf(severities);
    budgets = List.copyOf(budgets);
  }

  /** The default size limit: about three times the size of the thesis's apartment. */
  public static final double MEGABYTES = 100;

  /** Returns the default settings: no ignored rules and no budgets. */
  public static ValidationSettings standard() {
    return new ValidationSettings(
        Set.of(), Map.of(), List.of(), MEGABYTES, ContentAccessPolicy.none(), null);
  }

  /** Returns the budgets that are not for the file of another scene, as paths and links go. */
  public List<CostBudget> budgets(Path scene) {
    return budgets.stream()
        .filter(budget -> budget.file().isEmpty() || same(beside(budget.file()), scene))
        .toList();
  }

  private Path beside(String name) {
    return file == null ? Path.of(name) : file.toAbsolutePath().resolveSibling(name);
  }

  private static boolean same(Path one, Path other) {
    return SourceFile.key(one).equals(SourceFile.key(other));
  }

  /** Returns whether a rule is ignored. */
  public boolean ignores(String id) {
    return ignored.stream().anyMatch(id::startsWith);
  }

  /** Returns the settings with more rules ignored. */
  public ValidationSettings ignoring(Set<String> more) {
    Set<String> all = new HashSet<>(ignored);
    all.addAll(more);
    return new ValidationSettings(all, severities, budgets, megabytes, access, file);
  }

  /** Returns the settings with other access rights of scenes. */
  public ValidationSettings allowing(ContentAccessPolicy wanted) {
    return new ValidationSettings(ignored, severities, budgets, megabytes, wanted, file);
  }

  /** Returns what the settings file asks for beyond its own folder and project. */
  public PermissionRequests permissions() {
    Path from = file == null ? Path.of("") : file;
    return new OutsideRequests(from)
        .access(file == null ? ContentAccessPolicy.none() : access)
        .requests();
  }

  /** Returns the severity of a rule's findings. */
  public Severity severity(Rule rule) {
    return severities.getOrDefault(rule.id(), rule.severity());
  }
}
