package org.selectiverenderer.runtime.nodes;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.NodeType;

/** Makes the node for a node type: the class with its behaviour where there is one. */
public final class NodeFactory {
  /** Makes a node of a type. */
  @FunctionalInterface
  public interface Maker {
    Node make(NodeType type, @Nullable String name, Location location);
  }

  /** Takes part in binding, but nothing looks foggy yet. */
  private static final String BOUND_ONLY = "Fog";

  private final Map<String, Maker> makers = new HashMap<>(EventUtilities.MAKERS);

  public NodeFactory() {
    put(
        GroupingNode::new,
        "Group",
        "StaticGroup",
        "Anchor",
        "CADAssembly",
        "CADLayer",
        "PickableGroup",
        "ViewpointGroup");
    put(TransformNode::new, "Transform", "CADPart");
    put(CadFaceNode::new, "CADFace");
    put(SwitchNode::new, "Switch");
    put(LodNode::new, "LOD");
    put(BillboardNode::new, "Billboard");
    put(CollisionNode::new, "Collision");
    put(InlineNode::new, "Inline");

    put(ProximitySensorNode::new, "ProximitySensor");
    put(TransformSensorNode::new, "TransformSensor");
    put(VisibilitySensorNode::new, "VisibilitySensor");
    put(TouchSensorNode::new, "TouchSensor");
    put(TimeSensorNode::new, "TimeSensor");

    put(BindableNode::new, "Background", "TextureBackground", "Fog");
    put(ViewpointNode::new, "Viewpoint", "OrthoViewpoint");
    put(NavigationInfoNode::new, "NavigationInfo");

    put(SequencerNode::new, "BooleanSequencer", "IntegerSequencer");
    put(EaseInEaseOutNode::new, "EaseInEaseOut");
    put(interpolating(() -> Blend.linear(1)), "ScalarInterpolator");
    put(interpolating(() -> Blend.linear(2)), "PositionInterpolator2D", "CoordinateInterpolator2D");
    put(interpolating(() -> Blend.linear(3)), "PositionInterpolator", "CoordinateInterpolator");
    put(interpolating(Blend::rotation), "OrientationInterpolator");
    put(interpolating(Blend::normal), "NormalInterpolator");
    put(interpolating(Blend::hsv), "ColorInterpolator");
  }

  private void put(Maker maker, String... names) {
    for (String name : List.of(names)) {
      makers.put(name, maker);
    }
  }

  /** Each node has a blend of its own, which keeps what it calculates with. */
  private static Maker interpolating(Supplier<Blend> blend) {
    return (type, name, location) -> new InterpolatorNode(type, name, location, blend.get());
  }

  /** A node with all fields at their defaults. */
  public Node make(NodeType type, @Nullable String name, Location location) {
    return makers.getOrDefault(type.name(), Node::new).make(type, name, location);
  }

  /**
   * Whether the runtime does something with nodes of a type: they behave, are drawn, light, or are
   * data that is read. Nodes of other types are kept with their fields, and that is all.
   */
  public boolean actsOn(NodeType type) {
    return !type.name().equals(BOUND_ONLY)
        && (makers.containsKey(type.name()) || PassiveNodes.isRead(type.name()));
  }
}
