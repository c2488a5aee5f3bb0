package org.selectiverenderer.render.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.BitSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.HiddenAreaMesh;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.CubeTexture;
import org.selectiverenderer.browser.instance.Fog;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.VersionFades;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.gpu.GpuTexture;
import org.selectiverenderer.render.gpu.TextureFilterQuality;
import org.selectiverenderer.render.lighting.LightingPlanner;
import org.selectiverenderer.render.occlusion.OcclusionCuller;

/**
 * Draws instance trees. A frame is {@link #prepare}, {@link #cull} once for all eyes, and {@link
 * #draw} once per eye. Belongs to the thread that owns the context.
 *
 * <p>docs/performance.md tells where a frame's time goes. Our own part is under a hundredth of it;
 * on a software renderer the rest is vertex processing, triangle setup and rasterisation, of which
 * {@link FrameFlusher} lets the first overlap with the others.
 */
public final class SceneRenderer {
  private final ShadingMode shading;
  private @Nullable GpuResourceCache assets;
  private FrameFlusher portions = new FrameFlusher(false);
  private @Nullable DrawItemCache list;
  private final BackgroundRenderer backdropPainter = new BackgroundRenderer();
  private final CrossFadeRenderer crossFade = new CrossFadeRenderer();
  private final HiddenAreaMeshRenderer hiddenPainter = new HiddenAreaMeshRenderer();
  private final VisibleSet visible = new VisibleSet();
  private final Culler culler = new Culler(visible);
  private final Culler cubeCuller = new Culler(visible);
  private final OcclusionCuller occlusion = new OcclusionCuller();
  private final EnvironmentMapCache mirrored = new EnvironmentMapCache();
  private final GeneratedCubeMapRenderer cubes = new GeneratedCubeMapRenderer();
  private final float pointSize;
  private final UnseenShapes.Limits limits;
  private boolean wireframe;

  /**
   * @param pointSize the side of a point of a PointSet in pixels
   * @param shading whether lighting is computed per vertex or per pixel
   */
  public SceneRenderer(float pointSize, ShadingMode shading) {
    this(pointSize, shading, UnseenShapes.Limits.USUAL);
  }

