package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.selectiverenderer.browser.PointingDeviceState;
import org.selectiverenderer.browser.collision.RayCaster;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * Controls the preview's camera and casts rays through pixels of its picture. Confined to the
 * preview's thread.
 */
final class PreviewCameraController {
  /** Distance of the pivot in metres where nothing is hit straight ahead. */
  private static final double NO_DEPTH = 5;

  /** Radians up of the first look at a scene without a viewpoint. */
  private static final double FROM_ABOVE = Math.toRadians(-35);

  private final OrbitCamera orbit = new OrbitCamera();
  private int width;
  private int height;

  /** The orbit camera, for turning, panning and zooming. */
  OrbitCamera orbit() {
    return orbit;
  }

  /** Sets the size of one picture in pixels. */
  void size(int newWidth, int newHeight) {
    width = newWidth;
    height = newHeight;
  }

  /** Goes to the start viewpoint, or frames the whole scene where there is none. */
  void home(PreviewScene scene) {
    Optional<Pose> start =
        scene
            .world()
            .bindables()
            .bound("X3DViewpointNode")
            .map(
                bound -> {
                  scene.world().views().goTo(bound);
                  return scene.pose();
                });
    if (start.isPresent()) {
      place(scene, start.get());
    } else {
      orbit.face(0, FROM_ABOVE); // A room without a ceiling is looked into, over its walls.
      scene.look(orbit.pose());
      scene.bounds().ifPresent(orbit::frame);
    }
  }

  /** Moves the orbit camera to the scene's viewer. */
  void stay(PreviewScene scene) {
    place(scene, scene.pose());
  }

  private void place(PreviewScene scene, Pose pose) {
    scene.look(pose);
    double distance =
        scene.hit(new Vector3d(0, 0, -1)).map(RayCaster.Hit::distance).orElse(NO_DEPTH);
    orbit.place(pose, distance);
  }

  /**
   * Frames elements, from where walls and other objects do not hide them, or the whole scene where
   * they show nothing.
   */
  void frame(PreviewScene scene, List<List<SourceAnchor>> elements) {
    Optional<BoundingBox> box =
        elements.stream()
            .flatMap(each -> scene.nodes().find(each).flatMap(scene::bounds).stream())
            .reduce(BoundingBox::union);
    box.ifPresent(
        each -> orbit.face(new UnobstructedView(scene, each, orbit.pose()).orientation()));
    box.or(scene::bounds).ifPresent(orbit::frame);
  }

  /** Returns the nearest hit of the ray through a pixel. */
  Optional<RayCaster.Hit> cast(PreviewScene scene, int x, int y) {
    return width == 0 ? Optional.empty() : scene.hit(direction(scene, x, y));
  }

  /** Tells the walked scene which pixel the pointer is over. */
  void point(PreviewScene scene, int x, int y) {
    if (width > 0 && height > 0) {
      scene
          .world()
          .point(
              new PointingDeviceState(
                  Optional.of(direction(scene, x, y)), false, (double) width / height));
    }
  }

  /** Returns the direction of the ray through the centre of a pixel, in the viewer's frame. */
  private Vector3d direction(PreviewScene scene, int x, int y) {
    double half = Math.tan(scene.world().viewer().fieldOfView() / 2);
    double smaller = Math.min(width, height);
    double right = (2 * (x % width + 0.5) - width) / smaller * half;
    double up = (height - 2 * (y + 0.5)) / smaller * half;
    return new Vector3d(right, up, -1);
  }
}
