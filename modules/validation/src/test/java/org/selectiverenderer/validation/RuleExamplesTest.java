package org.selectiverenderer.validation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;

/** The examples that explain a rule: the bad one has it, the good one has not. */
class RuleExamplesTest {
  /** About files, sizes and settings, which an example can only describe; found by the enricher. */
  private static final List<String> DESCRIBED =
      List.of("SR003", "SR004", "SR008", "SR009", "SR208", "SR3", "SR5");

  static Stream<Rule> rules() {
    return RuleCatalogue.standard().rules().stream()
        .filter(rule -> DESCRIBED.stream().noneMatch(rule.id()::startsWith));
  }

  @ParameterizedTest
  @MethodSource("rules")
  void theBadOneHasItAndTheGoodOneHasNot(Rule rule) throws IOException {
    assertThat(found(rule.bad())).as(rule.bad()).contains(rule.id());
    assertThat(found(rule.good())).as(rule.good()).doesNotContain(rule.id());
  }

  private static List<String> found(String example) throws IOException {
    boolean whole =
        example.startsWith("<?xml") || example.startsWith("#") || example.startsWith("{");
    String scene =
        whole
            ? example
            : "<?xml version='1.0' encoding='UTF-8'?>\n<X3D profile='Full' version='4.0'>\n<Scene>\n"
                + example
                + "\n</Scene>\n</X3D>\n";
    byte[] bytes = scene.getBytes(StandardCharsets.UTF_8);
    Path base = Path.of("");
    return new Validator(RuleCatalogue.standard(), ValidationSettings.standard(), base)
            .validate(List.of(SourceFile.of(base.resolve("example"), "example", bytes)))
            .findings()
            .stream()
            .map(finding -> finding.rule().id())
            .toList();
  }
}
