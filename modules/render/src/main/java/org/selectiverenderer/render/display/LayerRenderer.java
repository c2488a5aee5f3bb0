package org.selectiverenderer.render.display;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.selectiverenderer.browser.LayerView;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.EyeCameras;
import org.selectiverenderer.browser.camera.HiddenAreaMesh;
import org.selectiverenderer.browser.camera.LayerCameraFactory;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.render.RenderOptions;
import org.selectiverenderer.render.ViewSettings;
import org.selectiverenderer.render.draw.LightingContext;
import org.selectiverenderer.render.draw.SceneRenderer;
import org.selectiverenderer.render.draw.VisibleSet;

/**
 * Draws the layers of a world over one another, the lowest first (X3D 4.0, 35.2.2). Each layer has
 * a renderer of its own; the active layer has the one that worlds without layers use. Belongs to
 * the thread that owns the context.
 */
final class LayerRenderer {
  private final SceneRenderer main;
  private final Supplier<SceneRenderer> maker;
  private final RenderOptions style;
  private final Map<InstanceTree, SceneRenderer> others = new IdentityHashMap<>();
  private final List<Drawing> drawings = new ArrayList<>();
  private List<Camera> views = List.of();

  private record Drawing(
      SceneRenderer renderer, LightingContext setting, List<Camera> cameras, VisibleSet seen) {}

  LayerRenderer(SceneRenderer main, Supplier<SceneRenderer> maker, RenderOptions style) {
    this.main = main;
    this.maker = maker;
    this.style = style;
  }

  /**
   * Prepares the layers of a frame.
   *
   * @param whole the cameras of the user's views, each over its whole viewport
   * @param scale pixels per pixel of the desktop
   * @param mono whether it is a single view from the viewer's own position
   */
  void begin(GL3 gl, World world, List<Camera> whole, boolean mono, double scale) {
    Camera eye = whole.get(0);
    if (mono) {
      world.seenIn(eye.width() / scale, eye.height() / scale, Optional.empty());
    } else {
      world.seenBy(EyeCameras.frames(whole, scale, world.viewer()), eye.angle());
    }
    List<LayerView> layers = world.layers();
    forget(gl, layers);
    drawings.clear();
    views = whole;
    for (LayerView layer : layers) {
      SceneRenderer renderer =
          layer.active() ? main : others.computeIfAbsent(layer.instances(), tree -> maker.get());
      renderer.follow(gl, layer.instances());
      ViewSettings sight = ViewSettings.of(layer);
      List<Camera> cameras =
          layer.active() && layer.part().equals(LayerView.Part.WHOLE)
              ? whole
              : whole.stream()
                  .map(of -> LayerCameraFactory.of(of, world.viewer(), layer, mono, sight.range()))
                  .toList();
      boolean lowest = drawings.isEmpty();
      Optional<Background> backdrop =
          lowest ? layer.backdrop().or(() -> Optional.of(Background.BLACK)) : layer.backdrop();
      LightingContext setting =
          new LightingContext(
              backdrop, style.headlight().orElse(sight.headlight()), layer.fog(), !lowest);
      renderer.reflect(gl, layer.instances(), cameras, setting, sight.range().near());
      drawings.add(
          new Drawing(
              renderer,
              setting,
              cameras,
              style.wireframe() ? renderer.cullToView(gl, cameras) : renderer.cull(gl, cameras)));
    }
  }

  /**
   * Draws the layers of one view.
   *
   * @param view the index of its camera
   * @param hidden the part of it that a lens hides
   */
  void draw(GL3 gl, int view, HiddenAreaMesh hidden) {
    Camera all = views.get(view);
    if (drawings.isEmpty() || !fills(drawings.get(0).cameras().get(view), all)) {
      SceneRenderer.blacken(gl, all);
    }
    for (Drawing drawing : drawings) {
      Camera camera = drawing.cameras().get(view);
      HiddenAreaMesh unseen = fills(camera, all) ? hidden : HiddenAreaMesh.NONE;
      drawing.renderer().draw(gl, drawing.seen(), camera, drawing.setting(), unseen);
    }
  }

  private static boolean fills(Camera part, Camera whole) {
    return part.width() == whole.width() && part.height() == whole.height();
  }

  /** Returns the number of shapes drawn for a view. */
  int shapes() {
    return drawings.stream().mapToInt(drawing -> drawing.seen().shapes()).sum();
  }

  /** Returns the number of indices drawn for a view. */
  long indices() {
    return drawings.stream().mapToLong(drawing -> drawing.seen().indices()).sum();
  }

  private void forget(GL3 gl, List<LayerView> layers) {
    others
        .entrySet()
        .removeIf(
            entry -> {
              boolean gone =
                  layers.stream()
                      .noneMatch(layer -> !layer.active() && layer.instances() == entry.getKey());
              if (gone) {
                entry.getValue().dispose(gl);
              }
              return gone;
            });
  }

  void dispose(GL3 gl) {
    forget(gl, List.of());
  }
}
