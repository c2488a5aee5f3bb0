package org.selectiverenderer.browser;

import java.util.List;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.viewer.Viewer;

/** The cameras of the viewer's eyes, wherever the viewer is. */
final class EyeCameras {
  private static final double NEAR = 0.1;
  private static final double FAR = 1000;

  /**
   * An eye of a stereo display.
   *
   * @param toEye the matrix from the viewer's frame to the eye's
   */
  private record Eye(Matrix4dc toEye, Matrix4dc projection, int width, int height) {
    Camera of(Viewer viewer) {
      return new Camera(
          toEye.mul(viewer.view(), new Matrix4d()), projection, 0, 0, width, height);
    }
  }

  private List<Eye> eyes = List.of();

  /** Has a single camera from now on, the viewer's own. */
  void forget() {
    eyes = List.of();
  }

  /**
   * Has these cameras from now on, placed relative to the viewer as they are now.
   *
   * @param scale pixels of these cameras per desktop pixel
   */
  void see(List<Camera> cameras, double scale, Viewer viewer) {
    Matrix4d toWorld = viewer.view().invertAffine();
    eyes =
        cameras.stream()
            .map(
                camera ->
                    new Eye(
                        camera.view().mul(toWorld, new Matrix4d()),
                        camera.projection(),
                        pixels(camera.width() / scale),
                        pixels(camera.height() / scale)))
            .toList();
  }

  List<Camera> of(Viewer viewer, DisplayMetrics picture) {
    if (eyes.isEmpty()) {
      return List.of(
          Camera.of(viewer, pixels(picture.width()), pixels(picture.height()), NEAR, FAR));
    }
    return eyes.stream().map(eye -> eye.of(viewer)).toList();
  }

  private static int pixels(double count) {
    return (int) Math.max(1, Math.round(count));
  }
}
