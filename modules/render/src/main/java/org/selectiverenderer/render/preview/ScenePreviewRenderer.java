package org.selectiverenderer.render.preview;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2GL3;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLException;
import java.util.List;
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
import org.selectiverenderer.render.draw.LightingContext;
import org.selectiverenderer.render.draw.SceneRenderer;
import org.selectiverenderer.render.draw.VisibleSet;

/**
 * Draws preview pictures of a world for an author's tool, of any size, with boxes over them and
 * without a window, so that the tool's GUI toolkit can show them. The thread that opens it owns its
 * GL context and makes all calls.
 */
public final class ScenePreviewRenderer implements AutoCloseable {
  private final OffscreenContext context;
  // With per-pixel lighting: a wireframe is to show the triangles of the model, not refined ones.
  private final SceneRenderer renderer = new SceneRenderer(2, ShadingMode.PIXEL);
  private final PreviewOverlayRenderer marks = new PreviewOverlayRenderer();
  private @Nullable OffscreenFramebuffer target;

  private final GlInfo info;
  private int samples;

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
    GL3 gl = context.gl();
    OffscreenFramebuffer drawn = target(gl, width, height, wantedSamples);
    drawn.bind(gl);
    PreviewImage[] picture = new PreviewImage[1];
    world.hold(() -> picture[0] = drawHeld(gl, drawn, world, marking));
    return picture[0];
  }

  private OffscreenFramebuffer target(GL3 gl, int width, int height, int wantedSamples) {
    if (target != null
        && (target.width() != width || target.height() != height || samples != wantedSamples)) {
      target.dispose(gl);
      target = null;
    }
    if (target == null) {
      try {
        target = new OffscreenFramebuffer(gl, width, height, wantedSamples);
        samples = wantedSamples;
      } catch (GLException e) {
        throw new GlUnavailableException(
            "a picture of that size cannot be drawn: " + e.getMessage(), e);
      }
    }
    return target;
  }

  private PreviewImage drawHeld(
      GL3 gl, OffscreenFramebuffer on, World world, PreviewOptions marking) {
    world.seenIn(on.width(), on.height(), Optional.empty());
    renderer.prepare(gl, world.instances());
    ViewSettings sight = ViewSettings.of(world);
    Camera camera =
        Camera.of(
            world.viewer(), on.width(), on.height(), sight.range().near(), sight.range().far());
    List<Camera> eyes = List.of(camera);
    LightingContext setting =
        new LightingContext(
            Optional.of(marking.backdrop().orElseGet(world::backdrop)),
            sight.headlight(),
            world.fog(),
            false);
    renderer.reflect(gl, world.instances(), eyes, setting, sight.range().near());
    VisibleSet seen = marking.wireframe() ? renderer.cullToView(eyes) : renderer.cull(eyes);
    if (marking.wireframe()) {
      gl.glPolygonMode(GL.GL_FRONT_AND_BACK, GL2GL3.GL_LINE);
    }
    renderer.draw(gl, seen, camera, setting);
    gl.glPolygonMode(GL.GL_FRONT_AND_BACK, GL2GL3.GL_FILL);
    marks.boxes(gl, marking.boxes(), camera);
    marks.mask(gl, renderer.items(), marking.masked(), camera);
    return new PreviewImage(
        on.read(gl), camera, new FrameStatistics(seen.shapes(), seen.indices() / 3));
  }

  @Override
  public void close() {
    GL3 gl = context.gl();
    renderer.dispose(gl);
    marks.dispose(gl);
    if (target != null) {
      target.dispose(gl);
    }
    context.close();
  }
}
