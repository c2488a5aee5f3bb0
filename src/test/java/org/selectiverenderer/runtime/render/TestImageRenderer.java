package org.selectiverenderer.runtime.render;

import com.jogamp.opengl.DebugGL3;
import com.jogamp.opengl.GL3;
import java.util.List;
import org.joml.Matrix4d;
import org.selectiverenderer.runtime.camera.Camera;
import org.selectiverenderer.runtime.instance.Background;
import org.selectiverenderer.runtime.render.context.OffscreenContext;
import org.selectiverenderer.runtime.render.context.OffscreenFramebuffer;
import org.selectiverenderer.runtime.render.context.Screenshot;
import org.selectiverenderer.runtime.render.draw.SceneRenderer;

/**
 * Takes pictures of test scenes: 64 x 64 pixels unless said, seen from (0, 0, 10) along -Z, one
 * unit being eight pixels, parallel. Every GL call is checked for errors.
 */
public final class TestImageRenderer implements AutoCloseable {
  public static final int SIZE = 64;

  private final OffscreenContext context = OffscreenContext.open();
  private final GL3 gl = new DebugGL3(context.gl());
  public final SceneRenderer renderer;

  /** Light by pixel. */
  public TestImageRenderer() {
    this(ShadingMode.PIXEL);
  }

  public TestImageRenderer(ShadingMode shading) {
    renderer = new SceneRenderer(2, shading);
  }

  public GL3 gl() {
    return gl;
  }

  /** Four units to each side of the origin; things nearer than z = 10. */
  public static Camera parallel() {
    return new Camera(
        new Matrix4d().translation(0, 0, -10),
        new Matrix4d().setOrtho(-4, 4, -4, 4, 0.1, 100),
        0,
        0,
        SIZE,
        SIZE);
  }

  /** A right angle wide, from a place in the world. */
  public static Camera perspective(Matrix4d view) {
    return new Camera(
        view, new Matrix4d().setPerspective(Math.PI / 2, 1, 0.1, 100), 0, 0, SIZE, SIZE);
  }

  public Screenshot shoot(TestScene scene) {
    return shoot(scene, parallel(), Background.BLACK, false, 0);
  }

  public Screenshot shoot(
      TestScene scene, Camera camera, Background backdrop, boolean headlight, int samples) {
    OffscreenFramebuffer target =
        new OffscreenFramebuffer(
            gl, camera.x() + camera.width(), camera.y() + camera.height(), samples);
    target.bind(gl);
    renderer.prepare(gl, scene.tree());
    renderer.draw(gl, renderer.cull(List.of(camera)), camera, backdrop, headlight);
    Screenshot shot = target.read(gl);
    target.dispose(gl);
    return shot;
  }

  @Override
  public void close() {
    renderer.dispose(gl);
    context.close();
  }
}
