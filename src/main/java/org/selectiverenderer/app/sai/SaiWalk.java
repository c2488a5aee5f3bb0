package org.selectiverenderer.app.sai;

import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.joml.AxisAngle4d;
import org.selectiverenderer.runtime.viewer.CameraPath;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.X3DScene;
import org.web3d.x3d.sai.navigation.NavigationInfo;
import org.web3d.x3d.sai.navigation.Viewpoint;

/**
 * Moves the viewer of a browser along a recorded path by the clock on the wall, through the SAI
 * alone: by a Viewpoint of its own that is bound and moved. A NavigationInfo without navigation is
 * bound too, so that no user and no gravity takes the viewer elsewhere. Both look as those at the
 * top of the scene that they stand in for: the first ones, which a browser binds.
 */
final class SaiWalk {
  /** Milliseconds between moves. */
  static final long STEP_MS = 15;

  /** Frames after which a browser that has not said that the Viewpoint is bound is believed. */
  private static final int BINDING = 200;

  private final CameraPath path;
  private final Viewpoint viewpoint;
  private final NavigationInfo navigation;

  /** Brings the nodes into the scene. */
  SaiWalk(ExternalBrowser browser, CameraPath path) {
    this.path = path;
    X3DScene scene = (X3DScene) browser.getExecutionContext();
    navigation = (NavigationInfo) scene.createNode("NavigationInfo");
    navigation.setType(new String[] {"NONE"});
    first(scene, NavigationInfo.class).ifPresent(this::copyLook);
    viewpoint = (Viewpoint) scene.createNode("Viewpoint");
    first(scene, Viewpoint.class)
        .ifPresent(before -> viewpoint.setFieldOfView(before.getFieldOfView()));
    place(path.start());
    scene.addRootNode(navigation);
    scene.addRootNode(viewpoint);
  }

  private static <T> Optional<T> first(X3DScene scene, Class<T> type) {
    return Arrays.stream(scene.getRootNodes()).filter(type::isInstance).map(type::cast).findFirst();
  }

  private void copyLook(NavigationInfo before) {
    navigation.setHeadlight(before.getHeadlight());
    navigation.setVisibilityLimit(before.getVisibilityLimit());
    float[] avatar = new float[before.getNumAvatarSize()];
    before.getAvatarSize(avatar);
    navigation.setAvatarSize(avatar);
  }

  /**
   * Puts the viewer at the beginning of the path. A browser may know new nodes from its next frame
   * on only: it is asked until it says that they are bound.
   */
  void begin(CountDownLatch end) throws InterruptedException {
    for (int i = 0;
        i < BINDING && !viewpoint.getIsBound() && !end.await(STEP_MS, TimeUnit.MILLISECONDS);
        i++) {
      navigation.setBind(true);
      viewpoint.setBind(true);
    }
  }

  /**
   * Walks to the end of the path, and stands there for a moment in which a browser may tell what it
   * told late.
   *
   * @param end ends the walk early when it reaches zero
   */
  void walk(CountDownLatch end, double patience) throws InterruptedException {
    long begun = System.nanoTime();
    double walked = 0;
    while (walked < path.duration() + patience && !end.await(STEP_MS, TimeUnit.MILLISECONDS)) {
      walked = (System.nanoTime() - begun) * 1e-9;
      place(path.start() + walked);
    }
  }

  private void place(double time) {
    CameraPath.Place at = path.at(time);
    viewpoint.setPosition(
        new float[] {(float) at.position().x, (float) at.position().y, (float) at.position().z});
    at.orientation()
        .ifPresent(
            turn -> {
              AxisAngle4d angle = new AxisAngle4d(turn);
              viewpoint.setOrientation(
                  new float[] {
                    (float) angle.x, (float) angle.y, (float) angle.z, (float) angle.angle
                  });
            });
  }
}
