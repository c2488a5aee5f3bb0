package org.selectiverenderer.validation.settings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.validation.CostBudget;
import org.selectiverenderer.validation.CostKind;
import org.selectiverenderer.validation.run.RuleCatalogue;

/** Budgets are changed in the text that a person has written. */
class BudgetSettingsEditorTest {
  private static final CostBudget OFFICE = new CostBudget("Office", List.of(), 170000);
  private static final CostBudget DESK = new CostBudget("Office", List.of("Desk", "Chair"), 70000);

  @TempDir Path folder;

  private Path file() {
    return folder.resolve("validate.json");
  }

  private BudgetSettingsEditor with(String text) throws IOException {
    Files.writeString(file(), text);
    return budgets();
  }

  private BudgetSettingsEditor budgets() {
    return new BudgetSettingsEditor(file(), RuleCatalogue.standard());
  }

  private String text() throws IOException {
    return Files.readString(file());
  }

  private List<CostBudget> read() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    List<CostBudget> read = budgets().read(problems).orElseThrow().budgets();
    assertThat(problems.list()).isEmpty();
    return read;
  }

  @Test
  void aFileIsMadeWithItsFirstBudgetAndKeepsTheirOrder() throws IOException {
    assertThat(read()).isEmpty();
    budgets().put(OFFICE);
    assertThat(text())
        .isEqualTo(
            """
            {
              "budgets": [
                {"scope": "Office", "polygons": 170000}
              ]
            }
            """);
    budgets().put(DESK);
    budgets().put(new CostBudget("", List.of(), 9));
    assertThat(read()).containsExactly(OFFICE, DESK, new CostBudget("", List.of(), 9));
  }

  @Test
  void onlyTheNumberOfABudgetThatIsThereChanges() throws IOException {
    String before =
        """
        // ours
        {
          "ignore": ["SR207"],  /* on purpose */
          "budgets": [
            {"polygons": %s, "scope": "Office"}, // the room
            { "scope" : "Office",
              "schemas":["Chair" , "Desk"], "polygons" : 5 },
          ],
          "megabytes": 5.0e1,
        }
        """;
    BudgetSettingsEditor file = with(before.formatted("170000"));
    file.put(new CostBudget("Office", List.of(), 42));
    assertThat(text()).isEqualTo(before.formatted("42"));
    file.put(new CostBudget("Office", List.of("Desk", "Chair"), 123456));
    assertThat(text()).isEqualTo(before.formatted("42").replace(": 5 }", ": 123456 }"));
    file.put(new CostBudget("Kitchen", List.of(), 7));
    assertThat(read()).hasSize(3);
    assertThat(text()).contains("},\n    {\"scope\": \"Kitchen\", \"polygons\": 7},\n  ],");
  }

  @Test
  void limitsOfOtherThingsStayWhenOneOfPolygonsComesAndGoes() throws IOException {
    String before = "{\"budgets\": [{\"scope\": \"Office\", \"drawCalls\": 9}]}";
    BudgetSettingsEditor file = with(before);
    file.put(OFFICE);
    CostBudget both =
        new CostBudget(
            "", "Office", List.of(), Map.of(CostKind.POLYGONS, 170000L, CostKind.DRAW_CALLS, 9L));
    assertThat(read()).containsExactly(both);
    file.put(new CostBudget("Office", List.of(), 5));
    assertThat(text()).contains("\"polygons\": 5, \"drawCalls\": 9");
    file.remove(OFFICE);
    assertThat(read())
        .containsExactly(new CostBudget("", "Office", List.of(), Map.of(CostKind.DRAW_CALLS, 9L)));
    file.remove(OFFICE);
    assertThat(read()).hasSize(1);
  }

  @Test
  void budgetsAreTakenAwayWithTheirCommas() throws IOException {
    BudgetSettingsEditor file = budgets();
    file.put(OFFICE);
    String one = text();
    file.put(DESK);
    String two = text();
    file.remove(DESK);
    assertThat(text()).isEqualTo(one);
    file.remove(DESK);
    assertThat(text()).isEqualTo(one);
    Files.writeString(file(), two);
    file.remove(OFFICE);
    assertThat(read()).containsExactly(DESK);
    file.remove(DESK);
    assertThat(read()).isEmpty();
    file.put(OFFICE);
    assertThat(read()).containsExactly(OFFICE);
  }

  @Test
  void budgetsOfAFileAreOthersThanThoseOfEveryScene() throws IOException {
    BudgetSettingsEditor file = budgets();
    file.put(OFFICE);
    String name = file.named(folder.resolve("rooms").resolve("a b.x3d"));
    assertThat(name).isEqualTo("rooms/a b.x3d");
    CostBudget own = new CostBudget(name, "Office", List.of(), 7);
    file.put(own);
    assertThat(read()).containsExactly(OFFICE, own);
    assertThat(text())
        .contains("{\"file\": \"rooms/a b.x3d\", \"scope\": \"Office\", \"polygons\": 7}");
    CostBudget more = new CostBudget(name, "Office", List.of(), 8);
    file.put(more);
    assertThat(read()).containsExactly(OFFICE, more);
    file.remove(OFFICE);
    assertThat(read()).containsExactly(more);
  }

  @Test
  void aListIsMadeAmongOtherKeysAndLineEndsStay() throws IOException {
    BudgetSettingsEditor file = with("\uFEFF{\r\n  \"megabytes\": 50\r\n}\r\n");
    file.put(OFFICE);
    assertThat(text().replace("\r\n", "")).doesNotContain("\n").startsWith("\uFEFF{");
    assertThat(text()).endsWith("\"megabytes\": 50\r\n}\r\n");
    assertThat(read()).containsExactly(OFFICE);
  }

  @Test
  void namesAreQuotedAndBracesInTextsAreNoBraces() throws IOException {
    CostBudget odd = new CostBudget("a\"}b", List.of("],\\"), 1);
    BudgetSettingsEditor file = with("{\"budgets\": [{\"scope\": \"}]\", \"polygons\": 3}]}");
    file.put(odd);
    file.put(new CostBudget("}]", List.of(), 12));
    assertThat(read()).containsExactly(new CostBudget("}]", List.of(), 12), odd);
  }

  @Test
  void aFaultyFileStaysAsItIs() throws IOException {
    BudgetSettingsEditor file = with("{\"budgets\": [{\"scope\": \"Office\"}]}");
    assertThatThrownBy(() -> file.put(OFFICE))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("validate.json:1:14")
        .hasMessageContaining("the budget is not saved");
    assertThat(text()).isEqualTo("{\"budgets\": [{\"scope\": \"Office\"}]}");
  }
}
