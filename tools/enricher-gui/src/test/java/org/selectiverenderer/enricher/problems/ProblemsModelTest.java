package org.selectiverenderer.enricher.problems;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

class ProblemsModelTest {
  private static final String SCENE =
      """
      <X3D profile='Immersive' version='4.0'><Scene>
        <ProximitySensor DEF='Desk' size='3 3 3'>
          <MetadataSet containerField='metadata'>
            <MetadataString containerField='value' name='enterTimeSchema' value='"DeskSchema"'/>
          </MetadataSet>
        </ProximitySensor>
        <Switch DEF='Bin' whichChoice='0'>
          <MetadataSet containerField='metadata'>
            <MetadataSet containerField='value'>
              <MetadataString containerField='value' name='schemaBelonginess' value='"DeskScema"'/>
            </MetadataSet>
          </MetadataSet>
          <Group DEF='Low'/>
        </Switch>
        <Transform DEF='Table' scale='wide'/>
      </Scene></X3D>
      """;

  private final SceneDocument document = document();
  private final ProblemsModel model =
      new ProblemsModel(document, new DocumentEnrichment(document, NodeCatalogue.load()));

  private static SceneDocument document() {
    try {
      return SceneDocument.of("scene.x3d", SCENE.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private Problem at(String text, String message) {
    SourceLocation place = document.location(document.text().toString().indexOf(text));
    return new Problem(Severity.WARNING, place, message);
  }

  private ProblemEntry only(String message) {
    return model.entries().stream()
        .filter(entry -> entry.message().equals(message))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void aMisspelledSchemaIsMendedByItsFix() {
    model.refresh();
    ProblemEntry entry =
        model.entries().stream()
            .filter(e -> e.message().contains("is DeskSchema meant"))
            .findFirst()
            .orElseThrow();
    assertThat(entry.message()).contains("DeskScema");
    document.perform(entry.fix().orElseThrow().edit().get());
    model.refresh();
    assertThat(document.text().toString()).contains("\"DeskSchema\"").doesNotContain("DeskScema");
    assertThat(model.entries()).noneMatch(e -> e.fix().isPresent());
  }

  @Test
  void whatChecksSaidMovesWithItsElementAndGoesWithIt() {
    model.checked(document.revision(), List.of(at("scale=", "no number")));
    model.refresh();
    assertThat(document.text().toString().substring(only("no number").offset().orElseThrow()))
        .startsWith("scale=");
    int comment = document.text().toString().indexOf("<Switch");
    document.type(comment, comment, "<!-- a comment before -->");
    model.refresh();
    assertThat(document.text().toString().substring(only("no number").offset().orElseThrow()))
        .startsWith("scale=");
    int table = document.text().toString().indexOf("<Transform");
    document.type(table, document.text().toString().indexOf("</Scene>"), "");
    model.refresh();
    assertThat(model.entries()).noneMatch(entry -> entry.message().equals("no number"));
  }

  @Test
  void whatIsSaidOfAnOlderTextIsLetBe() {
    long old = document.revision();
    Problem problem = at("scale=", "no number");
    document.type(0, 0, "<!-- -->");
    model.checked(old, List.of(problem));
    model.refresh();
    assertThat(model.entries()).noneMatch(entry -> entry.message().equals("no number"));
  }

  @Test
  void ofATextThatIsNotWellFormedOnlyTheFaultIsTold() {
    model.checked(document.revision(), List.of(at("scale=", "no number")));
    int end = document.text().toString().indexOf("</Switch>");
    document.type(end, end + 9, "</Swich>");
    model.refresh();
    assertThat(model.entries()).hasSize(1);
    assertThat(model.entries().get(0).severity()).isEqualTo(Severity.ERROR);
    assertThat(model.entries().get(0).element()).isEmpty();
    assertThat(model.counts(false).words()).isEqualTo("1 error");
  }

  @Test
  void twoChecksThatSayTheSameOfAnElementAreHeardOnce() {
    model.checked(
        document.revision(),
        List.of(at("<Transform", "no number [SR103]"), at("scale=", "no number")));
    model.refresh();
    assertThat(model.entries()).filteredOn(e -> e.stem().equals("no number")).hasSize(1);
  }

  @Test
  void theRuleOfAProblemIsKnown() {
    model.checked(document.revision(), List.of(at("<Transform", "no number [SR103]")));
    model.refresh();
    assertThat(only("no number [SR103]").rule()).contains("SR103");
    assertThat(RuleCatalogue.standard().find("SR103")).isPresent();
  }

  @Test
  void problemsOfOtherFilesNameThem() {
    Problem other = new Problem(Severity.ERROR, new SourceLocation("bin.x3d", 3, 4), "no number");
    model.checked(document.revision(), List.of(other));
    model.refresh();
    assertThat(only("no number").offset()).isEmpty();
    assertThat(only("no number").location(document)).hasToString("bin.x3d:3:4");
    assertThat(only("no number").otherFile()).contains(other.location());
  }

  @Test
  void anObjectIsFaultyByItsWarningsOnlyOnceItIsEnriched() {
    int group = document.text().toString().indexOf("<Transform");
    document.type(group, group, "<Switch DEF='Cup' whichChoice='0'><Group/></Switch>");
    DocumentElement cup = document.tree().orElseThrow().named("Cup").orElseThrow();
    DocumentElement bin = document.tree().orElseThrow().named("Bin").orElseThrow();
    Problem error =
        new Problem(Severity.ERROR, at("<Switch DEF='Cup'", "").location(), "no such field");
    model.checked(
        document.revision(),
        List.of(at("<Switch DEF='Cup'", "never shown"), at("<Switch DEF='Bin'", "never shown")));
    model.refresh();
    assertThat(model.entries()).filteredOn(e -> e.message().equals("never shown")).hasSize(2);
    assertThat(model.faulty(cup)).isFalse();
    assertThat(model.faulty(bin)).isTrue();
    model.checked(document.revision(), List.of(error));
    model.refresh();
    assertThat(model.faulty(cup)).isTrue();
  }

  @Test
  void theValidatorSpeaksOfTheUnsavedText(@TempDir Path folder) {
    ValidatorCheck check =
        new ValidatorCheck(
            () -> folder.resolve("never-saved.x3d"),
            RuleCatalogue.standard(),
            problems -> Optional.of(ValidationSettings.standard()));
    List<Problem> problems = check.check(document.snapshot());
    assertThat(problems)
        .anySatisfy(
            problem -> {
              assertThat(problem.message()).contains("wide").contains("[SR103]");
              assertThat(problem.location().file()).isEqualTo("scene.x3d");
              assertThat(problem.location().line()).isEqualTo(15);
            });
  }

  /** An author at the beginning has work to do, not problems. */
  @Test
  void whatIsNotEnrichedYetIsCountedAndNotComplainedAbout() throws IOException {
    SceneDocument plain =
        SceneDocument.of(
            "plain.x3d",
            """
            <X3D profile='Immersive' version='4.0'><Scene>
              <Switch DEF='Cup' whichChoice='0'/>
              <ProximitySensor DEF='Desk'/>
            </Scene></X3D>
            """
                .getBytes(StandardCharsets.UTF_8));
    ProblemsModel counting =
        new ProblemsModel(plain, new DocumentEnrichment(plain, NodeCatalogue.load()));
    SourceLocation cup = plain.location(plain.text().toString().indexOf("<Switch"));
    SourceLocation desk = plain.location(plain.text().toString().indexOf("<Prox"));
    counting.checked(
        plain.revision(),
        List.of(
            new Problem(Severity.WARNING, cup, "choice 1 is never shown: no metadata [SR424]"),
            new Problem(Severity.INFO, desk, "the sensor names no schema [SR426]"),
            new Problem(Severity.WARNING, cup, "something else [SR101]")));
    counting.refresh();
    assertThat(counting.entries()).extracting(ProblemEntry::stem).containsExactly("something else");
    assertThat(counting.counts(false)).isEqualTo(new ProblemCounts(false, 0, 1, 0, 2, 2));
    assertThat(counting.counts(false).left()).contains("2 of 2 not enriched yet");
    assertThat(counting.counts(false).words()).isEqualTo("1 warning");
  }
}
