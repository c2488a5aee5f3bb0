package org.selectiverenderer.render.display;

import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.render.ViewSettings;
import org.selectiverenderer.render.context.OffscreenContext;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.draw.BaselineRenderer;
import org.selectiverenderer.render.mesh.PackedMesh;

/**
 * The baseline that {@link OffscreenView} is compared with: draws the triangles of a world by one
 * call, without a window. The thread that opens it owns its GL context and makes all calls.
 */
public final class BaselineOffscreenView implements AutoCloseable {
  private final OffscreenContext context = OffscreenContext.open();
  private final FramePacer pace = new FramePacer();
  private final OffscreenFramebuffer target;
  private final BaselineRenderer raw;

  /**
   * Opens a context and a framebuffer without anti-aliasing, and uploads the triangles.
   *
   * @param triangles the triangles, as {@link BaselineRenderer#pack} returns them
   * @throws org.selectiverenderer.render.context.GlUnavailableException if there is no display or
   *     no OpenGL 3.3
   */
  public BaselineOffscreenView(PackedMesh triangles, int width, int height) {
    target = new OffscreenFramebuffer(context.gl(), width, height, 0);
    raw = new BaselineRenderer(context.gl(), triangles);
  }

  /** Draws a frame as the world's viewer sees it; returns when the previous one is complete. */
  public void draw(World world) {
    target.bind(context.gl());
    ViewSettings sight = ViewSettings.of(world);
    Camera camera =
        Camera.of(
            world.viewer(),
            target.width(),
            target.height(),
            sight.range().near(),
            sight.range().far());
    raw.draw(context.gl(), camera);
    pace.submitted(context.gl());
  }

  /** Waits until everything is drawn. */
  public void finish() {
    target.finish(context.gl());
  }

  /** Returns the picture last drawn. */
  public Screenshot screenshot() {
    return target.read(context.gl());
  }

  @Override
  public void close() {
    pace.await(context.gl());
    raw.dispose(context.gl());
    target.dispose(context.gl());
    context.close();
  }
}
