package org.selectiverenderer.authoring.enrichment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import org.assertj.core.api.ThrowableAssert;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.FieldLevel;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.VersionMetadata;

class QualityEditsTest {
  private static final String VERSIONS =
      """
        <Switch DEF='Switch_Sofa' whichChoice='0'>
          <MetadataSet containerField='metadata' name='Sofa'>
            <MetadataSet containerField='value'>
              <MetadataString containerField='value' name='schemaBelonginess' value='"Hall"'/>
            </MetadataSet>
            <MetadataSet containerField='value'/>
          </MetadataSet>
          <Shape>
            <Appearance>
              <ImageTexture DEF='SofaTexture' url='"sofa.jpg"'/>
            </Appearance>
            <Box/>
          </Shape>
          <Group/>
        </Switch>
        <DirectionalLight DEF='Lamp' intensity='0.5'/>
      """;

  /** What the field quality is made of, as in docs/qualities.md. */
  private static final String QUALITIES =
      """
            <MetadataSet containerField='metadata' name='fieldQualities'>
              <MetadataSet containerField='value' name='textures'>
                <MetadataString containerField='value' name='quality' value='"textures"'/>
                <MetadataString containerField='value' name='field' value='"SofaTexture.url"'/>
                <MetadataSet containerField='value'>
                  <MetadataString containerField='value' name='degreeOfConsistency' value='"low"'/>
                  <MetadataString containerField='value' name='schemaBelonginess' value='"Hall"'/>
                  <MetadataString containerField='value' name='value' value='"sofa.jpg"'/>
                </MetadataSet>
                <MetadataSet containerField='value'>
                  <MetadataString containerField='value' name='degreeOfConsistency' value='"high"'/>
                  <MetadataString containerField='value' name='schemaBelonginess' value='"Kitchen"'/>
                  <MetadataString containerField='value' name='value' value='"small.jpg"'/>
                </MetadataSet>
              </MetadataSet>
            </MetadataSet>
      """;

  private static final String OUTER = "    <MetadataSet containerField='metadata' name='Sofa'>\n";

  private static final String ENRICHED = VERSIONS.replace(OUTER, OUTER + QUALITIES);

  private static final FieldReference URL = new FieldReference("SofaTexture", "url");

  private static FieldLevel level(
      int index, ConsistencyDegree degree, String schema, String value) {
    return new FieldLevel(
        new VersionMetadata(index, Optional.empty(), Optional.of(degree), List.of(schema)),
        List.of(value));
  }

  private static FieldQuality textures(FieldReference target) {
    return new FieldQuality(
        Quality.TEXTURES,
        target,
        List.of(
            level(0, ConsistencyDegree.LOW, "Hall", "sofa.jpg"),
            level(1, ConsistencyDegree.HIGH, "Kitchen", "small.jpg")));
  }

  private static EnrichedSwitch sofa(EnrichmentScenes scene) {
    return scene.switchNode("Switch_Sofa");
  }

  private static EnrichedField field(EnrichmentScenes scene) {
    return sofa(scene).fields().get(0);
  }

  private static QualityEdits edits(EnrichmentScenes scene) {
    return new QualityEdits(scene.document);
  }

  /** Performs an edit and checks that undoing it gives every byte back. */
  private static String after(EnrichmentScenes scene, Edit edit) {
    String before = scene.nodes();
    scene.perform(edit);
    String after = scene.nodes();
    scene.document.history().undo();
    assertThat(scene.nodes()).isEqualTo(before);
    scene.document.history().redo();
    return after;
  }

  @Test
  void aQualityIsWrittenBesideTheVersionsWhoseTextStays() {
    EnrichmentScenes scene = EnrichmentScenes.with(VERSIONS);
    Edit edit = edits(scene).add(sofa(scene), textures(URL));
    assertThat(edit.name()).isEqualTo("Add the quality textures to Switch_Sofa");
    assertThat(after(scene, edit)).isEqualTo(ENRICHED);
    assertThat(field(scene).target()).isEqualTo(URL);
    assertThat(field(scene).quality()).isEqualTo(Quality.TEXTURES);
    assertThat(sofa(scene).values()).hasSize(2);
    assertThat(sofa(scene).findings()).extracting(ElementFinding::message).isEmpty();
  }

  @Test
  void theLastQualityTakesItsSetWithIt() {
    EnrichmentScenes scene = EnrichmentScenes.with(ENRICHED);
    assertThat(after(scene, edits(scene).remove(sofa(scene), field(scene)))).isEqualTo(VERSIONS);
  }

