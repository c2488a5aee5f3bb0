package org.selectiverenderer.runtime.render.show;

import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLException;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.camera.ViewLayout;
import org.selectiverenderer.runtime.render.DrawStyle;
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
  /**
   * Triangles of a frame that may still be filled while the next is drawn. A software renderer
   * keeps the triangles of both in memory, about 350 bytes each.
   */
  private static final long MOST_OVERLAPPED = 120_000;

  private final OffscreenContext context;
  private final OffscreenTarget target;
  private final WorldPainter painter;
  private final FramePace pace = new FramePace();
  private long previousTriangles;

  private OffscreenView(
      OffscreenContext context, OffscreenTarget target, ViewLayout layout, DrawStyle style) {
    this.context = context;
    this.target = target;
    painter = new WorldPainter(layout, style);
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
    return open(width, height, samples, layout, DrawStyle.of(shading));
  }

  /** The same, drawn in another way than the scene says. */
  public static OffscreenView open(
      int width, int height, int samples, ViewLayout layout, DrawStyle style) {
    OffscreenContext context = OffscreenContext.open();
    try {
      return new OffscreenView(
          context, new OffscreenTarget(context.gl(), width, height, samples), layout, style);
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
   * possible before it is drawn; {@link #draw} would wait after that. Nothing overlaps then.
   */
  public void awaitReady() {
    pace.await(context.gl());
  }

  /**
   * Draws a frame. While it does the work that comes before pixels, the rasteriser may still fill
   * the frame before, unless that has too many triangles. Returns when the frame before this one is
   * complete, so that at most one is under way. Films are seen as they are at that time, however
   * long they take to decode.
   */
  public Drawn draw(World world) {
    GL3 gl = context.gl();
    world.waitForFilms();
    target.bind(gl);
    if (previousTriangles > MOST_OVERLAPPED) {
      pace.await(gl);
    }
    Drawn drawn = painter.paint(gl, world, target.width(), target.height(), 1);
    pace.submitted(gl);
    previousTriangles = drawn.triangles();
    return drawn;
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
    pace.await(gl);
    painter.dispose(gl);
    target.dispose(gl);
    context.close();
  }
}
