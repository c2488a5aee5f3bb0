package org.selectiverenderer.validation.settings;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.json.JsonArrayEditor;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.validation.PolygonBudget;
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
   * Sets the budget of a file's part and state; replaces an existing one.
   *
   * @throws IOException with a message of one line if the file has faults or cannot be written
   */
  public void put(PolygonBudget wanted) throws IOException {
    change(
        wanted,
        (list, at) ->
            at < 0
                ? list.added(json(wanted))
                : list.with(at, "polygons", Long.toString(wanted.polygons())));
  }

  /**
   * Removes the budget of a file's part and state, if there is one.
   *
   * @param unwanted the budget to remove; its number of polygons is ignored
   * @throws IOException with a message of one line if the file has faults or cannot be written
   */
  public void remove(PolygonBudget unwanted) throws IOException {
    change(unwanted, (list, at) -> at < 0 ? null : list.without(at));
  }

  private interface Change {
    /**
     * @param at index of the budget in the list; -1 for none
     * @return null for no change
     */
    @org.jspecify.annotations.Nullable
    String of(JsonArrayEditor list, int at);
  }

  private void change(PolygonBudget budget, Change change) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    Optional<ValidationSettings> settings = read(problems);
    if (settings.isEmpty()) {
      throw new IOException(
          problems.list().get(0) + "; the budget is not saved: correct the settings file first");
    }
    String before = Files.exists(file) ? InputFileReader.text(file) : NEW;
    String after =
        change.of(new JsonArrayEditor(before, KEY), index(settings.get().budgets(), budget));
    if (after != null && !after.equals(before)) {
      AtomicFileWriter.replace(file, after.getBytes(StandardCharsets.UTF_8));
    }
  }

  private static int index(List<PolygonBudget> budgets, PolygonBudget wanted) {
    for (int i = 0; i < budgets.size(); i++) {
      if (budgets.get(i).file().equals(wanted.file()) && same(budgets.get(i), wanted)) {
        return i;
      }
    }
    return -1;
  }

  /** Returns whether two budgets are for the same part and state, of whichever files. */
  public static boolean same(PolygonBudget one, PolygonBudget other) {
    return one.scope().equals(other.scope())
        && new HashSet<>(one.schemas()).equals(new HashSet<>(other.schemas()));
  }

  private static String json(PolygonBudget budget) {
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
    members.add("\"polygons\": " + budget.polygons());
    return "{" + String.join(", ", members) + "}";
  }
}