  SceneRenderer(float pointSize, ShadingMode shading, UnseenShapes.Limits limits) {
    this.shading = shading;
    this.pointSize = pointSize;
    this.limits = limits;
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
   * which it changes, however early that is; of a large scene, what {@link #cull} finds that is
   * seen, and then what is near.
   */
  public void follow(GL3 gl, InstanceTree tree) {
    follow(gl, tree, false);
  }

  private void follow(GL3 gl, InstanceTree tree, boolean all) {
    if (list == null) {
      GlInfo info = GlInfo.of(gl);
      assets = new GpuResourceCache(new LightingPlanner(shading.byVertex(info)), filters(info));
      portions = new FrameFlusher(info.software());
      list = new DrawItemCache(assets, limits);
    }
    mirrored.forgetOthers(gl);
    list.follow(gl, tree, all);
  }

  /**
   * Returns cheap filters for a software renderer, except where per-pixel lighting is asked for:
   * that is for pictures as a graphics card draws them.
   */
  private TextureFilterQuality filters(GlInfo info) {
    if (!info.software()) {
      return TextureFilterQuality.FINE;
    }
    return shading == ShadingMode.PIXEL
        ? TextureFilterQuality.FINE_BY_PROCESSOR
        : TextureFilterQuality.QUICK;
  }

  /** Returns the draw items of all shapes of the tree last prepared, shown or not. */
  public List<DrawItem> items() {
    return list == null ? List.of() : list.items();
  }

  /**
   * Returns what the eyes can see of the tree last prepared, without most of what is occluded. The
   * result is reused by the next call.
   */
  public VisibleSet cull(GL3 gl, List<Camera> eyes) {
    return cull(gl, eyes, occlusion);
  }

  /** Culls to the view frusta only and keeps what is occluded, for wireframe pictures. */
  public VisibleSet cullToView(GL3 gl, List<Camera> eyes) {
    return cull(gl, eyes, null);
  }

  /**
   * Culls, and makes ready what an eye sees for the first time: the nearest groups of shapes first,
   * then more at a time, as the nearest hide most of what is behind them.
   */
  private VisibleSet cull(GL3 gl, List<Camera> eyes, @Nullable OcclusionCuller hiding) {
    if (list == null) {
      culler.cull(Culler.Items.of(List.of()), eyes, hiding);
      return visible;
    }
    culler.withoutFading();
    culler.begin(list, eyes, hiding);
    for (int groups = 1; !list.complete(); groups *= 2) {
      BitSet missing = culler.missing(list);
      if (missing.isEmpty()) {
        break;
      }
      list.see(gl, missing, eyes.get(0).eye(), groups);
      culler.begin(list, eyes, hiding);
    }
    culler.finish(list);
    fade(list);
    list.seen(visible, eyes.get(0).eye());
    return visible;
  }

  /** Adds the versions that are being faded to the visible set. */
  private void fade(DrawItemCache items) {
    for (VersionFades.FadingVersion version : items.fades()) {
      VisibleSet seen = new VisibleSet();
      List<DrawItem> all =
          version.shapes().stream().map(items::of).filter(Objects::nonNull).toList();
      all.stream().filter(item -> !item.blended()).forEach(item -> culler.addWhole(item, seen));
      all.stream().filter(DrawItem::blended).forEach(item -> culler.addWhole(item, seen));
      visible.fading.add(new VisibleSet.Fading(seen, version));
    }
  }

  /**
   * Renders the GeneratedCubeMapTextures of the tree last prepared that are due (X3D 4.0, 34.4.2).
   * To be called before the frame is culled.
   *
   * @param eyes the cameras of the frame; the first carries the headlight
   * @param near the distance of the near plane
   */
  public void reflect(
      GL3 gl, InstanceTree tree, List<Camera> eyes, LightingContext setting, double near) {
    cubes.follow(list != null && list.reflects() ? items() : List.of());
    if (cubes.isEmpty()) {
      return;
    }
    LightingContext around =
        new LightingContext(
            Optional.of(setting.backdrop().orElse(Background.BLACK)),
            setting.headlight(),
            setting.fog(),
            false);
    cubes.paint(
        gl,
        tree,
        eyes,
        near,
        (items, camera) -> {
          cubeCuller.cull(Culler.Items.of(items), List.of(camera), null);
          PixelRectangle all = PixelRectangle.of(camera);
          draw(gl, visible, camera, eyes.get(0), around, HiddenAreaMesh.NONE, all);
        });
  }

  /** Clears the camera's viewport and draws into it. */
  public void draw(GL3 gl, VisibleSet seen, Camera camera, Background backdrop, boolean headlight) {
    draw(gl, seen, camera, new LightingContext(Optional.of(backdrop), headlight, Fog.NONE, false));
  }

  /** Makes a camera's viewport black. */
  public static void blacken(GL3 gl, Camera camera) {
    gl.glScissor(camera.x(), camera.y(), camera.width(), camera.height());
    gl.glEnable(GL.GL_SCISSOR_TEST);
    BackgroundRenderer.clear(gl, Background.BLACK);
    gl.glDisable(GL.GL_SCISSOR_TEST);
  }

  /** Draws into the camera's viewport, over the layer below if the setting says so. */
  public void draw(GL3 gl, VisibleSet seen, Camera camera, LightingContext setting) {
    draw(gl, seen, camera, setting, HiddenAreaMesh.NONE);
  }

  /** Draws likewise, but only the pixels of a part of the viewport. */
  public void draw(
      GL3 gl, VisibleSet seen, Camera camera, LightingContext setting, PixelRectangle part) {
    draw(gl, seen, camera, camera, setting, HiddenAreaMesh.NONE, part);
  }

  /** Draws likewise, and fills the part of the view that a lens hides with black. */
  public void draw(
      GL3 gl, VisibleSet seen, Camera camera, LightingContext setting, HiddenAreaMesh hidden) {
    draw(gl, seen, camera, camera, setting, hidden, PixelRectangle.of(camera));
  }

  /**
   * @param bearer the camera that carries the headlight
   * @param part the pixels that are drawn
   */
  private void draw(
      GL3 gl,
      VisibleSet seen,
      Camera camera,
      Camera bearer,
      LightingContext setting,
      HiddenAreaMesh hidden,
      PixelRectangle part) {
    boolean opaque =
        !setting.over() || setting.backdrop().map(b -> b.transparency() == 0).orElse(false);
    gl.glViewport(camera.x(), camera.y(), camera.width(), camera.height());
    gl.glScissor(part.x(), part.y(), part.width(), part.height());
    gl.glEnable(GL.GL_SCISSOR_TEST);
    if (opaque) {
      BackgroundRenderer.clear(gl, setting.backdrop().orElse(Background.BLACK));
    } else {
      gl.glClear(GL.GL_DEPTH_BUFFER_BIT);
      setting.backdrop().ifPresent(backdrop -> backdropPainter.paintOver(gl, backdrop, camera));
    }
    hiddenPainter.paint(gl, hidden);
    gl.glEnable(GL.GL_DEPTH_TEST);
    gl.glDepthFunc(GL.GL_LESS);
    gl.glEnable(GL3.GL_PROGRAM_POINT_SIZE);
    EyeSpaceLights lights = new EyeSpaceLights(camera, setting.headlight() ? bearer : null);
    EyeSpaceEffects effects =
        new EyeSpaceEffects(camera, setting.fog(), pointSize, image -> mirrored.of(gl, image));
    Function<VisibleSet, DrawItemRenderer> painters =
        items -> new DrawItemRenderer(gl, items, camera, lights, effects, pointSize, portions);
    DrawItemRenderer painter = painters.apply(seen);
    portions.begin(seen.count(0, seen.ranges));
    edgesOnly(gl, wireframe);
    painter.paint(0, seen.opaque);
    painter.end();
    edgesOnly(gl, false);
    crossFade.begin(gl, seen, camera);
    edgesOnly(gl, wireframe);
    crossFade.paint(gl, seen, false, painters);
    edgesOnly(gl, false);
    if (opaque) {
      backdropPainter.paint(gl, setting.backdrop().orElse(Background.BLACK), camera);
    }
    if (seen.blends()) {
      gl.glEnable(GL.GL_BLEND);
      gl.glBlendFuncSeparate(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA, GL.GL_ZERO, GL.GL_ONE);
      gl.glDepthMask(false);
      edgesOnly(gl, wireframe);
      painter.blend(seen.opaque, seen.calls.size());
      painter.end();
      crossFade.paint(gl, seen, true, painters);
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
    crossFade.dispose(gl);
  }

  /**
   * The environment maps that surfaces reflect, on the graphics card; each is kept as long as every
   * frame uses it. Belongs to the thread that owns the context.
   */
  private static final class EnvironmentMapCache {
    private final Map<CubeTexture, GpuTexture> known = new HashMap<>();
    private final Set<CubeTexture> used = new HashSet<>();

    GpuTexture of(GL3 gl, CubeTexture image) {
      used.add(image);
      return known.computeIfAbsent(
          image, wanted -> new GpuTexture(gl, wanted, TextureFilterQuality.FINE));
    }

    /** Frees the environment maps that were not used since the last call. */
    void forgetOthers(GL3 gl) {
      if (known.isEmpty()) {
        return;
      }
      known
          .entrySet()
          .removeIf(
              entry -> {
                boolean unused = !used.contains(entry.getKey());
                if (unused) {
                  entry.getValue().dispose(gl);
                }
                return unused;
              });
      used.clear();
    }
  }
}
