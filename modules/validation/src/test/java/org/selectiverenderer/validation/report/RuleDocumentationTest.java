package org.selectiverenderer.validation.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.run.RuleCatalogue;

class RuleDocumentationTest {
  private static final RuleCatalogue RULES = RuleCatalogue.standard();

  /** {@code mvn test -Dtest=RuleDocumentationTest -Drules.write=true} writes the page anew. */
  @Test
  void thePageOfRulesIsUpToDate() throws IOException {
    Path file = Path.of("docs/rules.md");
    String page = new RuleDocumentation(RULES).page();
    if (Boolean.getBoolean("rules.write")) {
      Files.writeString(file, page, StandardCharsets.UTF_8);
    }
    assertThat(Files.readString(file, StandardCharsets.UTF_8).replace("\r\n", "\n"))
        .as(
            "docs/rules.md; to write it anew: mvn test -Dtest=RuleDocumentationTest -Drules.write=true")
        .isEqualTo(page);
  }

  @Test
  void theListHasALineForEachRule() {
    String list = new RuleDocumentation(RULES).list();
    assertThat(RULES.rules()).allMatch(rule -> list.contains("  " + rule.id() + "  "));
  }

  @Test
  void everyRuleIsExplained() {
    for (Rule rule : RULES.rules()) {
      assertThat(RuleDocumentation.explain(rule))
          .as(rule.id())
          .contains(rule.id(), "Bad:", "Good:", "Source: ");
      assertThat(rule.explanation()).as(rule.id()).isNotBlank();
      assertThat(rule.bad()).as(rule.id()).isNotBlank();
      assertThat(rule.good()).as(rule.id()).isNotBlank();
      assertThat(rule.reference()).as(rule.id()).isNotBlank();
    }
  }

  @Test
  void idsAreInOrderAndUnique() {
    assertThat(RULES.rules().stream().map(Rule::id)).isSorted().doesNotHaveDuplicates();
  }
}
