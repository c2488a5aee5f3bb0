package org.selectiverenderer.browser;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.joml.FrustumIntersection;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Matrix4f;
import org.joml.Quaterniondc;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.nodes.sensor.FrameContext;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.viewer.Viewer;

/** The state of the world in one frame, as sensors see it. */
final class WorldFrameContext implements FrameContext {
  /** Aspect ratio (width to height) assumed for the view frustum: headless runs have no window. */
  static final double ASPECT = 4.0 / 3.0;

  private static final double NEAR = 0.01;
  private static final double FAR = 1e6;

  private final double time;
  private final Viewer viewer;
  private final InstanceTree instances;
  private final Supplier<Optional<Vector3dc>> pivot;
  private @Nullable FrustumIntersection frustum;

  /**
   * @param pivot the centre of rotation, if the navigation type has one
   */
  WorldFrameContext(
      double time, Viewer viewer, InstanceTree instances, Supplier<Optional<Vector3dc>> pivot) {
    this.pivot = pivot;
    this.time = time;
    this.viewer = viewer;
    this.instances = instances;
  }

  @Override
  public double time() {
    return time;
  }

  @Override
  public Vector3dc eye() {
    return viewer.position();
  }

  @Override
  public Quaterniondc orientation() {
    return viewer.orientation();
  }

  @Override
  public FrustumIntersection frustum() {
    if (frustum == null) {
      Matrix4d projection =
          viewer
              .extent()
              .map(extent -> extent.filling(ASPECT))
              .map(
                  seen ->
                      new Matrix4d()
                          .ortho(seen.left(), seen.right(), seen.bottom(), seen.top(), NEAR, FAR))
              .orElseGet(() -> new Matrix4d().perspective(viewer.fieldOfView(), ASPECT, NEAR, FAR))
              .mul(viewer.view());
      frustum = new FrustumIntersection(new Matrix4f(projection));
    }
    return frustum;
  }

  @Override
  public @Nullable Vector3dc centerOfRotation() {
    return pivot.get().orElse(null);
  }

  @Override
  public List<? extends Matrix4dc> places(Node node) {
    return instances.places(node);
  }

  @Override
  public List<? extends Matrix4dc> shownPlaces(Node node) {
    return instances.instances(node).stream().filter(Instance::shown).map(Instance::world).toList();
  }
}
