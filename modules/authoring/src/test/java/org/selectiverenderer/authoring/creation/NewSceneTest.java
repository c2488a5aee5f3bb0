package org.selectiverenderer.authoring.creation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dReader;

/** New scenes can be read, and are as large as they were asked for. */
class NewSceneTest {
  private static SceneDocument read(String text) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    new X3dReader(NodeCatalogue.load())
        .read("new.x3d", text.getBytes(StandardCharsets.UTF_8), problems);
    assertThat(problems.list()).isEmpty();
    return SceneDocument.of("new.x3d", text.getBytes(StandardCharsets.UTF_8));
  }

  @Test
  void aRoomHasFloorWallsLampAndViewpointOfItsSize() throws IOException {
    String text = NewScene.room("a <b> & 'c'.x3d", new RoomSize(6, 4.5, 3), true);
    read(text);
    assertThat(text)
        .contains("content='a &lt;b&gt; &amp; &apos;c&apos;.x3d'")
        .contains("DEF='Floor' translation='0 -0.05 0'")
        .contains("<Box size='6.2 0.1 4.7'/>")
        .contains("DEF='WallWest' translation='-3.05 1.5 0'")
        .contains("DEF='Ceiling' translation='0 3.05 0'")
        .contains("<Viewpoint ")
        .contains("<PointLight ");
    assertThat(NewScene.room("r", RoomSize.USUAL, false)).doesNotContain("Ceiling");
  }

  @Test
  void anEmptySceneCanBeRead() throws IOException {
    assertThat(read(NewScene.empty("e.x3d")).fault()).isEmpty();
  }

  @Test
  void aRoomWithoutRoomIsRefused() {
    assertThatThrownBy(() -> new RoomSize(0, 1, 2)).hasMessageContaining("metres");
    assertThatThrownBy(() -> new RoomSize(Double.NaN, 1, 2)).hasMessageContaining("metres");
  }
}
