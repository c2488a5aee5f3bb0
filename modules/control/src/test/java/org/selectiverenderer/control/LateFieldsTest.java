package org.selectiverenderer.control;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.control.ControlEvent.FieldChange;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.testing.Eventually;
import org.web3d.x3d.sai.SFBool;
import org.web3d.x3d.sai.X3DGroupingNode;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.networking.Inline;

/** Fields of nodes that come, or are replaced, after the control has begun. */
class LateFieldsTest {
  private static final double OUTSIDE = -5;
  private static final double INSIDE = 0;
  private static final String AREA = ControlledSceneFixture.area("Room", 0, "kitchen", "hall");
  private static final String LAMP =
      "<Switch DEF='Lamp' whichChoice='0'><Group DEF='G'/>"
          + "<MetadataSet containerField='metadata'>"
          + "<MetadataSet name='fieldQualities' containerField='metadata'><MetadataSet>"
          + "<MetadataString name='quality' value='\"light\"'/>"
          + "<MetadataString name='field' value='\"L.on\"'/>"
          + level("low", "hall", "true")
          + level("high", "kitchen", "false")
          + "</MetadataSet></MetadataSet></MetadataSet></Switch>";

  private static String level(String degree, String schema, String value) {
    return "<MetadataSet><MetadataString name='degreeOfConsistency' value='\"%s\"'/>"
            .formatted(degree)
        + "<MetadataString name='schemaBelonginess' value='\"%s\"'/>".formatted(schema)
        + "<MetadataString name='value' value='\"%s\"'/></MetadataSet>".formatted(value);
  }

  private static boolean on(X3DNode light) {
    return ((SFBool) light.getField("on")).getValue();
  }

  private static X3DNode addLight(ControlledSceneFixture scene) {
    X3DNode light = scene.scene().createNode("DirectionalLight");
    scene.scene().updateNamedNode("L", light);
    ((X3DGroupingNode) scene.node("G")).addChildren(new X3DNode[] {light});
    return light;
  }

  private static List<ControlEvent> changes(ControlledSceneFixture scene) {
    return scene.news().stream().filter(FieldChange.class::isInstance).toList();
  }

  @Test
  void aNodeThatComesLaterIsSetAsTheEnteredAreasSay() {
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, AREA + LAMP)) {
      assertThat(scene.problems).anyMatch(problem -> problem.message().contains("DEF name L"));
      scene.walkTo(INSIDE);
      X3DNode light = addLight(scene);
      scene.walkTo(INSIDE);
      scene.controller.showDue(2);
      assertThat(on(light)).isFalse();
      assertThat(changes(scene))
          .containsExactly(new FieldChange(2, "Lamp", Quality.LIGHT, "L.on", 0, 1, "kitchen"));
      assertThat(scene.controller.problems()).isEmpty();
      scene.walkTo(OUTSIDE);
      assertThat(on(light)).isTrue();
    }
  }

  @Test
  void aBrowserWithoutFramesLooksWhenAnAreaIsEntered() {
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, AREA + LAMP)) {
      scene.walkTo(OUTSIDE);
      X3DNode light = addLight(scene);
      scene.walkTo(INSIDE);
      assertThat(on(light)).isFalse();
    }
  }

  @Test
  void aConditionThatNothingChangesCountsForALaterNodeToo() {
    try (var scene =
        ControlledSceneFixture.under(
            Condition.HIGH_LOW, ControlledSceneFixture.area("Room", 0, "kitchen", "") + LAMP)) {
      X3DNode light = addLight(scene);
      scene.walkTo(OUTSIDE);
      scene.controller.showDue(1);
      assertThat(on(light)).isFalse();
    }
  }

  @Test
  void anotherNodeOfTheSameNameTakesThePlaceOfTheFirst() {
    String first = "<DirectionalLight DEF='L'/>";
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, AREA + first + LAMP)) {
      X3DNode before = scene.node("L");
      scene.walkTo(INSIDE);
      assertThat(on(before)).isFalse();
      X3DNode light = addLight(scene);
      scene.walkTo(INSIDE);
      scene.controller.showDue(2);
      assertThat(on(light)).isFalse();
      scene.walkTo(OUTSIDE);
      assertThat(on(light)).isTrue();
      assertThat(on(before)).as("the scene's no more").isFalse();
    }
  }

  @Test
  void anImportedNodeIsSetWhenItsFileHasCome(@TempDir Path folder) throws IOException {
    Files.writeString(
        folder.resolve("light.x3d"),
        ControlledSceneFixture.file("<DirectionalLight DEF='Sun'/><EXPORT localDEF='Sun'/>"));
    String house =
        "<Inline DEF='House' load='false' url='\"light.x3d\"'/>"
            + "<IMPORT inlineDEF='House' importedDEF='Sun' AS='L'/>";
    try (var scene = new ControlledSceneFixture(folder, AREA + house + LAMP)) {
      scene.control(Condition.SELECTIVE);
      scene.walkTo(INSIDE);
      ((Inline) scene.node("House")).setLoad(true);
      Eventually.await(
          () -> "the levels " + scene.events,
          () -> {
            scene.walkTo(INSIDE);
            scene.controller.showDue(2);
            return !changes(scene).isEmpty();
          });
      assertThat(on(scene.node("L"))).isFalse();
      assertThat(scene.controller.choices()).isEqualTo(Map.of());
    }
  }
}
