package org.selectiverenderer.browser.nodes.follow;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.NodeConstructor;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * The constructors of chasers and dampers, by node type name (X3D 4.0, 39.4). Colours are
 * interpolated in RGB.
 */
public final class FollowerNodes {
  public static final Map<String, NodeConstructor> MAKERS = makers();

  private static final int MOST_FILTERS = 5;

  private FollowerNodes() {}

  private static Map<String, NodeConstructor> makers() {
    Map<String, NodeConstructor> makers = new HashMap<>();
    for (String value : new String[] {"Scalar", "Position", "Color", "Coordinate"}) {
      put(makers, value, "", FollowerValueSpace.LINEAR);
    }
    put(makers, "Position", "2D", FollowerValueSpace.LINEAR);
    put(makers, "TexCoord", "2D", FollowerValueSpace.LINEAR);
    put(makers, "Orientation", "", FollowerValueSpace.ROTATION);
    return Map.copyOf(makers);
  }

  private static void put(
      Map<String, NodeConstructor> makers,
      String value,
      String dimension,
      FollowerValueSpace space) {
    makers.put(
        value + "Chaser" + dimension,
        (type, name, location) -> new ChaserNode(type, name, location, space));
    makers.put(
        value + "Damper" + dimension,
        (type, name, location) -> new DamperNode(type, name, location, space));
  }

  private static final class ChaserNode extends FollowerNode {
    private final int duration;

    ChaserNode(
        NodeType type, @Nullable String name, SourceLocation location, FollowerValueSpace space) {
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

    DamperNode(
        NodeType type, @Nullable String name, SourceLocation location, FollowerValueSpace space) {
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
