package org.selectiverenderer.authoring.area;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.enrichment.EnrichmentScenes;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

class AreaEditsTest {
  /** Thesis Fig 76. */
  private static final String LIBRARY =
      """
        <!-- Fig 76 -->
        <Transform DEF='boxLibrary' scale='1.078 2.368 1.338' translation='3.744 -1.93 -1.107'>
          <Transform translation='0.0 0.8219 0.0'>
            <ProximitySensor DEF='BookcaseProx' size='2.643 1.644 3.159'/>
          </Transform>
        </Transform>
        <ROUTE fromNode='x' fromField='y' toNode='z' toField='w'/>
      """;

  private static AreaEdits edits(EnrichmentScenes scene) {
    return new AreaEdits(scene.enrichment, NodeCatalogue.load());
  }

  private static AreaInstance area(EnrichmentScenes scene, String name) {
    return AreaLocator.of(scene.enrichment, scene.sensor(name)).orElseThrow();
  }

  private static AreaBox box(double... b) {
    return new AreaBox(new Vector3d(b[0], b[1], b[2]), new Vector3d(b[3], b[4], b[5]));
  }

  private static void same(AreaBox is, double... b) {
    near(is.centre(), b[0], b[1], b[2]);
    near(is.size(), b[3], b[4], b[5]);
  }

  private static void near(Vector3dc is, double x, double y, double z) {
    assertThat(is.distance(x, y, z)).as("%s", is).isCloseTo(0, within(2e-4));
  }

  @Test
  void anAreaUnderTransformsIsABoxOfTheSceneAndCanBePutElsewhere() {
    EnrichmentScenes scene = EnrichmentScenes.with(LIBRARY);
    AreaInstance library = area(scene, "BookcaseProx");
    same(
        library.box(),
        3.744,
        -1.93 + 2.368 * 0.8219,
        -1.107,
        1.078 * 2.643,
        2.368 * 1.644,
        1.338 * 3.159);
    assertThat(library.frame().turned()).isFalse();
    AreaEdits edits = edits(scene);
    Edit edit = edits.place(library, box(4, 0, -1, 3, 2.368, 2), "Move BookcaseProx");
    scene.perform(edit);
    same(area(scene, "BookcaseProx").box(), 4, 0, -1, 3, 2.368, 2);
    assertThat(scene.nodes())
        .isEqualTo(
            LIBRARY.replace(
                "size='2.643 1.644 3.159'/>",
                "size='2.7829 1 1.4948' center='0.2375 -0.0069 0.08'/>"));
    scene.document.history().undo();
    assertThat(scene.nodes()).isEqualTo(LIBRARY);
  }

