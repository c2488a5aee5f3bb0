package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The selected node decides of which object versions are made. */
class SceneDialogsTest {
  @TempDir Path folder;

  private String object(String nodes, String selected) throws IOException {
    DocumentElement scene =
        TestSessions.with(folder, nodes).document().tree().orElseThrow().scene().orElseThrow();
    DocumentElement[] at = {scene};
    scene.visit(element -> at[0] = element.name().equals(selected) ? element : at[0]);
    return SceneDialogs.object(at[0]).map(DocumentElement::toString).orElse("");
  }

  @Test
  void anUnnamedObjectIsTakenFromAnyNodeInIt() throws IOException {
    String ball = "<Shape><Appearance><Material/></Appearance><Sphere/></Shape>\n";
    assertThat(object(ball, "Shape")).isEqualTo("Shape");
    assertThat(object(ball, "Material")).isEqualTo("Shape");
  }

  @Test
  void theSwitchAroundItComesFirst() throws IOException {
    assertThat(object(TestSessions.object("Cup"), "Inline")).isEqualTo("Switch Switch_Cup");
  }

  @Test
  void whatIsDrawnNowhereIsNoObject() throws IOException {
    assertThat(object("<Viewpoint/>\n", "Viewpoint")).isEmpty();
  }
}
