package org.selectiverenderer.control;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.schema.SchemaProblem;
import org.selectiverenderer.schema.SwitchSchemas;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.core.MetadataSet;
import org.web3d.x3d.sai.core.MetadataString;
import org.web3d.x3d.sai.grouping.Switch;

class SchemaCacheTest {
  private final SchemaCache cache = new SchemaCache();
  private final List<SchemaProblem> problems = new ArrayList<>();

  private static String lamp(String name, String field, String schema) {
    return "<Switch DEF='%s'><Group/><MetadataSet containerField='metadata'>".formatted(name)
        + "<MetadataSet containerField='value'>"
        + "<MetadataString DEF='%s-schema' containerField='value' name='%s' value='\"%s\"'/>"
            .formatted(name, field, schema)
        + "</MetadataSet></MetadataSet></Switch>";
  }

  private Optional<SwitchSchemas> read(ControlledSceneFixture scene, String name) {
    Switch node = (Switch) scene.node(name);
    return cache.object(SaiMetadata.of(node).orElseThrow(), node.getNumChildren(), problems::add);
  }

  @Test
  void objectsWhoseMetadataSayTheSameShareTheResult() {
    try (var scene =
        new ControlledSceneFixture(
            lamp("Lamp", "schemaBelonginess", "desk")
                + lamp("Same", "schemaBelonginess", "desk")
                + lamp("Other", "schemaBelonginess", "sofa"))) {
      SwitchSchemas lamp = read(scene, "Lamp").orElseThrow();
      assertThat(lamp.choiceBySchema()).containsOnlyKeys("desk");
      assertThat(read(scene, "Same").orElseThrow()).isSameAs(lamp);
      assertThat(read(scene, "Other").orElseThrow().choiceBySchema()).containsOnlyKeys("sofa");
    }
  }

  @Test
  void changedMetadataAreReadAnew() {
    try (var scene = new ControlledSceneFixture(lamp("Lamp", "schemaBelonginess", "desk"))) {
      read(scene, "Lamp");
      ((MetadataString) scene.node("Lamp-schema")).setValue(new String[] {"sofa"});
      assertThat(read(scene, "Lamp").orElseThrow().choiceBySchema()).containsOnlyKeys("sofa");
    }
  }

  @Test
  void theNumberOfVersionsCounts() {
    try (var scene = new ControlledSceneFixture(lamp("Lamp", "schemaBelonginess", "desk"))) {
      SaiMetadata metadata = SaiMetadata.of(scene.node("Lamp")).orElseThrow();
      assertThat(cache.object(metadata, 1, problems::add)).isPresent();
      assertThat(problems).isEmpty();
      cache.object(metadata, 2, problems::add);
      assertThat(problems).singleElement().asString().contains("1 MetadataSet for 2 children");
    }
  }

  @Test
  void aProblemIsToldForEachObjectThatHasIt() {
    try (var scene =
        new ControlledSceneFixture(
            lamp("Lamp", "schemaBelonginess", " ") + lamp("Same", "schemaBelonginess", " "))) {
      read(scene, "Lamp");
      read(scene, "Same");
      assertThat(problems).hasSize(2);
      assertThat(problems.get(0).metadata()).isNotEqualTo(problems.get(1).metadata());
    }
  }

  @Test
  void aSetThatContainsItselfIsReadWithoutEnd() {
    try (var scene = new ControlledSceneFixture(lamp("Lamp", "schemaBelonginess", "desk"))) {
      MetadataSet set = (MetadataSet) scene.node("Lamp").getMetadata();
      set.setValue(new X3DNode[] {(X3DNode) set, scene.node("Lamp-schema")});
      assertThat(read(scene, "Lamp")).isPresent();
    }
  }
}
