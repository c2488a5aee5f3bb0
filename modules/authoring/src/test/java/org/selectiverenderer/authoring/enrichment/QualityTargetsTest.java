package org.selectiverenderer.authoring.enrichment;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.routes.EventField;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

class QualityTargetsTest {
  private static final String NODES =
      """
      <PointLight DEF='SofaLamp'/>
      <TimeSensor DEF='Clock'><MetadataDouble DEF='Rate' name='animationRate' value='5'/></TimeSensor>
      <Coordinate DEF='Points'/>
      <ProtoDeclare name='P'><ProtoBody><PointLight DEF='Hidden'/></ProtoBody></ProtoDeclare>
      <Switch DEF='Switch_Sofa'>
        <MetadataString name='schemaBelonginess' DEF='Schemas' value='"Hall"'/>
        <Shape DEF='SofaShape'><Appearance>
          <MetadataString DEF='SofaShading' name='shading' value='"pixel"'/>
          <ImageTexture DEF='SofaTexture' url='"sofa.jpg" "b.jpg"'/>
          <Material DEF='SofaMaterial'/>
        </Appearance></Shape>
      </Switch>
      """;

  private final EnrichmentScenes scene = EnrichmentScenes.with(NODES);
  private final QualityTargets targets = new QualityTargets(scene.document, NodeCatalogue.load());
  private final DocumentElement sofa = scene.switchNode("Switch_Sofa").element();

  private static FieldReference target(String text) {
    return FieldReference.of(text).orElseThrow();
  }

  private List<String> fields(String def) {
    return targets.fields(scene.document.tree().orElseThrow().named(def).orElseThrow()).stream()
        .map(EventField::name)
        .toList();
  }

  @Test
  void nodesOfTheObjectComeFirstAndOnlyThoseWithAFieldThatWorks() {
    assertThat(targets.nodes(sofa, "", 100))
        .extracting(element -> element.def().orElseThrow())
        .containsExactly(
            "Switch_Sofa", // its visible
            "SofaShape",
            "SofaShading",
            "SofaTexture",
            "SofaMaterial",
            "SofaLamp",
            "Clock",
            "Rate");
    assertThat(targets.nodes(sofa, "LAMP", 100)).hasSize(1);
    assertThat(targets.nodes(sofa, "", 2)).hasSize(2);
  }

  @Test
  void fieldsAreThoseThatReceiveValuesThatMetadataCanHold() {
    assertThat(fields("SofaTexture")).contains("url").doesNotContain("repeatS", "metadata");
    assertThat(fields("SofaShading")).containsExactly("value");
    assertThat(fields("SofaMaterial")).contains("diffuseColor", "transparency");
    assertThat(fields("Switch_Sofa")).doesNotContain("whichChoice");
    assertThat(targets.wrong(sofa, target("SofaTexture.url"))).isEmpty();
    assertThat(targets.wrong(sofa, target("SofaTexture.repeatS")))
        .contains("SofaTexture has no field repeatS whose value can be chosen.");
    assertThat(targets.wrong(sofa, target("Hidden.on")))
        .contains("No node of this file has the name Hidden.");
  }

  @Test
  void aValueIsJudgedByTheTypeAndBoundsOfItsField() {
    assertThat(wrong("SofaLamp.on", "true")).isEmpty();
    assertThat(wrong("SofaLamp.on", "yes")).contains("\"yes\" is no value of type SFBool.");
    assertThat(wrong("SofaMaterial.diffuseColor", "1 0")).isPresent();
    assertThat(wrong("SofaMaterial.diffuseColor", "1 0 2").orElseThrow())
        .contains("is not allowed");
    assertThat(wrong("Rate.value", "1 2 3")).isEmpty();
    assertThat(wrong("SofaTexture.url", "anything")).isEmpty();
  }

  private Optional<String> wrong(String field, String text) {
    FieldReference target = target(field);
    return targets.wrong(sofa, target, targets.values(sofa, target, text));
  }

  @Test
  void stringsAreEditedInQuotationMarksOrAsOneWord() {
    FieldReference url = target("SofaTexture.url");
    assertThat(targets.present(sofa, url)).containsExactly("sofa.jpg", "b.jpg");
    assertThat(targets.shown(sofa, url, List.of("a b.jpg", "c.jpg")))
        .isEqualTo("\"a b.jpg\" \"c.jpg\"");
    assertThat(targets.values(sofa, url, "\"a b.jpg\" \"c.jpg\""))
        .containsExactly("a b.jpg", "c.jpg");
    assertThat(targets.values(sofa, url, " small.jpg ")).containsExactly("small.jpg");
    assertThat(targets.values(sofa, url, " ")).isEmpty();
    assertThat(targets.present(sofa, target("SofaLamp.intensity"))).containsExactly("1");
  }

  @Test
  void theFieldSuggestsTheQuality() {
    assertThat(targets.proposed(sofa, target("SofaTexture.url"))).isEqualTo(Quality.TEXTURES);
    assertThat(targets.proposed(sofa, target("SofaShading.value"))).isEqualTo(Quality.SHADING);
    assertThat(targets.proposed(sofa, target("Rate.value"))).isEqualTo(Quality.ANIMATION);
    assertThat(targets.proposed(sofa, target("SofaLamp.on"))).isEqualTo(Quality.LIGHT);
  }
}
