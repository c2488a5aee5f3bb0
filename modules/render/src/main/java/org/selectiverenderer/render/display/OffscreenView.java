package org.selectiverenderer.render.display;

import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLException;
import java.util.Optional;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.RenderOptions;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.context.GlUnavailableException;
import org.selectiverenderer.render.context.OffscreenContext;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.context.Screenshot;

/**
 * Draws a world without a window. The thread that opens it owns its GL context and makes all calls.
 */
public final class OffscreenView implements AutoCloseable {
  /**
   * The most triangles of a frame that may still be rasterised while the next is drawn. A software
   * renderer keeps the triangles of both in memory, about 350 bytes each.
   */
  private static final long MOST_OVERLAPPED = 120_000;

  private final OffscreenContext context;
  private final OffscreenFramebuffer target;
  private final WorldRenderer painter;
  private final FramePacer pace = new FramePacer();
  private long previousTriangles;

  private OffscreenView(
      OffscreenContext context,
      OffscreenFramebuffer target,
      ViewLayout layout,
      RenderOptions style) {
    this.context = context;
    this.target = target;
    painter = new WorldRenderer(layout, style);
  }

  /**
   * Opens a context and a framebuffer.
   *
   * @param layout the views of each frame; none may need a window's stereo buffers
   * @param samples per pixel for anti-aliasing; 0 for none
   * @param shading whether lighting is computed per vertex or per pixel
   * @throws org.selectiverenderer.render.context.GlUnavailableException if there is no display or
   *     no OpenGL 3.3
   */
  public static OffscreenView open(
      int width, int height, int samples, ViewLayout layout, ShadingMode shading) {
    return open(width, height, samples, layout, RenderOptions.of(shading));
  }

  /** Opens a view with further options. */
  public static OffscreenView open(
      int width, int height, int samples, ViewLayout layout, RenderOptions style) {
    OffscreenContext context = OffscreenContext.open();
    try {
      return new OffscreenView(
          context, new OffscreenFramebuffer(context.gl(), width, height, samples), layout, style);
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
   * Waits until the previous frame is complete, so that the caller can step the world as late as
   * possible before drawing it; {@link #draw} would wait after drawing. Frames do not overlap then.
   */
  public void awaitReady() {
    pace.await(context.gl());
  }

  /**
   * Draws a frame. While it processes vertices, the previous frame may still be rasterised, unless
   * that has too many triangles. Returns when the previous frame is complete, so that at most one
   * is in flight. Movies are waited for, so that the frame shows their picture of its time.
   */
  public FrameStatistics draw(World world) {
    GL3 gl = context.gl();
    world.waitForFilms();
    target.bind(gl);
    if (previousTriangles > MOST_OVERLAPPED) {
      pace.await(gl);
    }
    FrameStatistics drawn = painter.paint(gl, world, target.width(), target.height(), 1);
    pace.submitted(gl);
    previousTriangles = drawn.triangles();
    return drawn;
  }

  /** Waits until everything is drawn. */
  public void finish() {
    target.finish(context.gl());
  }

  /** Returns the picture last drawn. */
  public Screenshot screenshot() {
    return target.read(context.gl());
  }

  /**
   * Returns the picture of the world with that many samples per pixel: the one last drawn if it has
   * them, else one that is drawn anew.
   */
  public Screenshot screenshot(World world, int samples) {
    GL3 gl = context.gl();
    if (samples > target.samples()) {
      Optional<Screenshot> smooth =
          painter.picture(gl, world, target.width(), target.height(), 1, samples);
      if (smooth.isPresent()) {
        return smooth.get();
      }
    }
    return screenshot();
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
