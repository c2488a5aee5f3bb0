package org.selectiverenderer.validation.settings;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.json.JsonArrayEditor;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.validation.CostBudget;
import org.selectiverenderer.validation.CostKind;
import org.selectiverenderer.validation.ReportFileNames;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.run.RuleCatalogue;

/**
 * Edits the budgets of a settings file. Everything else, including comments and white space, is
 * preserved; a file with faults is not changed.
 */
public final class BudgetSettingsEditor {
  private static final String KEY = "budgets";
  private static final String NEW = "{}\n";

  private final Path file;
  private final RuleCatalogue rules;

  /**
   * @param file the settings file, which need not exist yet
   * @param rules the rules that it may name
   */
  public BudgetSettingsEditor(Path file, RuleCatalogue rules) {
    this.file = file;
    this.rules = rules;
  }

  /**
   * Reads the settings; returns the default ones if there is no file.
   *
   * @return empty when the file has faults, which are reported to {@code problems}
   * @throws IOException if it cannot be read at all
   */
  public Optional<ValidationSettings> read(ProblemCollector problems) throws IOException {
    return Files.exists(file)
        ? new ValidationSettingsReader(file, rules).read(problems)
        : Optional.of(ValidationSettings.standard());
  }

  /** Returns the name of a scene's file for its budgets: relative to the settings file's folder. */
  public String named(Path scene) {
    Path folder = file.toAbsolutePath().normalize().getParent();
    return ReportFileNames.relative(scene, folder == null ? file : folder);
  }

  /**
   * Sets limits of a file's part and state; replaces those of the same kind, and leaves others.
   *
   * @throws IOException with a message of one line if the file has faults or cannot be written
   */
  public void put(CostBudget wanted) throws IOException {
    change(
        wanted,
        (list, at, known) -> {
          if (known.isEmpty()) {
            return list.added(json(wanted));
          }
          boolean there = known.get().limits().keySet().containsAll(wanted.limits().keySet());
          if (there && wanted.limits().size() == 1) {
            CostKind kind = wanted.limits().keySet().iterator().next();
            return list.with(at, kind.key(), Long.toString(wanted.limit(kind).orElseThrow()));
          }
          Map<CostKind, Long> all = new EnumMap<>(known.get().limits());
          all.putAll(wanted.limits());
          return rewritten(list, at, known.get(), all);
        });
  }

  /**
   * Removes limits of a file's part and state, if there are any, and the budget with its last one.
   *
   * @param unwanted the budget to remove from; its numbers are ignored
   * @throws IOException with a message of one line if the file has faults or cannot be written
   */
  public void remove(CostBudget unwanted) throws IOException {
    change(
        unwanted,
        (list, at, known) -> {
          if (known.isEmpty()) {
            return null;
          }
          Map<CostKind, Long> left = new EnumMap<>(known.get().limits());
          left.keySet().removeAll(unwanted.limits().keySet());
          return left.isEmpty() ? list.without(at) : rewritten(list, at, known.get(), left);
        });
  }

  /** Returns the text with a budget that has other limits, as the last of the list. */
  private static String rewritten(
      JsonArrayEditor list, int at, CostBudget known, Map<CostKind, Long> limits) {
    CostBudget other = new CostBudget(known.file(), known.scope(), known.schemas(), limits);
    return new JsonArrayEditor(list.without(at), KEY).added(json(other));
  }

  private interface Change {
    /**
     * @param at index of the budget in the list; -1 for none
     * @return null for no change
     */
    @org.jspecify.annotations.Nullable
    String of(JsonArrayEditor list, int at, Optional<CostBudget> known);
  }

  private void change(CostBudget budget, Change change) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    Optional<ValidationSettings> settings = read(problems);
    if (settings.isEmpty()) {
      throw new IOException(
          problems.list().get(0) + "; the budget is not saved: correct the settings file first");
    }
    String before = Files.exists(file) ? InputFileReader.text(file) : NEW;
    List<CostBudget> budgets = settings.get().budgets();
    int at = index(budgets, budget);
    Optional<CostBudget> known = at < 0 ? Optional.empty() : Optional.of(budgets.get(at));
    String after = change.of(new JsonArrayEditor(before, KEY), at, known);
    if (after != null && !after.equals(before)) {
      AtomicFileWriter.replace(file, after.getBytes(StandardCharsets.UTF_8));
    }
  }

  private static int index(List<CostBudget> budgets, CostBudget wanted) {
    for (int i = 0; i < budgets.size(); i++) {
      if (budgets.get(i).file().equals(wanted.file()) && same(budgets.get(i), wanted)) {
        return i;
      }
    }
    return -1;
  }

  /** Returns whether two budgets are for the same part and state, of whichever files. */
  public static boolean same(CostBudget one, CostBudget other) {
    return one.scope().equals(other.scope())
        && new HashSet<>(one.schemas()).equals(new HashSet<>(other.schemas()));
  }

  private static String json(CostBudget budget) {
    List<String> members = new ArrayList<>();
    if (!budget.file().isEmpty()) {
      members.add("\"file\": " + JsonTree.of(budget.file()));
    }
    if (!budget.scope().isEmpty()) {
      members.add("\"scope\": " + JsonTree.of(budget.scope()));
    }
    if (!budget.schemas().isEmpty()) {
      List<String> schemas =
          budget.schemas().stream().map(schema -> JsonTree.of(schema).toString()).toList();
      members.add("\"schemas\": [" + String.join(", ", schemas) + "]");
    }
    budget.limits().forEach((kind, most) -> members.add("\"" + kind.key() + "\": " + most));
    return "{" + String.join(", ", members) + "}";
  }
}
