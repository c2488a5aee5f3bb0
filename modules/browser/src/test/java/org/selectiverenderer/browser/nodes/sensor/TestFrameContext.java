package org.selectiverenderer.browser.nodes.sensor;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.joml.FrustumIntersection;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Matrix4f;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;

/** A frame whose viewer and places a test sets. */
public final class TestFrameContext implements FrameContext {
  final Vector3d eye = new Vector3d();
  final Quaterniond orientation = new Quaterniond();
  Vector3dc centerOfRotation;
  private final Map<Node, List<Matrix4dc>> places = new IdentityHashMap<>();
  private double time;

  TestFrameContext place(Node node, Matrix4dc... at) {
    places.put(node, new ArrayList<>(List.of(at)));
    return this;
  }

  /** One frame of a node. */
  public void step(FrameDrivenNode node, double seconds, EventCascade cascade) {
    time = seconds;
    cascade.at(seconds);
    node.frame(this, cascade);
  }

  @Override
  public double time() {
    return time;
  }

  @Override
  public Vector3dc eye() {
    return eye;
  }

  @Override
  public Quaterniondc orientation() {
    return orientation;
  }

  @Override
  public FrustumIntersection frustum() {
    Matrix4d view =
        new Matrix4d()
            .perspective(Math.PI / 2, 1, 0.1, 100)
            .rotate(orientation.conjugate(new Quaterniond()))
            .translate(-eye.x, -eye.y, -eye.z);
    return new FrustumIntersection(new Matrix4f(view));
  }

  @Override
  public Vector3dc centerOfRotation() {
    return centerOfRotation;
  }

  @Override
  public List<? extends Matrix4dc> places(Node node) {
    return places.getOrDefault(node, List.of());
  }
}
