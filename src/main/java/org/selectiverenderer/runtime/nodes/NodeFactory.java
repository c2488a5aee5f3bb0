package org.selectiverenderer.runtime.nodes;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.nodes.bind.BindableNode;
import org.selectiverenderer.runtime.nodes.bind.ViewpointNode;
import org.selectiverenderer.runtime.nodes.drag.DragSensors;
import org.selectiverenderer.runtime.nodes.event.Blend;
import org.selectiverenderer.runtime.nodes.event.EaseInEaseOutNode;
import org.selectiverenderer.runtime.nodes.event.EventUtilities;
import org.selectiverenderer.runtime.nodes.event.InterpolatorNode;
import org.selectiverenderer.runtime.nodes.event.SequencerNode;
import org.selectiverenderer.runtime.nodes.follow.Followers;
import org.selectiverenderer.runtime.nodes.geo.Geospatial;
import org.selectiverenderer.runtime.nodes.group.BillboardNode;
import org.selectiverenderer.runtime.nodes.group.CadFaceNode;
import org.selectiverenderer.runtime.nodes.group.CollisionNode;
import org.selectiverenderer.runtime.nodes.group.GroupingNode;
import org.selectiverenderer.runtime.nodes.group.InlineNode;
import org.selectiverenderer.runtime.nodes.group.LodNode;
import org.selectiverenderer.runtime.nodes.group.SwitchNode;
import org.selectiverenderer.runtime.nodes.group.TransformNode;
import org.selectiverenderer.runtime.nodes.hanim.HumanoidNode;
import org.selectiverenderer.runtime.nodes.hanim.MotionNode;
import org.selectiverenderer.runtime.nodes.hanim.SegmentNode;
import org.selectiverenderer.runtime.nodes.key.KeyDevice;
import org.selectiverenderer.runtime.nodes.particle.ParticleSystemNode;
import org.selectiverenderer.runtime.nodes.pick.PickSensorNode;
import org.selectiverenderer.runtime.nodes.script.ScriptNode;
import org.selectiverenderer.runtime.nodes.sensor.ProximitySensorNode;
import org.selectiverenderer.runtime.nodes.sensor.TimeSensorNode;
import org.selectiverenderer.runtime.nodes.sensor.TouchSensorNode;
import org.selectiverenderer.runtime.nodes.sensor.TransformSensorNode;
import org.selectiverenderer.runtime.nodes.sensor.VisibilitySensorNode;
import org.selectiverenderer.runtime.nodes.sound.Sounds;
import org.selectiverenderer.runtime.nodes.spline.SplineInterpolators;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.NodeMaker;
import org.selectiverenderer.x3d.catalogue.NodeType;

/** Makes the node for a node type: the class with its behaviour where there is one. */
public final class NodeFactory {
  private final Map<String, NodeMaker> makers = new HashMap<>(EventUtilities.MAKERS);

  public NodeFactory() {
    makers.putAll(DragSensors.MAKERS);
    makers.putAll(KeyDevice.MAKERS);
    makers.putAll(Followers.MAKERS);
    makers.putAll(Geospatial.MAKERS);
    makers.putAll(PickSensorNode.MAKERS);
    makers.putAll(Sounds.MAKERS);
    makers.putAll(SplineInterpolators.MAKERS);
    put(
        GroupingNode::new,
        "Group",
        "StaticGroup",
        "Anchor",
        "CADAssembly",
        "CADLayer",
        "PickableGroup",
        "Layer",
        "ViewpointGroup");
    put(TransformNode::new, "Transform", "CADPart", "HAnimJoint", "HAnimSite");
    put(HumanoidNode::new, "HAnimHumanoid");
    put(MotionNode::new, "HAnimMotion");
    put(SegmentNode::new, "HAnimSegment");
    put(ParticleSystemNode::new, "ParticleSystem");
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

    put(BindableNode::new, "Background", "TextureBackground", "Fog", "NavigationInfo");
    put(ScriptNode::new, "Script");
    put(ViewpointNode::new, "Viewpoint", "OrthoViewpoint");

    put(SequencerNode::new, "BooleanSequencer", "IntegerSequencer");
    put(EaseInEaseOutNode::new, "EaseInEaseOut");
    put(interpolating(() -> Blend.linear(1)), "ScalarInterpolator");
    put(interpolating(() -> Blend.linear(2)), "PositionInterpolator2D", "CoordinateInterpolator2D");
    put(interpolating(() -> Blend.linear(3)), "PositionInterpolator", "CoordinateInterpolator");
    put(interpolating(Blend::rotation), "OrientationInterpolator");
    put(interpolating(Blend::normal), "NormalInterpolator");
    put(interpolating(Blend::hsv), "ColorInterpolator");
  }

  private void put(NodeMaker maker, String... names) {
    for (String name : List.of(names)) {
      makers.put(name, maker);
    }
  }

  /** Each node has a blend of its own, which keeps what it calculates with. */
  private static NodeMaker interpolating(Supplier<Blend> blend) {
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
    return makers.containsKey(type.name()) || PassiveNodes.isRead(type.name());
  }
}
