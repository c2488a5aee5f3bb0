package org.selectiverenderer.authoring.editing;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Single fields read, judged and written. */
class FieldEditsTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();
  private static final String SCENE =
      """
      <X3D><Scene>
        <Group DEF='Used'/> <Group USE="Used"/>
        <Material  DEF="M"  transparency='0.5'
          shininess="9" nonsense='1'/><!-- stays -->
        <Fog DEF='F'/>
      </Scene></X3D>
      """;

  private final SceneDocument document;
  private final FieldEdits edits;

  FieldEditsTest() throws IOException {
    document = SceneDocument.of("scene.x3d", SCENE.getBytes(StandardCharsets.UTF_8));
    edits = new FieldEdits(document);
  }

  private DocumentElement named(String def) {
    return document.tree().orElseThrow().named(def).orElseThrow();
  }

  private List<NodeField> fields(DocumentElement of) {
    return NodeFieldList.of(document, CATALOGUE, of);
  }

  private NodeField field(String def, String name) {
    return fields(named(def)).stream().filter(f -> f.name().equals(name)).findFirst().orElseThrow();
  }

  private Optional<String> wrong(String def, String name, String value) {
    return edits.wrong(named(def), field(def, name), value);
  }

  @Test
  void whatIsWrittenComesFirstAndTheCatalogueBehind() {
    List<NodeField> all = fields(named("M"));
    assertThat(all)
        .extracting(NodeField::name)
        .startsWith("DEF", "transparency", "shininess", "nonsense")
        .contains("diffuseColor")
        .doesNotContain("metadata")
        .doesNotHaveDuplicates();
    NodeField colour = field("M", "diffuseColor");
    assertThat(colour.kind()).isEqualTo(NodeField.Kind.COLOR);
    assertThat(colour.written()).isEmpty();
    assertThat(colour.about()).isEqualTo("SFColor, 0.8 0.8 0.8 by default, from 0, to 1");
    assertThat(field("M", "transparency").written()).contains("0.5");
    assertThat(field("F", "fogType").choices()).containsExactly("LINEAR", "EXPONENTIAL");
  }

  @Test
  void wrongValuesAreToldWithTheReason() {
    assertThat(wrong("M", "transparency", "0.25")).isEmpty();
    assertThat(wrong("M", "transparency", "1.5").orElseThrow()).contains("at most 1");
    assertThat(wrong("M", "transparency", "x")).isPresent();
    assertThat(wrong("M", "diffuseColor", "1 0")).isPresent();
    assertThat(wrong("F", "fogType", "THICK").orElseThrow()).contains("LINEAR, EXPONENTIAL");
    assertThat(wrong("M", "DEF", "F").orElseThrow()).contains("already");
    assertThat(wrong("M", "DEF", "a b")).isPresent();
    assertThat(wrong("M", "DEF", "Ύλη_2")).isEmpty();
    assertThat(wrong("Used", "DEF", "Other")).isEmpty();
    assertThat(wrong("Used", "DEF", "").orElseThrow()).contains("Line 2");
    DocumentElement use = named("Used").parent().orElseThrow().children().get(1);
    assertThat(fields(use).get(0).choices()).containsExactly("Used");
    assertThat(edits.wrong(use, fields(use).get(0), "M").orElseThrow()).contains("Material");
  }

  @Test
  void anotherNameIsSaidByAllThatSpeakOfTheNode() {
    document.perform(edits.set(named("Used"), "DEF", "Other"));
    assertThat(document.snapshot().text())
        .isEqualTo(
            SCENE.replace("DEF='Used'", "DEF='Other'").replace("USE=\"Used\"", "USE=\"Other\""));
    document.history().undo();
    assertThat(document.snapshot().text()).isEqualTo(SCENE);
  }

  @Test
  void whatIsTypedForStringsWithoutQuotationMarksIsOneString() throws IOException {
    SceneDocument scene =
        SceneDocument.of(
            "scene.x3d",
            "<X3D><Scene><ImageTexture DEF='Photo'/></Scene></X3D>"
                .getBytes(StandardCharsets.UTF_8));
    DocumentElement photo = scene.tree().orElseThrow().named("Photo").orElseThrow();
    NodeField url =
        NodeFieldList.of(scene, CATALOGUE, photo).stream()
            .filter(field -> field.name().equals("url"))
            .findFirst()
            .orElseThrow();
    FieldEdits writing = new FieldEdits(scene);
    scene.perform(writing.set(List.of(photo), url, " my photo.png "));
    assertThat(scene.snapshot().text()).contains("url='\"my photo.png\"'");
    scene.perform(writing.set(List.of(photo), url, "\"a.png\" \"b.png\""));
    assertThat(scene.snapshot().text()).contains("url='\"a.png\" \"b.png\"'");
  }

  @Test
  void onlyTheBytesOfOneAttributeChangeInOneStep() {
    document.perform(edits.set(named("M"), "shininess", "0.25"));
    assertThat(document.snapshot().text()).isEqualTo(SCENE.replace("\"9\"", "\"0.25\""));
    document.perform(edits.unset(named("M"), "transparency"));
    document.perform(edits.set(named("F"), "color", "1 0 0"));
    assertThat(document.snapshot().text())
        .isEqualTo(
            SCENE
                .replace("\"9\"", "\"0.25\"")
                .replace("  transparency='0.5'", "")
                .replace("<Fog DEF='F'/>", "<Fog DEF='F' color='1 0 0'/>"));
    assertThat(document.history().names())
        .containsExactly(
            "Set shininess of Material M",
            "Reset transparency of Material M",
            "Set color of Fog F");
    assertThat(edits.set(named("F"), "color", "1 0 0").isEmpty()).isTrue();
    assertThat(edits.unset(named("F"), "fogType").isEmpty()).isTrue();
  }
}
