package org.selectiverenderer.render.preview;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2GL3;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLException;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.ViewSettings;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.context.GlUnavailableException;
import org.selectiverenderer.render.context.OffscreenContext;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.draw.LightingContext;
import org.selectiverenderer.render.draw.PixelRectangle;
import org.selectiverenderer.render.draw.SceneRenderer;
import org.selectiverenderer.render.draw.VisibleSet;

/**
 * Draws preview pictures of a world for an author's tool, of any size, with boxes over them and
 * without a window, so that the tool's GUI toolkit can show them. The thread that opens it owns its
 * GL context and makes all calls.
 */
public final class ScenePreviewRenderer implements AutoCloseable {
  /** Share of a picture up to which only a changed part is drawn, with the same samples. */
  private static final double SAME = 0.5;

  /** The same for a picture that had more samples than are wanted now. */
  private static final double FINER = 0.15;

  /** Pixels around a changed part that are drawn too. */
  private static final int BORDER = 2;

  /** The side of the squares that parts consist of, in pixels; a multiple of all patterns. */
  private static final int GRID = 32;

  private final OffscreenContext context;
  // With per-pixel lighting: a wireframe is to show the triangles of the model, not refined ones.
  private final SceneRenderer renderer = new SceneRenderer(2, ShadingMode.PIXEL);
  private final PreviewOverlayRenderer marks = new PreviewOverlayRenderer();
  private final PictureDamage damage = new PictureDamage();
  private final GlInfo info;
  private @Nullable Target target;
  private @Nullable Target patch;

  /** The picture that the next one may differ little from. */
  private @Nullable PreviewImage last;

  /** A framebuffer, and the samples that it was asked for with. */
  private record Target(OffscreenFramebuffer buffer, int samples) {
    boolean fits(int width, int height, int wantedSamples) {
      return buffer.width() == width && buffer.height() == height && samples == wantedSamples;
    }
  }

  private ScenePreviewRenderer(OffscreenContext context) {
    this.context = context;
    this.info = GlInfo.of(context.gl());
  }

  /**
   * Opens a context.
   *
   * @throws GlUnavailableException if there is no display or no OpenGL 3.3
   */
  public static ScenePreviewRenderer open() {
    return new ScenePreviewRenderer(OffscreenContext.open());
  }

  /** Returns the OpenGL driver that draws. */
  public GlInfo info() {
    return info;
  }

  /**
   * Draws a picture of a world as its viewer sees it and waits until it is complete.
   *
   * @param width in pixels, above 0
   * @param height in pixels, above 0
   * @param wantedSamples per pixel for anti-aliasing; 0 for none
   * @throws GlUnavailableException if a picture of that size cannot be drawn
   */
  public PreviewImage draw(
      World world, PreviewOptions marking, int width, int height, int wantedSamples) {
    last = null;
    return redraw(world, marking, width, height, wantedSamples);
  }

  /**
   * Draws a picture likewise. If only a part of it differs from the previous one of the same size,
   * only that is drawn, even if the previous one had more samples than are wanted now.
   *
   * @throws GlUnavailableException if a picture of that size cannot be drawn
   */
  public PreviewImage redraw(
      World world, PreviewOptions marking, int width, int height, int wantedSamples) {
    PreviewImage before = last;
    last = null; // What is compared next is not what it shows, should drawing fail.
    world.hold(() -> last = drawHeld(world, marking, width, height, wantedSamples, before));
    PreviewImage drawn = Objects.requireNonNull(last);
    if (marking.wireframe()) {
      last = null;
    }
    return drawn;
  }

