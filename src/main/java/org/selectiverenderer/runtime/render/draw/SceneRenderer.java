package org.selectiverenderer.runtime.render.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.camera.Camera;
import org.selectiverenderer.runtime.camera.HiddenPart;
import org.selectiverenderer.runtime.instance.Backdrop;
import org.selectiverenderer.runtime.instance.Fog;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.render.Shading;
import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.runtime.render.gpu.TextureFilters;
import org.selectiverenderer.runtime.render.light.LightPlanner;
import org.selectiverenderer.runtime.render.occlude.Occlusion;

/**
 * Draws instance trees. A frame is {@link #prepare}, {@link #cull} once for all eyes, and {@link
 * #draw} once per eye. Belongs to the thread that owns the context.
 *
 * <p>docs/performance.md tells where a frame's time goes. Our own part is under a hundredth of it;
 * on a software renderer the rest is vertex processing, triangle setup and rasterisation, of which
 * {@link Portions} lets the first overlap with the others.
 */
public final class SceneRenderer {
  private final Shading shading;
  private @Nullable GpuAssets assets;
  private Portions portions = new Portions(false);
  private @Nullable DrawList list;
  private final BackdropPainter backdropPainter = new BackdropPainter();
  private final HiddenPainter hiddenPainter = new HiddenPainter();
  private final Visible visible = new Visible();
  private final Culler culler = new Culler(visible);
  private final Occlusion occlusion = new Occlusion();
  private final MirroredImages mirrored = new MirroredImages();
  private final GeneratedCubes cubes = new GeneratedCubes();
  private final float pointSize;
  private boolean wireframe;

  /**
   * @param pointSize the side of a point of a PointSet in pixels
   * @param shading whether lighting is computed per vertex or per pixel
   */
  public SceneRenderer(float pointSize, Shading shading) {
    this.shading = shading;
    this.pointSize = pointSize;
  }

  /** Sets whether only the edges of polygons are drawn. */
  public void wireframe(boolean on) {
    wireframe = on;
  }

  /**
   * Prepares the tree after its update. All shapes are uploaded, shown or not, so that a Switch
   * that changes its choice uploads nothing.
   */
  public void prepare(GL3 gl, InstanceTree tree) {
    follow(gl, tree, true);
  }

  /**
   * Prepares the tree likewise, but defers new hidden shapes, a few of which are uploaded with each
   * frame. Whatever is shown is uploaded now, so that a Switch shows its choice in the frame in
   * which it changes, however early that is.
   */
  public void follow(GL3 gl, InstanceTree tree) {
    follow(gl, tree, false);
  }

  private void follow(GL3 gl, InstanceTree tree, boolean all) {
    if (list == null) {
      GlInfo info = GlInfo.of(gl);
      assets = new GpuAssets(new LightPlanner(shading.byVertex(info)), filters(info));
      portions = new Portions(info.software());
      list = new DrawList(assets);
    }
    mirrored.forgetOthers(gl);
    list.follow(gl, tree, all);
  }

  /**
   * Returns cheap filters for a software renderer, except where per-pixel lighting is asked for:
   * that is for pictures as a graphics card draws them.
   */
  private TextureFilters filters(GlInfo info) {
    if (!info.software()) {
      return TextureFilters.FINE;
    }
    return shading == Shading.PIXEL ? TextureFilters.FINE_BY_PROCESSOR : TextureFilters.QUICK;
  }

  /** Returns the draw items of all shapes of the tree last prepared, shown or not. */
  public List<DrawItem> items() {
    return list == null ? List.of() : list.items();
  }

  /**
   * Returns what the eyes can see of the tree last prepared, without most of what is occluded. The
   * result is reused by the next call.
   */
  public Visible cull(List<Camera> eyes) {
    culler.cull(items(), eyes, occlusion);
    return visible;
  }

  /** Culls to the view frusta only and keeps what is occluded, for wireframe pictures. */
  public Visible cullToView(List<Camera> eyes) {
    culler.cull(items(), eyes, null);
    return visible;
  }

  /**
   * Renders the GeneratedCubeMapTextures of the tree last prepared that are due (X3D 4.0, 34.4.2).
   * To be called before the frame is culled.
   *
   * @param eyes the cameras of the frame; the first carries the headlight
   * @param near the distance of the near plane
   */
  public void reflect(GL3 gl, InstanceTree tree, List<Camera> eyes, Setting setting, double near) {
    cubes.follow(items());
    if (cubes.isEmpty()) {
      return;
    }
    Setting around =
        new Setting(
            Optional.of(setting.backdrop().orElse(Backdrop.BLACK)),
            setting.headlight(),
            setting.fog(),
            false);
    cubes.paint(
        gl,
        tree,
        eyes,
        near,
        (items, camera) -> {
          culler.cull(items, List.of(camera), null);
          draw(gl, visible, camera, eyes.get(0), around, HiddenPart.NONE);
        });
  }

