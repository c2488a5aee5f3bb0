package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.opengl.GL3;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.display.TextOverlay;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.x3d.tessellate.TextMesher;

/**
 * What comes and goes takes no new names of buffers: drivers never give a name twice, and JOGL
 * keeps an entry for each that there ever was.
 */
@RequiresDisplay
class BufferReuseTest {
  private static final int CHANGES = 40;

  @Test
  void meshesThatChange() {
    TestScene scene =
        TestScene.of(
            "<Shape><IndexedFaceSet solid='false' coordIndex='0 1 2 3 -1'>"
                + "<Coordinate DEF='C' point='-1 -1 0 1 -1 0 1 1 0 -1 1 0'/>"
                + "</IndexedFaceSet></Shape>");
    try (TestImageRenderer studio = new TestImageRenderer()) {
      GL3 gl = studio.gl();
      bend(scene, 0);
      int blank = lit(studio, scene);
      bend(scene, 1);
      lit(studio, scene);
      int before = freshName(gl);
      for (int change = 2; change < CHANGES; change++) {
        bend(scene, change);
        assertThat(lit(studio, scene)).isGreaterThan(blank / 2);
      }
      assertThat(freshName(gl) - before).isLessThan(CHANGES / 2);
    }
  }

  private static void bend(TestScene scene, int change) {
    scene.set("C", "point", new float[] {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1 + change * 0.01f, 0});
  }

  private static int lit(TestImageRenderer studio, TestScene scene) {
    byte[] rgba =
        studio.shoot(scene, TestImageRenderer.parallel(), Background.BLACK, true, 0).rgba();
    int lit = 0;
    for (int at = 0; at < rgba.length; at += 4) {
      lit += rgba[at] != 0 ? 1 : 0;
    }
    return lit;
  }

  @Test
  void textThatChanges() {
    try (TestImageRenderer studio = new TestImageRenderer()) {
      GL3 gl = studio.gl();
      OffscreenFramebuffer target = new OffscreenFramebuffer(gl, 200, 100, 0);
      target.bind(gl);
      TextOverlay overlay = new TextOverlay(new TextMesher());
      overlay.draw(gl, List.of("0 frames/s"), 200, 100, 1);
      overlay.draw(gl, List.of("1 frames/s"), 200, 100, 1);
      int before = freshName(gl);
      for (int change = 2; change < CHANGES; change++) {
        overlay.draw(gl, List.of(change + " frames/s"), 200, 100, 1);
      }
      assertThat(freshName(gl) - before).isLessThan(CHANGES / 2);
      overlay.dispose(gl);
      target.dispose(gl);
    }
  }

  @Test
  void nothingThatWasDrawnLeavesNothingToFree() {
    try (TestImageRenderer studio = new TestImageRenderer()) {
      TextOverlay unused = new TextOverlay(new TextMesher());
      unused.dispose(studio.gl());
      lit(studio, TestScene.of("<Group/>"));
    } // and the renderer has no buffers
  }

  /** The name that the next buffer would have. */
  private static int freshName(GL3 gl) {
    int[] name = new int[1];
    gl.glGenBuffers(1, name, 0);
    gl.glDeleteBuffers(1, name, 0);
    return name[0];
  }
}
