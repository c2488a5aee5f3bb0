package org.selectiverenderer.runtime.nodes;

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
import org.selectiverenderer.runtime.nodes.group.CollidableNode;
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
import org.selectiverenderer.runtime.nodes.layout.Layouts;
import org.selectiverenderer.runtime.nodes.network.LoadSensorNode;
import org.selectiverenderer.runtime.nodes.particle.ParticleSystemNode;
import org.selectiverenderer.runtime.nodes.pick.PickSensorNode;
import org.selectiverenderer.runtime.nodes.script.ScriptNode;
import org.selectiverenderer.runtime.nodes.sensor.ProximitySensorNode;
import org.selectiverenderer.runtime.nodes.sensor.TimeSensorNode;
import org.selectiverenderer.runtime.nodes.sensor.TouchSensorNode;
import org.selectiverenderer.runtime.nodes.sensor.TransformSensorNode;
import org.selectiverenderer.runtime.nodes.sensor.VisibilitySensorNode;
import org.selectiverenderer.runtime.nodes.shader.Shaders;
import org.selectiverenderer.runtime.nodes.shape.InstancedShapeNode;
import org.selectiverenderer.runtime.nodes.sound.Sounds;
import org.selectiverenderer.runtime.nodes.spline.SplineInterpolators;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.NodeMaker;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Makes the node for a node type: the class with its behaviour where there is one. A maker is found
 * when it is asked for, as to make all of them would cost each start of the program.
 */
public final class NodeFactory {
  private static @Nullable NodeMaker maker(NodeType type) {
    return switch (type.name()) {
      case "Group",
          "StaticGroup",
          "Anchor",
          "CADAssembly",
          "CADLayer",
          "PickableGroup",
          "Layer",
          "Viewport",
          "ViewpointGroup" ->
          GroupingNode::new;
      case "Transform", "CADPart", "EspduTransform", "HAnimJoint", "HAnimSite" ->
          TransformNode::new;
      case "HAnimHumanoid" -> HumanoidNode::new;
      case "HAnimMotion" -> MotionNode::new;
      case "HAnimSegment" -> SegmentNode::new;
      case "ParticleSystem" -> ParticleSystemNode::new;
      case "CollidableShape", "CollidableOffset" -> CollidableNode::new;
      case "InstancedShape" -> InstancedShapeNode::new;
      case "CADFace" -> CadFaceNode::new;
      case "Switch" -> SwitchNode::new;
      case "LOD" -> LodNode::new;
      case "Billboard" -> BillboardNode::new;
      case "Collision" -> CollisionNode::new;
      case "Inline" -> InlineNode::new;

      case "ProximitySensor" -> ProximitySensorNode::new;
      case "TransformSensor" -> TransformSensorNode::new;
      case "VisibilitySensor" -> VisibilitySensorNode::new;
      case "TouchSensor" -> TouchSensorNode::new;
      case "TimeSensor" -> TimeSensorNode::new;
      case "LoadSensor" -> LoadSensorNode::new;

      case "Background", "TextureBackground", "Fog", "NavigationInfo" -> BindableNode::new;
      case "Script" -> ScriptNode::new;
      case "Viewpoint", "OrthoViewpoint" -> ViewpointNode::new;

      case "BooleanSequencer", "IntegerSequencer" -> SequencerNode::new;
      case "EaseInEaseOut" -> EaseInEaseOutNode::new;
      case "ScalarInterpolator" -> interpolating(() -> Blend.linear(1));
      case "PositionInterpolator2D", "CoordinateInterpolator2D" ->
          interpolating(() -> Blend.linear(2));
      case "PositionInterpolator", "CoordinateInterpolator" -> interpolating(() -> Blend.linear(3));
      case "OrientationInterpolator" -> interpolating(Blend::rotation);
      case "NormalInterpolator" -> interpolating(Blend::normal);
      case "ColorInterpolator" -> interpolating(Blend::hsv);
      default -> makers(type.component()).get(type.name());
    };
  }

  /** Those of the components that have a package of their own. */
  private static Map<String, NodeMaker> makers(String component) {
    return switch (component) {
      case "EventUtilities" -> EventUtilities.MAKERS;
      case "Followers" -> Followers.MAKERS;
      case "Geospatial" -> Geospatial.MAKERS;
      case "Interpolation", "NURBS" -> SplineInterpolators.MAKERS;
      case "KeyDeviceSensor" -> KeyDevice.MAKERS;
      case "Layout" -> Layouts.MAKERS;
      case "Picking" -> PickSensorNode.MAKERS;
      case "PointingDeviceSensor" -> DragSensors.MAKERS;
      case "Shaders" -> Shaders.MAKERS;
      case "Sound", "Texturing" -> Sounds.MAKERS;
      default -> Map.of();
    };
  }

  /** Each node has a blend of its own, which keeps what it calculates with. */
  private static NodeMaker interpolating(Supplier<Blend> blend) {
    return (type, name, location) -> new InterpolatorNode(type, name, location, blend.get());
  }

  /** A node with all fields at their defaults. */
  public Node make(NodeType type, @Nullable String name, Location location) {
    NodeMaker maker = maker(type);
    return maker == null ? new Node(type, name, location) : maker.make(type, name, location);
  }

  /**
   * Whether the runtime does something with nodes of a type: they behave, are drawn, light, or are
   * data that is read. Nodes of other types are kept with their fields, and that is all.
   */
  public boolean actsOn(NodeType type) {
    return maker(type) != null || PassiveNodes.isRead(type.name());
  }
}
