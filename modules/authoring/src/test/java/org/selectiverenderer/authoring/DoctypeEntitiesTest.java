package org.selectiverenderer.authoring;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/** Scenes whose DOCTYPE declares entities open with their elements; nothing is fetched. */
class DoctypeEntitiesTest {
  private static final String SUBSET =
      """
      <?xml version='1.0' encoding='UTF-8'?>
      <!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D 3.3//EN" "http://127.0.0.1:1/x3d-3.3.dtd" [
        <!ENTITY kitchen "kitchen">
        <!ENTITY name 'Area_&kitchen;'>
        <!ENTITY chair "<Transform DEF='Chair'/>">
        <!ENTITY far SYSTEM "http://127.0.0.1:1/far.xml">
        <!-- <!ENTITY kitchen "other"> -->
      ]>
      <X3D version='3.3'>
      <Scene>
        <ProximitySensor DEF='&name;' size='1 2 3'>
          <MetadataSet containerField='metadata'>
            <MetadataString containerField='value' name='enterTimeSchema' value='"&kitchen;"'/>
          </MetadataSet>
        </ProximitySensor>
        &chair;
        &far;
        <Group DEF='After'/>
      </Scene>
      </X3D>
      """;

  private static SceneDocument document(String text) throws IOException {
    return SceneDocument.of("scene.x3d", text.getBytes(StandardCharsets.UTF_8));
  }

  private static DocumentElement named(SceneDocument document, String def) {
    return document.tree().orElseThrow().named(def).orElseThrow();
  }

  @Test
  void elementsNamesAndValuesAreReadThroughEntities() throws IOException {
    SceneDocument document = document(SUBSET);
    assertThat(document.fault()).isEmpty();
    DocumentElement area = named(document, "Area_kitchen");
    assertThat(area.location().line()).isEqualTo(11);
    DocumentEnrichment enrichment = new DocumentEnrichment(document, NodeCatalogue.load());
    assertThat(enrichment.sensors().get(0).schemas().enter()).containsExactly("kitchen");
    assertThat(document.snapshot().text()).isEqualTo(SUBSET);
  }

  @Test
  void whatComesOutOfAnEntityIsOneElementThatIsReadOnly() throws IOException {
    SceneDocument document = document(SUBSET);
    DocumentElement scene = document.tree().orElseThrow().root().children().get(0);
    assertThat(scene.children())
        .extracting(DocumentElement::name)
        .containsExactly("ProximitySensor", "&chair;", "&far;", "Group");
    DocumentElement chair = scene.children().get(1);
    assertThat(chair.isReference()).isTrue();
    assertThat(document.text(chair)).isEqualTo("&chair;");
    assertThat(document.tag(chair).attributes()).isEmpty();
    assertThatThrownBy(() -> document.layout().attribute(chair, "DEF", "x"))
        .isInstanceOf(EditRejectedException.class);
    assertThat(document.entities().find("far").orElseThrow().value()).isEmpty();
  }

  @Test
  void anAttributeOutOfAnEntityIsNotWrittenAndOthersAre() throws IOException {
    SceneDocument document = document(SUBSET);
    DocumentElement area = named(document, "Area_kitchen");
    assertThatThrownBy(() -> document.layout().attribute(area, "DEF", "Other"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("entity");
    TextEdit change = document.layout().attribute(area, "size", "4 5 6");
    document.perform(new Edit("Set size", List.of(change)));
    assertThat(document.snapshot().text()).isEqualTo(SUBSET.replace("1 2 3", "4 5 6"));
    assertThat(area.attached()).isTrue();
    assertThat(named(document, "Area_kitchen")).isSameAs(area);
    assertThat(document.text(named(document, "After"))).isEqualTo("<Group DEF='After'/>");
  }

  @Test
  void anotherDeclarationIsFollowed() throws IOException {
    SceneDocument document = document(SUBSET);
    int at = SUBSET.indexOf("\"kitchen\"") + 1;
    document.perform(new Edit("e", List.of(new TextEdit(at, at + 7, "office"))));
    assertThat(named(document, "Area_office").name()).isEqualTo("ProximitySensor");
  }

  /** Of entities of entities, with letters and without. */
  @Test
  void bombsEnd() throws IOException {
    for (String leaf : List.of("", "lol")) {
      StringBuilder text = new StringBuilder("<!DOCTYPE X3D [<!ENTITY e0 '" + leaf + "'>");
      for (int i = 1; i < 15; i++) {
        text.append("<!ENTITY e%d '%s'>".formatted(i, ("&e" + (i - 1) + ";").repeat(1000)));
      }
      text.append("<!ENTITY loop '&pool;'><!ENTITY pool '&loop;'>]>\n<X3D a='&e14;' b='&loop;'/>");
      SceneDocument document = document(text.toString());
      assertThat(document.tree()).isPresent();
      DocumentElement root = document.tree().orElseThrow().root();
      assertThat(document.attribute(root, "a")).contains(leaf.isEmpty() ? "" : "&e14;");
      assertThat(document.attribute(root, "b")).contains("&loop;");
    }
    String wide = "<!DOCTYPE X3D [<!ENTITY w '" + "w".repeat(60_000) + "'>]>\n<X3D a='";
    SceneDocument document = document(wide + "&w;".repeat(400) + "'/>");
    assertThat(document.fault().orElseThrow().message()).contains("not plausible");
  }
}
