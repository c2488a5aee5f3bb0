package org.selectiverenderer.runtime.render.show;

import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLException;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.camera.ViewLayout;
import org.selectiverenderer.runtime.render.Drawn;
import org.selectiverenderer.runtime.render.Shading;
import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.runtime.render.context.GlUnavailableException;
import org.selectiverenderer.runtime.render.context.OffscreenContext;
import org.selectiverenderer.runtime.render.context.OffscreenTarget;
import org.selectiverenderer.runtime.render.context.Screenshot;

/**
 * A view of a world without a window. The thread that opens it owns its GL context and makes all
 * calls.
 */
public final class OffscreenView implements AutoCloseable {
  private static final long SECOND = 1_000_000_000L;

  private final OffscreenContext context;
  private final OffscreenTarget target;
  private final WorldPainter painter;
  private long previousFrame;

  private OffscreenView(
      OffscreenContext context, OffscreenTarget target, ViewLayout layout, Shading shading) {
    this.context = context;
    this.target = target;
    painter = new WorldPainter(layout, shading);
  }

  /**
   * Opens a context and a target.
   *
   * @param layout the views of each frame; none may need a window's buffers
   * @param samples per pixel for anti-aliasing; 0 for none
   * @param shading where light is computed
   * @throws org.selectiverenderer.runtime.render.context.GlUnavailableException if there is no
   *     display or no OpenGL 3.3
   */
  public static OffscreenView open(
      int width, int height, int samples, ViewLayout layout, Shading shading) {
    OffscreenContext context = OffscreenContext.open();
    try {
      return new OffscreenView(
          context, new OffscreenTarget(context.gl(), width, height, samples), layout, shading);
    } catch (GLException e) {
      context.close();
      throw new GlUnavailableException(
          "a picture of that size cannot be drawn: " + e.getMessage(), e);
    } catch (RuntimeException e) {
      context.close();
      throw e;
    }
  }

  public GlInfo info() {
    return context.info();
  }

  /** Sends all meshes and textures of the world to the graphics card. */
  public void prepare(World world) {
    painter.prepare(context.gl(), world);
  }

  /**
   * Waits until the frame before is complete, for whoever wants to step the world as late as
   * possible before it is drawn; {@link #draw} would wait after that.
   */
  public void awaitReady() {
    awaitPrevious(context.gl());
  }

  /**
   * Draws a frame. Like a window with two buffers it lets one frame be under way while the next is
   * prepared: it returns when the frame before this one is complete.
   */
  public Drawn draw(World world) {
    GL3 gl = context.gl();
    target.bind(gl);
    awaitPrevious(gl);
    Drawn drawn = painter.paint(gl, world, target.width(), target.height());
    long frame = gl.glFenceSync(GL3.GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.glFlush();
    previousFrame = frame;
    return drawn;
  }

  private void awaitPrevious(GL3 gl) {
    if (previousFrame != 0) {
      gl.glClientWaitSync(previousFrame, 0, SECOND);
      gl.glDeleteSync(previousFrame);
      previousFrame = 0;
    }
  }

  /** Waits until everything is drawn. */
  public void finish() {
    target.finish(context.gl());
  }

  /** The picture last drawn. */
  public Screenshot screenshot() {
    return target.read(context.gl());
  }

  @Override
  public void close() {
    GL3 gl = context.gl();
    awaitPrevious(gl);
    painter.dispose(gl);
    target.dispose(gl);
    context.close();
  }
}
