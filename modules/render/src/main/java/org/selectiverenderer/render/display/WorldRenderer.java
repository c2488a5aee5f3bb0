package org.selectiverenderer.render.display;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLException;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.DepthRange;
import org.selectiverenderer.browser.camera.EyeView;
import org.selectiverenderer.browser.camera.HeadFixedPage;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.RenderOptions;
import org.selectiverenderer.render.ViewSettings;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.draw.SceneRenderer;
import org.selectiverenderer.render.graphics2d.Graphics2dRenderer;
import org.selectiverenderer.x3d.tessellate.TextMesher;

/**
 * Draws a world as its viewer sees it: the bound NavigationInfo determines headlight and depth
 * range, the bound Background what is behind the shapes. Belongs to the thread that owns the
 * context.
 */
public final class WorldRenderer {
  /** Side of a point of a PointSet in pixels. */
  private static final float POINT_SIZE = 2;

  /** The depths of pages, which are in front of everything. */
  private static final DepthRange READING = new DepthRange(1e-3, 1e6);

  /** Share of a view that a page fills. */
  private static final double PAGE = 0.9;

  private final SceneRenderer renderer;
  private final LayerRenderer layers;
  private final Graphics2dRenderer sketch = new Graphics2dRenderer(new TextMesher());
  private final ViewLayout layout;
  private FrameStatistics drawn = new FrameStatistics(0, 0);

  /** Makes a renderer that draws all frames in that layout. */
  public WorldRenderer(ViewLayout layout, RenderOptions style) {
    this.layout = layout;
    Supplier<SceneRenderer> renderers =
        () -> {
          SceneRenderer made = new SceneRenderer(POINT_SIZE, style.shading());
          made.wireframe(style.wireframe());
          return made;
        };
    renderer = renderers.get();
    layers = new LayerRenderer(renderer, renderers, style);
  }

  /** Sends all meshes and textures of the world to the graphics card. */
  public void prepare(GL3 gl, World world) {
    world.hold(() -> renderer.prepare(gl, world.instances()));
  }

  /** Returns the number of meshes and textures uploaded since the start. */
  long uploads() {
    return renderer.uploads();
  }

  /**
   * Draws into the whole framebuffer of that size while no other thread changes the world; returns
   * the counts of what was drawn.
   *
   * @param scale pixels per pixel of the desktop
   */
  public FrameStatistics paint(GL3 gl, World world, int width, int height, double scale) {
    world.hold(() -> drawn = paintHeld(gl, world, width, height, scale));
    return drawn;
  }

  /**
   * Draws the world into a framebuffer of its own and returns the picture; empty where the driver
   * cannot make that framebuffer. What was bound for drawing stays bound.
   *
   * @param scale pixels per pixel of the desktop
   * @param samples samples per pixel for anti-aliasing
   */
  public Optional<Screenshot> picture(
      GL3 gl, World world, int width, int height, double scale, int samples) {
    int[] bound = new int[1];
    gl.glGetIntegerv(GL.GL_FRAMEBUFFER_BINDING, bound, 0);
    OffscreenFramebuffer target;
    try {
      target = new OffscreenFramebuffer(gl, width, height, samples);
    } catch (GLException e) {
      gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, bound[0]);
      return Optional.empty(); // too large for this driver
    }
    try {
      target.bind(gl);
      paint(gl, world, width, height, scale);
      return Optional.of(target.read(gl));
    } finally {
      target.dispose(gl);
      gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, bound[0]);
    }
  }

  private FrameStatistics paintHeld(GL3 gl, World world, int width, int height, double scale) {
    ViewSettings sight = ViewSettings.of(world);
    List<EyeView> views = layout.views(world, width, height, sight.range());
    layers.begin(
        gl, world, views.stream().map(EyeView::camera).toList(), layout == ViewLayout.MONO, scale);
    if (!layout.showsWorld() || !covered(views, width, height)) {
      gl.glClearColor(0, 0, 0, 1);
      gl.glClear(GL.GL_COLOR_BUFFER_BIT);
    }
    for (int i = 0; i < views.size(); i++) {
      Camera camera = views.get(i).camera();
      direct(gl, views.get(i).channel());
      if (layout.showsWorld()) {
        layers.draw(gl, i, views.get(i).hidden());
      }
      List<Primitive2D> marks = layout.marks(i, camera.width(), camera.height());
      sketch.draw(gl, marks, camera.x(), camera.y(), camera.width(), camera.height());
    }
    undirect(gl, views.get(views.size() - 1).channel());
    return new FrameStatistics(layers.shapes(), views.size() * layers.indices() / 3);
  }

  /** Draws a page that moves with the head over each view. */
  public void page(GL3 gl, World world, int width, int height, HeadFixedPage page) {
    List<EyeView> views = layout.views(world, width, height, READING);
    for (EyeView view : views) {
      Camera camera = view.camera();
      direct(gl, view.channel());
      double scale =
          PAGE * Math.min(camera.width() / page.width(), camera.height() / page.height());
      int across = (int) Math.round(scale * page.width());
      int down = (int) Math.round(scale * page.height());
      // Where the view shows what lies straight ahead at infinity.
      double ahead = -camera.projection().m20();
      double above = -camera.projection().m21();
      sketch.draw(
          gl,
          page,
          camera.x() + (int) Math.round(camera.width() * (1 + ahead) / 2 - across / 2.0),
          camera.y() + (int) Math.round(camera.height() * (1 + above) / 2 - down / 2.0),
          across,
          down);
    }
    undirect(gl, views.get(views.size() - 1).channel());
  }

  /** Returns whether the views fill the framebuffer; otherwise the rest is to be cleared. */
  private static boolean covered(List<EyeView> views, int width, int height) {
    long area = 0;
    for (EyeView view : views) {
      area += (long) view.camera().width() * view.camera().height();
    }
    return area >= (long) width * height;
  }

  private static void direct(GL3 gl, EyeView.Channel channel) {
    switch (channel) {
      case RED -> gl.glColorMask(true, false, false, true);
      case CYAN -> gl.glColorMask(false, true, true, true);
      case LEFT_BUFFER -> gl.glDrawBuffer(GL3.GL_BACK_LEFT);
      case RIGHT_BUFFER -> gl.glDrawBuffer(GL3.GL_BACK_RIGHT);
      case ALL -> {
        // As it was.
      }
    }
  }

  private static void undirect(GL3 gl, EyeView.Channel last) {
    gl.glColorMask(true, true, true, true);
    if (last == EyeView.Channel.RIGHT_BUFFER) {
      gl.glDrawBuffer(GL.GL_BACK);
    }
  }

  public void dispose(GL3 gl) {
    layers.dispose(gl);
    renderer.dispose(gl);
    sketch.dispose(gl);
  }
}
