package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.nodes.group.SwitchNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

class SchemaSimulatorTest {
  private static final String FILE = "<X3D version='4.0' profile='Full'><Scene>%s</Scene></X3D>";

  /** A sofa with a lamp, whose intensity is a quality. */
  private static final String SOFA =
      """
      <Switch DEF='Sofa' whichChoice='0'>
        <MetadataSet containerField='metadata'>
          <MetadataSet containerField='metadata' name='fieldQualities'>
            <MetadataSet containerField='value'>
              <MetadataString containerField='value' name='quality' value='"light"'/>
              <MetadataString containerField='value' name='field' value='"Lamp.intensity"'/>
              <MetadataSet containerField='value'>
                <MetadataString containerField='value' name='schemaBelonginess' value='"Hall"'/>
                <MetadataString containerField='value' name='value' value='"0.75"'/>
              </MetadataSet>
              <MetadataSet containerField='value'>
                <MetadataString containerField='value' name='schemaBelonginess' value='"Desk"'/>
                <MetadataString containerField='value' name='value' value='"0.25"'/>
              </MetadataSet>
            </MetadataSet>
          </MetadataSet>
        </MetadataSet>
        <Group><PointLight DEF='Lamp' intensity='0.5'/></Group>
      </Switch>
      """;

  @Test
  void objectsOfInlinedRoomsFollowTheSchemasToo(@TempDir Path dir) throws IOException {
    Files.writeString(
        dir.resolve("room.x3d"),
        FILE.formatted(
            "<Switch whichChoice='1'><Group/><Group/><MetadataSet containerField='metadata'>"
                + "<MetadataSet containerField='value'><MetadataString containerField='value'"
                + " name='schemaBelonginess' value='\"Desk\"'/></MetadataSet></MetadataSet></Switch>"));
    Path scene =
        Files.writeString(dir.resolve("scene.x3d"), FILE.formatted("<Inline url='\"room.x3d\"'/>"));
    ProblemCollector problems = new ProblemCollector();
    try (SceneLoader loader =
        new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems)) {
      World world = new World(loader.load(scene), problems);
      PreviewNodeIndex nodes = new PreviewNodeIndex(world);
      SwitchNode object = nodes.switches().iterator().next();
      SchemaSimulator asIf =
          new SchemaSimulator(
              nodes.switches(), (node, name) -> world.scene().find(name), world.cascade());

      asIf.apply(List.of("Desk"));
      assertThat(object.whichChoice()).isZero();
      asIf.reset();
      assertThat(object.whichChoice()).isEqualTo(1);
      assertThat(nodes.all()).doesNotContain(object);
    }
  }

  @Test
  void fieldsThatAreQualitiesFollowTheSchemas(@TempDir Path dir) throws IOException {
    Path scene = Files.writeString(dir.resolve("scene.x3d"), FILE.formatted(SOFA));
    ProblemCollector problems = new ProblemCollector();
    try (SceneLoader loader =
        new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems)) {
      World world = new World(loader.load(scene), problems);
      PreviewNodeIndex nodes = new PreviewNodeIndex(world);
      SchemaSimulator asIf =
          new SchemaSimulator(
              nodes.switches(), (node, name) -> world.scene().find(name), world.cascade());
      Node lamp = world.scene().find("Lamp").orElseThrow();
      asIf.apply(List.of("Desk"));
      assertThat(lamp.value("intensity")).isEqualTo(0.25f);
      asIf.apply(List.of("Desk", "Hall"));
      assertThat(lamp.value("intensity")).isEqualTo(0.75f);
      asIf.reset();
      assertThat(lamp.value("intensity")).isEqualTo(0.5f);
      asIf.detailed();
      assertThat(lamp.value("intensity")).isEqualTo(0.75f);
    }
  }

  @Test
  void fieldsOfInlinedFilesFollowTheSchemasEachByTheNamesOfItsFile(@TempDir Path dir)
      throws IOException {
    Files.writeString(dir.resolve("room.x3d"), FILE.formatted(SOFA));
    String text =
        FILE.formatted("<PointLight DEF='Lamp' intensity='0.5'/><Inline url='\"room.x3d\"'/>");
    SceneDocument scene = SceneDocument.of("scene.x3d", text.getBytes(StandardCharsets.UTF_8));
    try (PreviewScene preview =
        new PreviewScene(LoadedPreview.of(scene.snapshot(), dir, ContentAccessPolicy.none()))) {
      SwitchNode sofa = preview.nodes().switches().iterator().next();
      Node lamp = ((GroupingNode) sofa.children().get(0)).children().get(0);
      preview.asIf(List.of("Desk"));
      assertThat(lamp.value("intensity")).isEqualTo(0.25f);
      assertThat(preview.world().scene().find("Lamp").orElseThrow().value("intensity"))
          .isEqualTo(0.5f);
      preview.asIf(List.of());
      assertThat(lamp.value("intensity")).isEqualTo(0.5f);
    }
  }
}