  @Test
  void whatDoesNotChangeStaysAsItIsWritten() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            "<ProximitySensor DEF='P' center=\"1.23456 0 0.0\" size='2 2 2.00'/>\n");
    AreaEdits edits = edits(scene);
    AreaInstance area = area(scene, "P");
    assertThat(edits.place(area, area.box(), "x").isEmpty()).isTrue();
    scene.perform(edits.place(area, area.box().movedBy(new Vector3d(0, 1, 0)), "Move P"));
    assertThat(scene.nodes())
        .isEqualTo("<ProximitySensor DEF='P' center=\"1.23456 1 0\" size='2 2 2.00'/>\n");
  }

  @Test
  void widthIsWhatIsWideInTheSceneUnderARightAngleAndOtherAnglesAreToldApart() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
            <Transform rotation='0 1 0 1.5707963' scale='1 1 2'>
              <ProximitySensor DEF='Right' size='1 2 3'/>
            </Transform>
            <Transform rotation='0 1 0 0.5' translation='9 0 0'>
              <ProximitySensor DEF='Turned' size='1 2 3'/>
            </Transform>
            <Billboard><ProximitySensor DEF='Unknown' size='1 2 3'/></Billboard>
            """);
    AreaInstance right = area(scene, "Right");
    assertThat(right.frame().turned()).isFalse();
    same(right.box(), 0, 0, 0, 6, 2, 1);
    AreaEdits edits = edits(scene);
    scene.perform(edits.place(right, box(0, 0, 0, 4, 2, 1), "Resize"));
    same(area(scene, "Right").box(), 0, 0, 0, 4, 2, 1);
    AreaInstance turned = area(scene, "Turned");
    assertThat(turned.frame().turned()).isTrue();
    same(turned.box(), 9, 0, 0, 1, 2, 3);
    near(turned.frame().direction(0), Math.cos(0.5), 0, -Math.sin(0.5));
    assertThat(AreaLocator.of(scene.enrichment, scene.sensor("Unknown"))).isEmpty();
    assertThat(AreaLocator.of(scene.enrichment)).hasSize(2);
  }

  @Test
  void aNewAreaStandsBehindThoseThatAreThereWithTheirIndentation() {
    EnrichmentScenes scene = EnrichmentScenes.with(LIBRARY);
    AreaEdits edits = edits(scene);
    Edit edit = edits.add("Desk", box(1, 2, 3, 4, 5, 6.5));
    assertThat(edit.name()).isEqualTo("Add the area Desk");
    scene.perform(edit);
    assertThat(scene.nodes())
        .isEqualTo(
            LIBRARY.replace(
                "  <ROUTE",
                "  <ProximitySensor DEF='Desk' center='1 2 3' size='4 5 6.5'/>\n  <ROUTE"));
    scene.document.history().undo();
    assertThat(scene.nodes()).isEqualTo(LIBRARY);
    assertThatThrownBy(() -> edits.add("boxLibrary", box(0, 0, 0, 1, 1, 1)))
        .isInstanceOf(EditRejectedException.class);
    assertThatThrownBy(() -> edits.add("Flat", box(0, 0, 0, 1, 0, 1)))
        .hasMessageContaining("greater than 0");
  }

  @Test
  void theFirstAreaOfASceneStandsInFrontOfItsRoutesAndInTheLayerThatIsWalkedIn() {
    EnrichmentScenes plain = EnrichmentScenes.with("  <Group/>\n  <ROUTE fromNode='a'/>\n");
    plain.perform(edits(plain).add("A", box(0, 0, 0, 1, 1, 1)));
    assertThat(plain.nodes())
        .isEqualTo(
            "  <Group/>\n  <ProximitySensor DEF='A' center='0 0 0' size='1 1 1'/>\n"
                + "  <ROUTE fromNode='a'/>\n");
    EnrichmentScenes layers =
        EnrichmentScenes.with(
            """
              <LayerSet activeLayer='1'>
                <Layer>
                  <Group/>
                </Layer>
              </LayerSet>
            """);
    layers.perform(edits(layers).add("A", box(0, 0, 0, 1, 1, 1)));
    assertThat(layers.nodes())
        .contains("      <Group/>\n      <ProximitySensor DEF='A' ")
        .contains("/>\n    </Layer>");
    EnrichmentScenes empty = EnrichmentScenes.of("<X3D>\n  <Scene/>\n</X3D>\n");
    empty.perform(edits(empty).add("A", box(0, 0, 0, 1, 1, 1)));
    assertThat(empty.document.text().toString())
        .isEqualTo(
            "<X3D>\n  <Scene>\n    <ProximitySensor DEF='A' center='0 0 0' size='1 1 1'/>\n"
                + "  </Scene>\n</X3D>\n");
  }

  private static final String TWO =
      """
        <ProximitySensor DEF='A' size='2 2 2'/>
        <ProximitySensor DEF='B' center='1 0 0' size='2 2 2'/>
        <ProximitySensor DEF='C' center='1.2 0 0' size='1 1 1'/>
        <ProximitySensor DEF='D' center='9 0 0' size='1 1 1'/>
      """;

  @Test
  void areasThatLieOverEachOtherAreFoundWithWhatTheyShare() {
    EnrichmentScenes scene = EnrichmentScenes.with(TWO);
    List<AreaLocator.Overlap> overlaps =
        AreaLocator.overlaps(area(scene, "B"), AreaLocator.of(scene.enrichment));
    assertThat(overlaps).extracting(each -> each.other().name()).containsExactly("A", "C");
    assertThat(overlaps.get(0).volume()).isCloseTo(4, within(1e-6));
    assertThat(overlaps.get(0).around()).isFalse();
    assertThat(overlaps.get(1).around()).isTrue();
    assertThat(overlaps.get(1).volume()).isCloseTo(1, within(1e-6));
    EnrichmentScenes turned =
        EnrichmentScenes.with(
            """
            <ProximitySensor DEF='A' size='2 2 2'/>
            <Transform rotation='0 1 0 0.7853982'><ProximitySensor DEF='B' size='2 2 2'/></Transform>
            """);
    assertThat(
            AreaLocator.overlaps(area(turned, "A"), AreaLocator.of(turned.enrichment))
                .get(0)
                .volume())
        .as("an octagon")
        .isCloseTo(2 * 8 * (Math.sqrt(2) - 1), within(0.1));
  }

  @Test
  void aCopyHasTheSameSchemasAndIsAnotherPartOfTheArea() {
    EnrichmentScenes scene = EnrichmentScenes.with(TWO);
    scene.perform(
        scene.edits().sensor(scene.sensor("A"), new SensorSchemas(List.of("Desk"), List.of())));
    AreaEdits edits = edits(scene);
    scene.perform(edits.copy(area(scene, "A"), "A_2", new Vector3d(0.5, 0, 0)));
    AreaInstance copy = area(scene, "A_2");
    same(copy.box(), 0.5, 0, 0, 2, 2, 2);
    assertThat(copy.schemas().enter()).containsExactly("Desk");
    List<AreaInstance> all = AreaLocator.of(scene.enrichment);
    assertThat(AreaLocator.parts(copy, all)).extracting(AreaInstance::name).containsExactly("A");
    assertThat(AreaLocator.overlaps(copy, all))
        .extracting(each -> each.other().name())
        .containsExactly("B", "C");
    assertThat(scene.nodes()).contains("    <MetadataSet", "DEF='MetadataSet_A_2Definition'");
    assertThat(scene.document.history().undoName()).contains("Copy A");
  }

  @Test
  void placesThatTakeAnAreaAlongByUseAreTold() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            """
            <Transform DEF='Room'><ProximitySensor DEF='A' size='2 2 2'/></Transform>
            <Transform translation='5 0 0'><Transform USE='Room'/></Transform>
            """);
    assertThat(area(scene, "A").elsewhere()).containsExactly("Room");
  }

  @Test
  void anAreaDeclaresTheComponentThatItsProfileLacks() {
    EnrichmentScenes scene =
        EnrichmentScenes.of("<X3D profile='Interchange'>\n  <Scene>\n  </Scene>\n</X3D>\n");
    scene.perform(edits(scene).add("A", box(0, 0, 0, 1, 1, 1)));
    assertThat(scene.document.text().toString())
        .isEqualTo(
            """
            <X3D profile='Interchange'>
              <head>
                <component name='EnvironmentalSensor' level='1'/>
              </head>
              <Scene>
                <ProximitySensor DEF='A' center='0 0 0' size='1 1 1'/>
              </Scene>
            </X3D>
            """);
    scene.document.history().undo();
    assertThat(scene.document.text().toString()).doesNotContain("component");
  }
}
