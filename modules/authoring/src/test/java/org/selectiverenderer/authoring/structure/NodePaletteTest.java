package org.selectiverenderer.authoring.structure;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The palette lists what can be inserted where. */
class NodePaletteTest {
  private final NodeCatalogue catalogue = NodeCatalogue.load();
  private final SceneDocument document;

  NodePaletteTest() throws IOException {
    document =
        SceneDocument.of(
            "scene.x3d",
            "<X3D><Scene><Shape DEF='S'><Appearance DEF='A'/></Shape></Scene></X3D>"
                .getBytes(StandardCharsets.UTF_8));
  }

  private Optional<DocumentElement> named(String def) {
    return document.tree().orElseThrow().named(def);
  }

  private List<String> names(Optional<DocumentElement> selected) {
    return new NodePalette(document, catalogue)
        .entries(selected).stream().map(each -> each.type().name()).toList();
  }

  @Test
  void nodesThatTheSelectionTakesAreListedBeforeThoseBesideIt() {
    List<String> inAppearance = names(named("A"));
    assertThat(inAppearance).contains("Material", "ImageTexture", "Box").doesNotContain("Group");
    assertThat(inAppearance.indexOf("Material")).isLessThan(inAppearance.indexOf("Box"));
    assertThat(names(Optional.empty())).contains("Group", "Viewpoint").doesNotContain("Material");
    NodePalette.Entry material =
        new NodePalette(document, catalogue)
            .entries(named("A")).stream()
                .filter(each -> each.type().name().equals("Material"))
                .findFirst()
                .orElseThrow();
    assertThat(material.field()).isEqualTo("material");
    assertThat(material.into()).isSameAs(named("A").orElseThrow());
  }

  @Test
  void aTemplateGoesWhereItMayStandAroundTheSelection() {
    NodePalette palette = new NodePalette(document, catalogue);
    NodeTemplate box = palette.template("box").with("Transform", "translation", "1 2 3");
    StructureChange change = palette.insert(named("A"), box);
    document.perform(change.edit());
    assertThat(change.elements(document)).hasToString("[Transform Box]");
    assertThat(document.history().undoName()).contains("Insert Box");
    assertThat(document.snapshot().text())
        .contains("</Shape><Transform DEF='Box' translation='1 2 3'><Shape>");
    document.perform(palette.insert(named("A"), palette.template("Material")).edit());
    assertThat(document.snapshot().text()).contains("<Appearance DEF='A'><Material/></Appearance>");
  }

  @Test
  void anObjectGoesBesideASelectedObjectAndIntoAGroup() {
    NodePalette palette = new NodePalette(document, catalogue);
    document.perform(palette.insert(Optional.empty(), palette.template("box")).edit());
    assertThat(palette.parent(named("Box"), palette.template("cone")).name()).isEqualTo("Scene");
    document.perform(palette.insert(named("Box"), palette.template("cone")).edit());
    assertThat(named("Cone").orElseThrow().parent().orElseThrow().name()).isEqualTo("Scene");
    document.perform(palette.insert(named("Box"), palette.template("group")).edit());
    assertThat(named("Group").orElseThrow().parent()).isEqualTo(named("Box"));
    document.perform(palette.insert(named("Group"), palette.template("cone")).edit());
    assertThat(named("Cone_2").orElseThrow().parent()).isEqualTo(named("Group"));
  }

  @Test
  void everyTemplateDrawsNodesOfTheCatalogueAndFitsIntoAScene() {
    NodeTemplate.all()
        .values()
        .forEach(
            template -> {
              SceneFragment fragment = SceneFragment.parse(template.text(), catalogue);
              fragment
                  .elements()
                  .forEach(
                      root ->
                          root.visit(
                              each -> {
                                assertThat(catalogue.find(each.name())).as(each.name()).isPresent();
                                Containment containment = new Containment(catalogue);
                                each.children()
                                    .forEach(
                                        child ->
                                            assertThat(containment.accepts(each, child))
                                                .as(template.name() + ": " + child)
                                                .isTrue());
                              }));
            });
  }

  @Test
  void theHeadDeclaresTheComponentsThatAnInsertedNodeNeedsBeyondTheProfile() throws IOException {
    SceneDocument immersive =
        SceneDocument.of(
            "scene.x3d",
            """
            <X3D profile='Immersive' version='4.0'>
              <Scene>
                <Group/>
              </Scene>
            </X3D>
            """
                .getBytes(StandardCharsets.UTF_8));
    NodePalette palette = new NodePalette(immersive, catalogue);
    StructureChange change = palette.insert(Optional.empty(), palette.template("ParticleSystem"));
    immersive.perform(change.edit());
    assertThat(change.elements(immersive)).hasToString("[ParticleSystem]");
    immersive.perform(palette.insert(Optional.empty(), palette.template("GeoLocation")).edit());
    immersive.perform(palette.insert(Optional.empty(), palette.template("GeoLocation")).edit());
    immersive.perform(palette.insert(Optional.empty(), palette.template("box")).edit());
    assertThat(immersive.snapshot().text())
        .startsWith(
            """
            <X3D profile='Immersive' version='4.0'>
              <head>
                <component name='ParticleSystems' level='2'/>
                <component name='Geospatial' level='1'/>
              </head>
              <Scene>
            """);
  }
}
