package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.draw.BaselineRenderer;
import org.selectiverenderer.render.mesh.PackedMesh;
import org.selectiverenderer.testing.RequiresDisplay;

@RequiresDisplay
class BaselineRendererTest {
  private static final int TOWARDS_THE_VIEWER = 0x8080ff;

  @AutoClose private final TestImageRenderer studio = new TestImageRenderer();

  private static TestScene scene() {
    return TestScene.of(
        "<Transform translation='-2 0 0'><Shape><Box DEF='B' size='2 2 2'/></Shape></Transform>"
            + "<Transform translation='2 0 0' scale='-1 1 1'>"
            + "<Shape><Box USE='B'/></Shape></Transform>"
            + "<Switch whichChoice='-1'><Shape><Box size='8 8 8'/></Shape></Switch>"
            + "<Shape><PointSet><Coordinate point='0 3 0'/></PointSet></Shape>");
  }

  @Test
  void allTrianglesShownAreInIt() {
    PackedMesh packed = BaselineRenderer.pack(scene().tree());

    assertThat(packed.indexCount()).isEqualTo(2 * 12 * 3);
    assertThat(packed.solid()).isTrue();
  }

  @Test
  void frontsAreColouredByTheirNormals() {
    OffscreenFramebuffer target =
        new OffscreenFramebuffer(studio.gl(), TestImageRenderer.SIZE, TestImageRenderer.SIZE, 0);
    target.bind(studio.gl());
    BaselineRenderer raw = new BaselineRenderer(studio.gl(), BaselineRenderer.pack(scene().tree()));

    raw.draw(studio.gl(), TestImageRenderer.parallel());
    Screenshot shot = target.read(studio.gl());

    assertThat(shot.rgb(16, 32)).isEqualTo(TOWARDS_THE_VIEWER);
    assertThat(shot.rgb(48, 32)).as("the mirrored box").isEqualTo(TOWARDS_THE_VIEWER);
    assertThat(shot.rgb(32, 32)).isZero();
    raw.dispose(studio.gl());
    target.dispose(studio.gl());
  }
}