  private PreviewImage drawHeld(
      World world,
      PreviewOptions marking,
      int width,
      int height,
      int wantedSamples,
      @Nullable PreviewImage before) {
    GL3 gl = context.gl();
    world.seenIn(width, height, Optional.empty());
    renderer.prepare(gl, world.instances());
    ViewSettings sight = ViewSettings.of(world);
    Camera camera =
        Camera.of(world.viewer(), width, height, sight.range().near(), sight.range().far());
    LightingContext setting =
        new LightingContext(
            Optional.of(marking.backdrop().orElseGet(world::backdrop)),
            sight.headlight(),
            world.fog(),
            false);
    Optional<List<PixelRectangle>> changed =
        damage.next(world.instances(), renderer.items(), camera, setting, marking);
    renderer.reflect(gl, world.instances(), List.of(camera), setting, sight.range().near());
    VisibleSet seen = cull(gl, camera, marking);
    FrameStatistics statistics = new FrameStatistics(seen.shapes(), seen.indices() / 3);
    if (before != null
        && !marking.wireframe()
        && changed.isPresent()
        && small(changed.get(), camera, before.samples(), wantedSamples)) {
      Screenshot pixels = before.pixels();
      for (PixelRectangle part : changed.get()) {
        pixels = patched(gl, pixels, part, before.samples(), camera, setting, marking);
      }
      return new PreviewImage(pixels, camera, statistics, before.samples());
    }
    Target known = target;
    target = null; // It is disposed of should the next one not be had.
    Target on = target(gl, known, width, height, wantedSamples);
    target = on;
    Screenshot pixels = paint(gl, on, seen, camera, setting, marking);
    return new PreviewImage(pixels, camera, statistics, wantedSamples);
  }

  private VisibleSet cull(GL3 gl, Camera camera, PreviewOptions marking) {
    List<Camera> eyes = List.of(camera);
    return marking.wireframe() ? renderer.cullToView(gl, eyes) : renderer.cull(gl, eyes);
  }

  /** Returns whether drawing only the changed parts of the previous picture pays. */
  private static boolean small(
      List<PixelRectangle> changed, Camera camera, int samples, int wantedSamples) {
    double share = samples > wantedSamples ? FINER : SAME;
    return samples >= wantedSamples
        && changed.stream().mapToLong(PixelRectangle::area).sum()
            <= share * camera.width() * camera.height();
  }

  /**
   * Draws a part of a picture into a framebuffer of its own, which is a little larger, since Mesa's
   * software renderer loses samples at the border of a framebuffer or scissor rectangle.
   */
  private Screenshot patched(
      GL3 gl,
      Screenshot before,
      PixelRectangle part,
      int samples,
      Camera camera,
      LightingContext setting,
      PreviewOptions marking) {
    PixelRectangle drawn = part.enlarged(BORDER, GRID);
    Target known = patch;
    patch = null;
    Target on = target(gl, known, drawn.width(), drawn.height(), samples);
    patch = on;
    VisibleSet seen = cull(gl, drawn.within(camera), marking);
    Camera moved =
        new Camera(
            camera.view(),
            camera.projection(),
            camera.x() - drawn.x(),
            camera.y() - drawn.y(),
            camera.width(),
            camera.height());
    Screenshot pixels = paint(gl, on, seen, moved, setting, marking);
    return before.with(
        pixels, drawn.x(), drawn.y(), part.x(), part.y(), part.width(), part.height());
  }

  private Target target(GL3 gl, @Nullable Target known, int width, int height, int wantedSamples) {
    if (known != null && known.fits(width, height, wantedSamples)) {
      return known;
    }
    if (known != null) {
      known.buffer().dispose(gl);
    }
    try {
      return new Target(new OffscreenFramebuffer(gl, width, height, wantedSamples), wantedSamples);
    } catch (GLException e) {
      throw new GlUnavailableException(
          "a picture of that size cannot be drawn: " + e.getMessage(), e);
    }
  }

  private Screenshot paint(
      GL3 gl,
      Target on,
      VisibleSet seen,
      Camera camera,
      LightingContext setting,
      PreviewOptions marking) {
    on.buffer().bind(gl);
    if (marking.wireframe()) {
      gl.glPolygonMode(GL.GL_FRONT_AND_BACK, GL2GL3.GL_LINE);
    }
    PixelRectangle all = new PixelRectangle(0, 0, on.buffer().width(), on.buffer().height());
    renderer.draw(gl, seen, camera, setting, all);
    gl.glPolygonMode(GL.GL_FRONT_AND_BACK, GL2GL3.GL_FILL);
    marks.boxes(gl, marking.boxes(), camera);
    marks.mask(gl, renderer.items(), marking.masked(), camera);
    return on.buffer().read(gl);
  }

  @Override
  public void close() {
    GL3 gl = context.gl();
    renderer.dispose(gl);
    marks.dispose(gl);
    for (Target each : new Target[] {target, patch}) {
      if (each != null) {
        each.buffer().dispose(gl);
      }
    }
    context.close();
  }
}
