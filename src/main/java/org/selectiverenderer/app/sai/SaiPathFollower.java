package org.selectiverenderer.app.sai;

import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.joml.AxisAngle4d;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.X3DScene;
import org.web3d.x3d.sai.navigation.NavigationInfo;
import org.web3d.x3d.sai.navigation.Viewpoint;

/**
 * Moves the viewer of a browser along a recorded path in real time through the SAI: it adds a
 * Viewpoint to the scene, binds it and moves it. It also binds a NavigationInfo of type NONE, so
 * that neither the user nor gravity moves the viewer. The two nodes copy field of view, headlight,
 * visibility limit and avatar size from the first Viewpoint and NavigationInfo at the root of the
 * scene, which the browser would have bound.
 */
final class SaiPathFollower {
  /** The interval between moves in milliseconds. */
  static final long STEP_MS = 15;

  /**
   * The number of attempts after which the Viewpoint is taken as bound although the browser has not
   * reported it.
   */
  private static final int BINDING = 200;

  private final CameraPath path;
  private final Viewpoint viewpoint;
  private final NavigationInfo navigation;

  /** Adds the two nodes to the scene. */
  SaiPathFollower(ExternalBrowser browser, CameraPath path) {
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
   * Puts the viewer at the start of the path. A browser may know new nodes only from its next frame
   * on, so the nodes are bound repeatedly until the browser reports that they are bound.
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
   * Moves the viewer to the end of the path and waits there for a moment, because a browser may
   * send its last events late.
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
