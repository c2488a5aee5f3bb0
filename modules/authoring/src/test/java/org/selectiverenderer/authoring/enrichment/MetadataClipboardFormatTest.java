package org.selectiverenderer.authoring.enrichment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/** Whole metadata from one node to others. */
class MetadataClipboardFormatTest {
  private static final String SCENE =
      """
      <X3D version='4.0'><Scene>
      <Switch DEF='Switch_Cup'><Group/><Group/></Switch>
      <Switch DEF='Switch_Pan'><Group/><Group/></Switch>
      <Switch DEF='Switch_Lamp'><Group/><Group/><Group/></Switch>
      <ProximitySensor DEF='Desk'/>
      <ProximitySensor DEF='Sofa'/>
      </Scene></X3D>
      """;
  private SceneDocument document;
  private DocumentEnrichment enrichment;

  @BeforeEach
  void open() throws IOException {
    document = SceneDocument.of("scene.x3d", SCENE.getBytes(StandardCharsets.UTF_8));
    enrichment = new DocumentEnrichment(document, NodeCatalogue.load());
    EnrichmentEdits edits = new EnrichmentEdits(enrichment);
    ChoiceMetadata low =
        new ChoiceMetadata(
            Optional.of(ConsistencyType.INCONSISTENT),
            Optional.of(ConsistencyDegree.LOW),
            List.of("A \"quoted\" one", "B"));
    ChoiceMetadata high =
        new ChoiceMetadata(Optional.empty(), Optional.of(ConsistencyDegree.HIGH), List.of("C"));
    document.perform(
        edits.all(
            "Begin",
            List.of(new EnrichmentEdits.SwitchMetadata(object(0), List.of(low, high))),
            List.of(
                new EnrichmentEdits.SensorMetadata(
                    area(0), new SensorSchemas(List.of("B"), List.of("C"))))));
  }

  private EnrichedSwitch object(int index) {
    return enrichment.switches().get(index);
  }

  private EnrichedSensor area(int index) {
    return enrichment.sensors().get(index);
  }

  @Test
  void objectsGetAllThatAnotherHasInOneStep() {
    String before = document.text().toString();
    String text = MetadataClipboardFormat.of(object(0));
    document.perform(
        MetadataClipboardFormat.paste(enrichment, text, List.of(object(1), object(2)), List.of()));
    assertThat(object(1).values()).isEqualTo(object(0).values());
    assertThat(document.history().undoName()).contains("Paste Metadata to 2 objects");
    document.history().undo();
    assertThat(document.text().toString()).isEqualTo(before);
  }

  @Test
  void anotherNumberOfVersionsIsFilledByDegree() {
    document.perform(
        MetadataClipboardFormat.paste(
            enrichment, MetadataClipboardFormat.of(object(0)), List.of(object(2)), List.of()));
    List<ChoiceMetadata> lamp = object(2).values();
    assertThat(lamp.get(0)).isEqualTo(object(0).values().get(0));
    assertThat(lamp.get(1)).isEqualTo(ChoiceMetadata.NONE);
    assertThat(lamp.get(2).schemas()).containsExactly("C");
  }

  @Test
  void whatWasThereGoesAndNothingCanBePastedToo() {
    String nothing = MetadataClipboardFormat.of(object(1));
    document.perform(
        MetadataClipboardFormat.paste(enrichment, nothing, List.of(object(0)), List.of()));
    assertThat(object(0).enriched()).isFalse();
  }

  @Test
  void areasGetSchemasOfEnteringAndLeaving() {
    document.perform(
        MetadataClipboardFormat.paste(
            enrichment, MetadataClipboardFormat.of(area(0)), List.of(), List.of(area(1))));
    assertThat(area(1).schemas()).isEqualTo(area(0).schemas());
    assertThat(document.history().undoName()).contains("Paste Metadata to Sofa");
  }

  @Test
  void whatDoesNotFitIsRefusedWithAReason() {
    List<EnrichedSwitch> objects = List.of(object(1));
    assertThatThrownBy(
            () -> MetadataClipboardFormat.paste(enrichment, "low\thigh", objects, List.of()))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("no metadata");
    String ofArea = MetadataClipboardFormat.of(area(0));
    assertThatThrownBy(() -> MetadataClipboardFormat.paste(enrichment, ofArea, objects, List.of()))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("the metadata of an area");
    String cut = "object metadata\tCup\nconsistent";
    assertThatThrownBy(() -> MetadataClipboardFormat.paste(enrichment, cut, objects, List.of()))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("not complete");
  }
}
