package org.selectiverenderer.authoring.editing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/** What may be typed at the caret, which {@code |} marks. */
class CodeCompletionTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();

  private static CodeCompletion.Proposals at(String marked) {
    int caret = marked.indexOf('|');
    return CodeCompletion.at(marked.replace("|", ""), caret, CATALOGUE);
  }

  private static List<String> words(String marked) {
    return at(marked).proposals().stream().map(CompletionProposal::word).toList();
  }

  @Test
  void elementsThatFitAreProposed() {
    assertThat(words("<X3D><Scene><|")).contains("Transform", "ROUTE").doesNotContain("Box");
    assertThat(words("<X3D><Scene><Shape><|"))
        .contains("Box", "Appearance")
        .doesNotContain("Shape");
    assertThat(words("<X3D><|")).containsExactlyInAnyOrder("head", "Scene");
    assertThat(words("|")).containsExactly("X3D");
    assertThat(words("<Scene><Shape><Box/><!-- <Group> --></Shape><Tra|").get(0)).startsWith("Tra");
  }

  @Test
  void theWordBegunComesFirstAndIsReplaced() {
    CodeCompletion.Proposals found = at("<X3D><Scene><Trans|");
    assertThat(found.from()).isEqualTo(13);
    assertThat(found.proposals().get(0).word()).isEqualTo("Transform");
    assertThat(at("<X3D><Scene>Trans|").proposals().get(0).text()).isEqualTo("<Transform");
  }

  @Test
  void attributesThatAreNotThereYetAreProposedInTheAuthorsQuotes() {
    CodeCompletion.Proposals found = at("<X3D><Scene><Box size=\"1 2 3\" s|");
    assertThat(found.proposals())
        .extracting(CompletionProposal::word)
        .contains("solid")
        .doesNotContain("size");
    CompletionProposal solid = found.proposals().get(0);
    assertThat(solid.text()).isEqualTo("solid=\"\"");
    assertThat(solid.caret()).isEqualTo(7);
    assertThat(solid.about()).isEqualTo("SFBool, true");
    assertThat(words("<X3D><Scene><Box |")).contains("DEF", "USE").doesNotContain("metadata");
    assertThat(words("<X3D><head><meta |")).containsExactly("name", "content");
  }

  @Test
  void valuesOfTheCatalogueAreProposed() {
    assertThat(words("<Scene><Box solid='|")).containsExactly("true", "false");
    assertThat(words("<Scene><Fog fogType='E|")).first().isEqualTo("EXPONENTIAL");
    assertThat(at("<Text><FontStyle justify='|").proposals())
        .extracting(CompletionProposal::text)
        .contains("\"BEGIN\"");
  }

  @Test
  void namesAreProposedEvenWhileTheTextIsBroken() {
    String scene = "<X3D><Scene><Group DEF='Cup'/><Box DEF='B'/><TimeSensor DEF='T'/>";
    assertThat(words(scene + "<Group USE='|")).containsExactly("Cup");
    assertThat(words(scene + "<ROUTE fromNode='|")).containsExactly("Cup", "B", "T");
    assertThat(words(scene + "<ROUTE fromNode='T' fromField='frac|"))
        .containsExactly("fraction_changed");
  }

  @Test
  void endTagsAreCompleted() {
    assertThat(at("<X3D><Scene><Group></Group></|").proposals())
        .singleElement()
        .satisfies(each -> assertThat(each.text()).isEqualTo("Scene>"));
  }

  @Test
  void nothingIsProposedInCommentsAndTexts() {
    assertThat(words("<X3D><!-- <Sce|")).isEmpty();
    assertThat(words("<?xml vers|")).isEmpty();
    assertThat(words("<X3D a=|")).isEmpty();
  }
}
