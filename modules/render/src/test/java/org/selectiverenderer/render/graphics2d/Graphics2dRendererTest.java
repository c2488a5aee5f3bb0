package org.selectiverenderer.render.graphics2d;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.camera.ArgbImage;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.browser.camera.WorldSpacePanel;
import org.selectiverenderer.render.TestImageRenderer;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.x3d.tessellate.TextMesher;

/** Pictures between other marks, on a page of the picture and on one in the world. */
@RequiresDisplay
class Graphics2dRendererTest {
  private static final int RED = 0xFFFF0000;
  private static final int GREEN = 0xFF00FF00;
  private static final int BLUE = 0xFF0000FF;
  private static final int WHITE = 0xFFFFFFFF;

  /** Red and green above blue and nothing, on grey; a white spot in the middle is above it. */
  private static final List<Primitive2D> PAGE =
      List.of(
          Primitive2D.rectangle(0, 0, 100, 100, 0xFF808080),
          new Primitive2D.Picture(
              new ArgbImage(2, 2, new int[] {RED, GREEN, BLUE, 0x00FFFFFF}), 20, 10, 60, 80),
          Primitive2D.rectangle(45, 45, 10, 10, WHITE));

  private interface Drawing {
    void draw(Graphics2dRenderer painter, GL3 gl);
  }

  private static Screenshot drawn(Drawing drawing) {
    try (TestImageRenderer studio = new TestImageRenderer()) {
      GL3 gl = studio.gl();
      OffscreenFramebuffer target = new OffscreenFramebuffer(gl, 100, 100, 0);
      target.bind(gl);
      gl.glClearColor(0, 0, 0, 1);
      gl.glClear(GL.GL_COLOR_BUFFER_BIT);
      Graphics2dRenderer painter = new Graphics2dRenderer(new TextMesher());
      drawing.draw(painter, gl);
      Screenshot shot = target.read(gl);
      painter.dispose(gl);
      assertThat(gl.glGetError()).isZero();
      target.dispose(gl);
      return shot;
    }
  }

  private static void judge(Screenshot shot) {
    assertThat(at(shot, 10, 50)).isEqualTo(0x808080);
    assertThat(at(shot, 25, 15)).isEqualTo(RED & 0xFFFFFF);
    assertThat(at(shot, 75, 15)).isEqualTo(GREEN & 0xFFFFFF);
    assertThat(at(shot, 25, 85)).isEqualTo(BLUE & 0xFFFFFF);
    assertThat(at(shot, 75, 85)).isEqualTo(0x808080); // What is clear lets the page through.
    assertThat(at(shot, 50, 50)).isEqualTo(WHITE & 0xFFFFFF);
  }

  /** The colour at a place of the page, from its upper left corner. */
  private static int at(Screenshot shot, int x, int y) {
    return shot.rgb(x, 99 - y);
  }

  @Test
  void aPictureLiesBetweenWhatComesBeforeAndAfterIt() {
    judge(drawn((painter, gl) -> painter.draw(gl, PAGE, 0, 0, 100, 100)));
  }

  @Test
  void aPictureStandsInTheWorld() {
    Matrix4d seen = new Matrix4d().setOrtho(0, 100, 100, 0, -1, 1);
    Camera camera = new Camera(new Matrix4d(), seen, 0, 0, 100, 100);
    judge(
        drawn(
            (painter, gl) -> painter.draw(gl, new WorldSpacePanel(PAGE, new Matrix4d()), camera)));
  }

  @Test
  void moreCanBeShownThanAreKept() {
    List<Primitive2D> many = new ArrayList<>();
    for (int i = 0; i < 25; i++) {
      many.add(
          new Primitive2D.Picture(new ArgbImage(1, 1, new int[] {WHITE - i}), 4 * i, 0, 4, 100));
    }
    Screenshot shot = drawn((painter, gl) -> painter.draw(gl, many, 0, 0, 100, 100));
    for (int i = 0; i < 25; i++) {
      assertThat(at(shot, 4 * i + 2, 50)).isEqualTo(0xFFFFFF - i);
    }
  }
}
