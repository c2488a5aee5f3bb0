package org.selectiverenderer.validation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The examples of the rules show what they should. */
class ExamplesTest {
  static Stream<Rule> rules() {
    return RuleCatalogue.standard().rules().stream()
        .filter(rule -> rule.id().matches("SR[245].*"))
        .filter(rule -> !rule.bad().isEmpty());
  }

  @ParameterizedTest
  @MethodSource("rules")
  void theBadOneHasItAndTheGoodOneDoesNot(Rule rule) throws IOException {
    assertThat(ids(rule.bad())).contains(rule.id());
    assertThat(ids(rule.good())).doesNotContain(rule.id());
  }

  private static List<String> ids(String scene) throws IOException {
    String file = "<X3D profile='Immersive' version='4.0'><Scene>\n" + scene + "\n</Scene></X3D>";
    SourceFile source =
        new SourceFile(
            Path.of("example.x3d"), "example.x3d", file.getBytes(StandardCharsets.UTF_8));
    return new Validator(RuleCatalogue.standard(), ValidationSettings.standard(), Path.of(""))
        .validate(List.of(source)).findings().stream().map(finding -> finding.rule().id()).toList();
  }
}
