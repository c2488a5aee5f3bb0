package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.selectiverenderer.runtime.Pointer;
import org.selectiverenderer.runtime.collide.RayCaster;
import org.selectiverenderer.runtime.viewer.Pose;

/**
 * The author's eye: where it is put, and what lies under a pixel of its picture. Belongs to the
 * preview's thread.
 */
final class StageEye {
  /** How far ahead the eye turns about something where nothing is in view, metres. */
  private static final double NO_DEPTH = 5;

  private final Orbit orbit = new Orbit();
  private int width;
  private int height;

  /** For turning, shifting and coming nearer. */
  Orbit orbit() {
    return orbit;
  }

  /** Of one picture, pixels. */
  void size(int newWidth, int newHeight) {
    width = newWidth;
    height = newHeight;
  }

  /** To the start viewpoint, or so that the whole scene is seen where there is none. */
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
      scene.look(orbit.pose());
      scene.bounds().ifPresent(orbit::frame);
    }
  }

  /** Where the scene's viewer is. */
  void stay(PreviewScene scene) {
    place(scene, scene.pose());
  }

  private void place(PreviewScene scene, Pose pose) {
    scene.look(pose);
    double distance =
        scene.hit(new Vector3d(0, 0, -1)).map(RayCaster.Hit::distance).orElse(NO_DEPTH);
    orbit.place(pose, distance);
  }

  /** Brings an element into view, or all of the scene where it has nothing to be seen. */
  void frame(PreviewScene scene, List<Anchor> element) {
    scene.nodes().find(element).flatMap(scene::bounds).or(scene::bounds).ifPresent(orbit::frame);
  }

  /** What is under a pixel. */
  Optional<RayCaster.Hit> cast(PreviewScene scene, int x, int y) {
    return width == 0 ? Optional.empty() : scene.hit(direction(scene, x, y));
  }

  /** Says to the scene of a walk which pixel the pointer is over. */
  void point(PreviewScene scene, int x, int y) {
    if (width > 0 && height > 0) {
      scene
          .world()
          .point(new Pointer(Optional.of(direction(scene, x, y)), false, (double) width / height));
    }
  }

  /** Of the line of sight through the middle of a pixel, in the viewer's frame. */
  private Vector3d direction(PreviewScene scene, int x, int y) {
    double half = Math.tan(scene.world().viewer().fieldOfView() / 2);
    double smaller = Math.min(width, height);
    double right = (2 * (x % width + 0.5) - width) / smaller * half;
    double up = (height - 2 * (y + 0.5)) / smaller * half;
    return new Vector3d(right, up, -1);
  }
}
