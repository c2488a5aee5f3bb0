package org.selectiverenderer.authoring.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/** Versions of objects in scenes with prototypes. */
class PrototypeVersionsTest extends VaseScene {
  private static final SimplificationTarget FEW = new SimplificationTarget.VertexPercent(20);

  @Test
  void namesInAPrototypeAreOthersThanThoseOfTheScene() throws IOException {
    Path scene =
        other(
            "s.x3d",
            """
              <ProtoDeclare name='P'><ProtoBody>
                <Group><Shape DEF='Vase'><Sphere/></Shape><Shape USE='Vase'/></Group>
              </ProtoBody></ProtoDeclare>
              <ProtoInstance name='P'/>
            """
                + shape("Vase", "<Sphere/>")
                + shape("Cup", "<Sphere/>"));
    String before = Files.readString(scene);
    make(scene, "Vase", FEW);
    assertThat(problems.list()).isEmpty();
    assertThat(Files.readString(scene))
        .startsWith(before.substring(0, before.indexOf("  <Shape DEF='Vase'><Sphere/></Shape>\n  ")))
        .contains("<Switch DEF='Switch_Vase'");
  }

  @Test
  void aNodeOfAPrototypeIsNoObjectOfTheScene() throws IOException {
    Path scene =
        other(
            "s.x3d",
            "<ProtoDeclare name='P'><ProtoBody>"
                + shape("Vase", "<Sphere/>")
                + "</ProtoBody></ProtoDeclare><ProtoInstance name='P'/>");
    assertThat(plan(scene, "Vase", FEW)).isEmpty();
    assertThat(problems.list().toString()).contains("is part of a prototype");
  }
}
