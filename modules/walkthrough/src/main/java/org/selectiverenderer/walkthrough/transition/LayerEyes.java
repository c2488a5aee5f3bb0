package org.selectiverenderer.walkthrough.transition;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.LayerView;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.DepthRange;
import org.selectiverenderer.browser.camera.EyeCameras;
import org.selectiverenderer.browser.camera.LayerCameraFactory;

/** The layers of a world that are drawn, and the eyes that see each (X3D 4.0, 35.2). */
final class LayerEyes {
  /** The depth range of the cameras; rays begin at its near end. */
  private static final DepthRange RANGE = new DepthRange(0.1, 1000);

  private final World world;
  private @Nullable List<LayerView> layers;

  LayerEyes(World world) {
    this.world = world;
  }

  /** Begins a frame, whose layers may be others. */
  void begin() {
    layers = null;
  }

  /** Returns the layers of the frame, the lowest first. */
  List<LayerView> layers() {
    List<LayerView> known = layers;
    if (known == null) {
      known = world.layers();
      layers = known;
    }
    return known;
  }

  /** Returns the cameras of a layer for the present poses of the viewers, in desktop pixels. */
  List<Camera> of(LayerView layer) {
    List<Camera> whole = EyeCameras.of(world);
    if (layer.active() && layer.part().equals(LayerView.Part.WHOLE)) {
      return whole;
    }
    boolean mono = world.eyes().isEmpty();
    return whole.stream()
        .map(eye -> LayerCameraFactory.of(eye, world.viewer(), layer, mono, RANGE))
        .toList();
  }
}
