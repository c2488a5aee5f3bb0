package org.selectiverenderer.browser.nodes.spline;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.event.KeyframeSearch;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeConstructor;
import org.selectiverenderer.browser.scene.Rotations;
import org.selectiverenderer.geometry.nurbs.NurbsSurface;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.tessellate.NurbsNodeReader;

/**
 * The constructors of the interpolators along splines, by node type name. A node whose keys or
 * control points define no curve sends nothing; outside the keys the first or last value is sent.
 */
public final class SplineInterpolators {
  public static final Map<String, NodeConstructor> MAKERS = makers();

  private SplineInterpolators() {}

  private static Map<String, NodeConstructor> makers() {
    Map<String, NodeConstructor> all = new HashMap<>();
    all.put("SplinePositionInterpolator", answering(spline(3)));
    all.put("SplinePositionInterpolator2D", answering(spline(2)));
    all.put("SplineScalarInterpolator", answering(spline(1)));
    all.put("SquadOrientationInterpolator", answering(SplineInterpolators::squad));
    all.put("NurbsPositionInterpolator", answering(SplineInterpolators::position));
    all.put("NurbsOrientationInterpolator", answering(SplineInterpolators::orientation));
    all.put("NurbsSurfaceInterpolator", answering(SplineInterpolators::surface));
    return Map.copyOf(all);
  }

  private static NodeConstructor answering(FractionNode.Answer answer) {
    return (type, name, location) -> new FractionNode(type, name, location, answer);
  }

  private static void send(Node node, String field, Object value, EventCascade cascade) {
    node.emit(node.type().indexOf(field), value, cascade);
  }

  private static FractionNode.Answer spline(int components) {
    return (fraction, node, cascade) -> {
      float at = (Float) fraction;
      float[] keys = node.floats("key");
      float[] values = node.floats("keyValue");
      int count = Math.min(keys.length, values.length / components);
      if (count == 0) {
        return;
      }
      int low = KeyframeSearch.at(keys, count, at);
      float[] result;
      if (low == count - 1 || at <= keys[low]) {
        result = Arrays.copyOfRange(values, low * components, (low + 1) * components);
      } else {
        double part = ((double) at - keys[low]) / ((double) keys[low + 1] - keys[low]);
        result =
            new HermiteSpline(keys, values, components, count, node.bool("closed"))
                .between(low, part, node.floats("keyVelocity"), node.bool("normalizeVelocity"));
      }
      send(node, "value_changed", components == 1 ? (Object) result[0] : result, cascade);
    };
  }

  private static void squad(Object fraction, Node node, EventCascade cascade) {
    float at = (Float) fraction;
    float[] keys = node.floats("key");
    float[] values = node.floats("keyValue");
    int count = Math.min(keys.length, values.length / 4);
    if (count == 0) {
      return;
    }
    int low = KeyframeSearch.at(keys, count, at);
    float[] result = Arrays.copyOfRange(values, 4 * low, 4 * low + 4);
    if (low < count - 1 && at > keys[low]) {
      Quaterniond[] all = new Quaterniond[count];
      for (int i = 0; i < count; i++) {
        all[i] = Rotations.read(values, 4 * i, new Quaterniond());
      }
      double part = ((double) at - keys[low]) / ((double) keys[low + 1] - keys[low]);
      Rotations.write(SquadInterpolation.between(all, low, part), result);
    }
    send(node, "value_changed", result, cascade);
  }

  private static void position(Object fraction, Node node, EventCascade cascade) {
    NurbsNodeReader.curve(node, problem -> {})
        .map(curve -> curve.at(curve.basis().at((Float) fraction)))
        .ifPresent(at -> send(node, "value_changed", floats(at, 0), cascade));
  }

  /** Sends the orientation with +Z along the curve (27.4.6). */
  private static void orientation(Object fraction, Node node, EventCascade cascade) {
    NurbsNodeReader.curve(node, problem -> {})
        .map(curve -> curve.at(curve.basis().at((Float) fraction)))
        .map(at -> new Vector3d(at[3], at[4], at[5]))
        .filter(way -> way.lengthSquared() > 0 && way.isFinite())
        .ifPresent(
            way -> {
              float[] result = new float[4];
              Rotations.write(new Quaterniond().rotationTo(new Vector3d(0, 0, 1), way), result);
              send(node, "value_changed", result, cascade);
            });
  }

  private static void surface(Object fraction, Node node, EventCascade cascade) {
    float[] part = (float[]) fraction;
    NurbsSurface surface = NurbsNodeReader.surface(node, problem -> {}).orElse(null);
    if (surface == null || Float.isNaN(part[0]) || Float.isNaN(part[1])) {
      return;
    }
    double[] at = surface.at(surface.u().at(part[0]), surface.v().at(part[1]));
    Vector3d normal = new Vector3d(at[3], at[4], at[5]).cross(at[6], at[7], at[8]);
    if (normal.lengthSquared() > 0) {
      normal.normalize();
    }
    send(node, "position_changed", floats(at, 0), cascade);
    send(
        node,
        "normal_changed",
        new float[] {(float) normal.x, (float) normal.y, (float) normal.z},
        cascade);
  }

  private static float[] floats(double[] from, int at) {
    return new float[] {(float) from[at], (float) from[at + 1], (float) from[at + 2]};
  }

  /** A node that answers each {@code set_fraction} with a computed value. */
  private static final class FractionNode extends Node {
    /** Computes and sends the value for a fraction. */
    @FunctionalInterface
    interface Answer {
      /**
       * @param fraction a Float or, for a surface, two floats; not NaN
       */
      void to(Object fraction, Node node, EventCascade cascade);
    }

    private final int fraction;
    private final Answer answer;

    FractionNode(NodeType type, @Nullable String name, SourceLocation location, Answer answer) {
      super(type, name, location);
      this.answer = answer;
      fraction = type.indexOf("set_fraction");
    }

    @Override
    protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
      if (field.index() != fraction || value == null) {
        super.receive(field, value, cascade);
      } else if (!(value instanceof Float number && Float.isNaN(number))) {
        answer.to(value, this, cascade);
      }
    }
  }
}
