package org.selectiverenderer.browser.camera;

import java.util.List;
import org.joml.Matrix4d;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.viewer.EyeFrame;
import org.selectiverenderer.browser.viewer.Viewer;

/** Converts cameras that were drawn with to those of another pose of the viewer. */
public final class EyeCameras {
  private static final double NEAR = 0.1;
  private static final double FAR = 1000;

  private EyeCameras() {}

  /**
   * Returns the views of cameras relative to the viewer.
   *
   * @param scale pixels of the cameras per desktop pixel
   * @param viewer the viewer, at the pose of the cameras
   */
  public static List<EyeFrame> frames(List<Camera> cameras, double scale, Viewer viewer) {
    Matrix4d toWorld = viewer.view().invertAffine();
    return cameras.stream()
        .map(
            camera ->
                new EyeFrame(
                    camera.view().mul(toWorld, new Matrix4d()),
                    camera.projection(),
                    camera.width() / scale,
                    camera.height() / scale))
        .toList();
  }

  /**
   * Returns the cameras of a world's eyes at the viewer's present pose, in desktop pixels: as they
   * were announced last, or a single one. Their near and far planes have no meaning.
   */
  public static List<Camera> of(World world) {
    Viewer viewer = world.viewer();
    if (world.eyes().isEmpty()) {
      return List.of(
          Camera.of(
              viewer, pixels(world.pictureWidth()), pixels(world.pictureHeight()), NEAR, FAR));
    }
    return world.eyes().stream()
        .map(
            eye ->
                new Camera(
                    eye.toEye().mul(viewer.view(), new Matrix4d()),
                    eye.projection(),
                    0,
                    0,
                    pixels(eye.width()),
                    pixels(eye.height())))
        .toList();
  }

  private static int pixels(double count) {
    return (int) Math.max(1, Math.round(count));
  }
}