  @Test
  void aFieldIsSetByOneQualityOnly() {
    EnrichmentScenes scene = EnrichmentScenes.with(ENRICHED);
    assertThatThrownBy(() -> edits(scene).add(sofa(scene), textures(URL)))
        .isInstanceOf(EditRejectedException.class)
        .hasMessage("SofaTexture.url is set by another quality of Switch_Sofa");
    FieldReference lamp = new FieldReference("Lamp", "on");
    after(scene, edits(scene).add(sofa(scene), textures(lamp)));
    assertThat(sofa(scene).fields()).extracting(EnrichedField::target).containsExactly(URL, lamp);
  }

  @Test
  void eachWordIsChangedAlone() {
    EnrichmentScenes scene = EnrichmentScenes.with(ENRICHED);
    assertThat(after(scene, edits(scene).quality(field(scene), Quality.LIGHT)))
        .isEqualTo(ENRICHED.replace("value='\"textures\"'", "value='\"light\"'"));
    scene.document.history().undo();
    assertThat(
            after(
                scene,
                edits(scene)
                    .target(sofa(scene), field(scene), new FieldReference("Lamp", "intensity"))))
        .isEqualTo(ENRICHED.replace("SofaTexture.url", "Lamp.intensity"));
    scene.document.history().undo();
    assertThat(after(scene, edits(scene).value(field(scene), 1, List.of("tiny.jpg", "b.jpg"))))
        .isEqualTo(ENRICHED.replace("\"small.jpg\"", "\"tiny.jpg\" \"b.jpg\""));
    scene.document.history().undo();
    ChoiceMetadata wanted = field(scene).levels().get(1).metadata();
    Edit edit =
        edits(scene)
            .metadata(sofa(scene), field(scene), 1, wanted.with(new ConsistencyDegree(0.75)));
    assertThat(after(scene, edit)).isEqualTo(ENRICHED.replace("\"high\"", "\"0.75\""));
    assertThat(edits(scene).value(field(scene), 0, List.of("sofa.jpg")).isEmpty()).isTrue();
  }

  @Test
  void levelsAreAddedAfterTheLastAndDeletedDownToOne() {
    EnrichmentScenes scene = EnrichmentScenes.with(ENRICHED);
    after(scene, edits(scene).addLevel(field(scene)));
    assertThat(field(scene).levels())
        .extracting(EnrichedField.Level::values)
        .containsExactly(List.of("sofa.jpg"), List.of("small.jpg"), List.of("small.jpg"));
    assertThat(after(scene, edits(scene).removeLevel(field(scene), 2))).isEqualTo(ENRICHED);
    after(scene, edits(scene).removeLevel(field(scene), 0));
    assertThatThrownBy(() -> edits(scene).removeLevel(field(scene), 0))
        .hasMessage("SofaTexture.url needs a level; remove the whole quality instead");
  }

  @Test
  void theVersionsNameTheirQualityUnlessItIsPolygons() {
    EnrichmentScenes scene = EnrichmentScenes.with(VERSIONS);
    String named = after(scene, edits(scene).ofVersions(sofa(scene), Quality.SHADING));
    assertThat(named).contains("name='quality' value='\"shading\"'");
    assertThat(sofa(scene).quality()).isEqualTo(Quality.SHADING);
    assertThat(after(scene, edits(scene).ofVersions(sofa(scene), Quality.POLYGONS)))
        .isEqualTo(VERSIONS);
  }

  @Test
  void aSchemaIsRenamedAndRemovedInLevelsToo() {
    EnrichmentScenes scene = EnrichmentScenes.with(ENRICHED);
    after(scene, scene.edits().renameSchema("Kitchen", "Cellar"));
    assertThat(field(scene).levels().get(1).metadata().schemas()).containsExactly("Cellar");
    assertThat(scene.enrichment.schemas()).contains("Cellar");
    after(scene, scene.edits().removeSchema("Cellar"));
    assertThat(field(scene).levels().get(1).metadata().schemas()).isEmpty();
    assertThat(field(scene).levels().get(1).metadata().degree()).contains(ConsistencyDegree.HIGH);
  }

  @Test
  void clearingTheVersionsKeepsTheQualities() {
    EnrichmentScenes scene = EnrichmentScenes.with(ENRICHED);
    scene.perform(scene.edits().choice(sofa(scene), 0, ChoiceMetadata.NONE));
    assertThat(sofa(scene).fields()).hasSize(1);
  }

