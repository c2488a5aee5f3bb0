package org.selectiverenderer.runtime.nodes.follow;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.NodeMaker;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * The constructors of chasers and dampers, by node type name (X3D 4.0, 39.4). Colours are
 * interpolated in RGB.
 */
public final class Followers {
  public static final Map<String, NodeMaker> MAKERS = makers();

  private static final int MOST_FILTERS = 5;

  private Followers() {}

  private static Map<String, NodeMaker> makers() {
    Map<String, NodeMaker> makers = new HashMap<>();
    for (String value : new String[] {"Scalar", "Position", "Color", "Coordinate"}) {
      put(makers, value, "", FollowSpace.LINEAR);
    }
    put(makers, "Position", "2D", FollowSpace.LINEAR);
    put(makers, "TexCoord", "2D", FollowSpace.LINEAR);
    put(makers, "Orientation", "", FollowSpace.ROTATION);
    return Map.copyOf(makers);
  }

  private static void put(
      Map<String, NodeMaker> makers, String value, String dimension, FollowSpace space) {
    makers.put(
        value + "Chaser" + dimension,
        (type, name, location) -> new ChaserNode(type, name, location, space));
    makers.put(
        value + "Damper" + dimension,
        (type, name, location) -> new DamperNode(type, name, location, space));
  }

  private static final class ChaserNode extends FollowerNode {
    private final int duration;

    ChaserNode(NodeType type, @Nullable String name, Location location, FollowSpace space) {
      super(type, name, location, space);
      duration = type.indexOf("duration");
    }

    @Override
    FollowerResponse respond() {
      return new ChaserResponse(space, (Double) value(duration));
    }

    @Override
    boolean immediate() {
      return !((Double) value(duration) > 0);
    }
  }

  private static final class DamperNode extends FollowerNode {
    private final int order;
    private final int tau;
    private final int tolerance;

    DamperNode(NodeType type, @Nullable String name, Location location, FollowSpace space) {
      super(type, name, location, space);
      order = type.indexOf("order");
      tau = type.indexOf("tau");
      tolerance = type.indexOf("tolerance");
    }

    @Override
    FollowerResponse respond() {
      int filters = Math.max(1, Math.min(MOST_FILTERS, (Integer) value(order)));
      return new DamperResponse(
          space, filters, () -> (Double) value(tau), () -> (Float) value(tolerance));
    }

    @Override
    boolean immediate() {
      return (Integer) value(order) <= 0 || !((Double) value(tau) > 0);
    }
  }
}