  /** Clears the camera's viewport and draws into it. */
  public void draw(GL3 gl, Visible seen, Camera camera, Backdrop backdrop, boolean headlight) {
    draw(gl, seen, camera, new Setting(Optional.of(backdrop), headlight, Fog.NONE, false));
  }

  /** Makes a camera's viewport black. */
  public static void blacken(GL3 gl, Camera camera) {
    gl.glScissor(camera.x(), camera.y(), camera.width(), camera.height());
    gl.glEnable(GL.GL_SCISSOR_TEST);
    BackdropPainter.clear(gl, Backdrop.BLACK);
    gl.glDisable(GL.GL_SCISSOR_TEST);
  }

  /** Draws into the camera's viewport, over the layer below if the setting says so. */
  public void draw(GL3 gl, Visible seen, Camera camera, Setting setting) {
    draw(gl, seen, camera, setting, HiddenPart.NONE);
  }

  /** Draws likewise, and fills the part of the view that a lens hides with black. */
  public void draw(GL3 gl, Visible seen, Camera camera, Setting setting, HiddenPart hidden) {
    draw(gl, seen, camera, camera, setting, hidden);
  }

  /**
   * @param bearer the camera that carries the headlight
   */
  private void draw(
      GL3 gl, Visible seen, Camera camera, Camera bearer, Setting setting, HiddenPart hidden) {
    boolean opaque =
        !setting.over() || setting.backdrop().map(b -> b.transparency() == 0).orElse(false);
    gl.glViewport(camera.x(), camera.y(), camera.width(), camera.height());
    gl.glScissor(camera.x(), camera.y(), camera.width(), camera.height());
    gl.glEnable(GL.GL_SCISSOR_TEST);
    if (opaque) {
      BackdropPainter.clear(gl, setting.backdrop().orElse(Backdrop.BLACK));
    } else {
      gl.glClear(GL.GL_DEPTH_BUFFER_BIT);
      setting.backdrop().ifPresent(backdrop -> backdropPainter.paintOver(gl, backdrop, camera));
    }
    hiddenPainter.paint(gl, hidden);
    gl.glEnable(GL.GL_DEPTH_TEST);
    gl.glDepthFunc(GL.GL_LESS);
    gl.glEnable(GL3.GL_PROGRAM_POINT_SIZE);
    ItemPainter painter =
        new ItemPainter(
            gl,
            seen,
            camera,
            new EyeLights(camera, setting.headlight() ? bearer : null),
            new EyeScenery(camera, setting.fog(), pointSize, image -> mirrored.of(gl, image)),
            pointSize,
            portions);
    portions.begin(seen.count(0, seen.ranges));
    edgesOnly(gl, wireframe);
    painter.paint(0, seen.opaque);
    painter.end();
    edgesOnly(gl, false);
    if (opaque) {
      backdropPainter.paint(gl, setting.backdrop().orElse(Backdrop.BLACK), camera);
    }
    if (seen.opaque < seen.calls.size()) {
      gl.glEnable(GL.GL_BLEND);
      gl.glBlendFuncSeparate(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA, GL.GL_ZERO, GL.GL_ONE);
      gl.glDepthMask(false);
      edgesOnly(gl, wireframe);
      painter.blend(seen.opaque, seen.calls.size());
      painter.end();
      edgesOnly(gl, false);
      gl.glDepthMask(true);
      gl.glDisable(GL.GL_BLEND);
    }
    portions.end(gl);
    gl.glBindVertexArray(0);
    gl.glDisable(GL.GL_SCISSOR_TEST);
    gl.glDisable(GL.GL_CULL_FACE);
    gl.glFrontFace(GL.GL_CCW);
    gl.glDisable(GL.GL_DEPTH_TEST);
  }

  private void edgesOnly(GL3 gl, boolean on) {
    if (wireframe) {
      gl.glPolygonMode(GL.GL_FRONT_AND_BACK, on ? GL3.GL_LINE : GL3.GL_FILL);
    }
  }

  /** Returns the number of meshes and textures uploaded since the start. */
  public long uploads() {
    return assets == null ? 0 : assets.uploads();
  }

  /** Frees its resources on the graphics card. */
  public void dispose(GL3 gl) {
    mirrored.forgetOthers(gl);
    mirrored.forgetOthers(gl); // The first call only ends the last frame.
    cubes.dispose(gl);
    if (assets != null) {
      assets.dispose(gl);
    }
    backdropPainter.dispose(gl);
    hiddenPainter.dispose(gl);
  }
}