  @Test
  void problemsOfQualitiesAreFindingsOfTheObject() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(ENRICHED.replace("SofaTexture.url", "SofaTexture"));
    assertThat(sofa(scene).fields()).isEmpty();
    assertThat(sofa(scene).findings())
        .extracting(ElementFinding::message)
        .singleElement()
        .asString()
        .contains("DEF name, a dot and the name of a field");
  }

  @Test
  void aRenamedOrCopiedNodeIsFollowed() {
    EnrichmentScenes scene = EnrichmentScenes.with(ENRICHED);
    NodeEdits nodes = new NodeEdits(scene.document);
    scene.perform(
        nodes.rename(
            scene.document.tree().orElseThrow().named("SofaTexture").orElseThrow(), "Leather"));
    assertThat(scene.nodes()).isEqualTo(ENRICHED.replace("SofaTexture", "Leather"));
    scene.document.history().undo();
    scene.perform(nodes.copy(sofa(scene).element(), "Switch_Chair"));
    EnrichedSwitch copy = scene.switchNode("Switch_Chair");
    String texture = copy.fields().get(0).target().node();
    assertThat(texture).isNotEqualTo("SofaTexture");
    assertThat(copy.element().contains(scene.document.tree().orElseThrow().named(texture).get()))
        .isTrue();
    assertThat(field(scene).target()).isEqualTo(URL);
  }

  @Test
  void whatBelongsToAnotherNodeIsNotChangedThere() {
    String set = "<MetadataSet containerField='value' name='textures'>";
    String shared =
        ENRICHED.replace(set, set.replace("<MetadataSet", "<MetadataSet DEF='Shared'"))
            + """
              <Switch DEF='Switch_Other' whichChoice='0'>
                <MetadataSet containerField='metadata' name='Other'>
                  <MetadataSet containerField='metadata' name='fieldQualities'>
                    <MetadataSet containerField='value' USE='Shared'/>
                  </MetadataSet>
                </MetadataSet>
                <Group/>
              </Switch>
            """;
    EnrichmentScenes scene = EnrichmentScenes.with(shared);
    EnrichedSwitch other = scene.switchNode("Switch_Other");
    EnrichedField field = other.fields().get(0);
    assertThatThrownBy(() -> edits(scene).value(field, 1, List.of("tiny.jpg")))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("belongs to another node (USE)");
    after(scene, edits(scene).remove(other, field));
    assertThat(scene.switchNode("Switch_Other").fields()).isEmpty();
    assertThat(field(scene).levels()).hasSize(2);
  }

  /** Another Switch uses all of the metadata, so that each edit would be one of both. */
  @Test
  void metadataThatAnotherObjectSharesAsAWholeStay() {
    String shared =
        ENRICHED.replace(OUTER, OUTER.replace("<MetadataSet ", "<MetadataSet DEF='M' "))
            + "  <Switch DEF='Other'><MetadataSet containerField='metadata' USE='M'/><Group/>"
            + "<Group/></Switch>\n";
    EnrichmentScenes scene = EnrichmentScenes.with(shared);
    FieldReference lamp = new FieldReference("Lamp", "on");
    ChoiceMetadata described =
        new ChoiceMetadata(Optional.empty(), Optional.of(ConsistencyDegree.HIGH), List.of("Hall"));
    List<ThrowableAssert.ThrowingCallable> all =
        List.of(
            () -> edits(scene).quality(field(scene), Quality.LIGHT),
            () -> edits(scene).target(sofa(scene), field(scene), lamp),
            () -> edits(scene).value(field(scene), 1, List.of("tiny.jpg")),
            () -> edits(scene).metadata(sofa(scene), field(scene), 1, described),
            () -> edits(scene).addLevel(field(scene)),
            () -> edits(scene).removeLevel(field(scene), 1),
            () -> edits(scene).remove(sofa(scene), field(scene)),
            () -> edits(scene).add(sofa(scene), textures(lamp)),
            () -> edits(scene).ofVersions(sofa(scene), Quality.LIGHT),
            () ->
                new FieldQualityEdits(scene.document)
                    .put(sofa(scene).element(), List.of(textures(URL))),
            () -> scene.edits().choice(sofa(scene), 0, described),
            () -> scene.edits().choice(sofa(scene), 1, described));
    for (int i = 0; i < all.size(); i++) {
      assertThatThrownBy(all.get(i))
          .as("edit " + i)
          .isInstanceOf(EditRejectedException.class)
          .hasMessageContaining("the metadata 'M' is also used elsewhere (USE)");
    }
    assertThat(scene.nodes()).isEqualTo(shared);
  }
}
