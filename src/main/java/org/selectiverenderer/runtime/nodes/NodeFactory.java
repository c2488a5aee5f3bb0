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
import org.selectiverenderer.runtime.nodes.shape.GeneratedCubeNode;
import org.selectiverenderer.runtime.nodes.shape.InstancedShapeNode;
import org.selectiverenderer.runtime.nodes.sound.Sounds;
import org.selectiverenderer.runtime.nodes.spline.SplineInterpolators;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.NodeMaker;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Makes a node for a node type: an instance of the class that implements the type's behaviour, or a
 * plain node. Constructors are looked up on demand, since creating them all would slow down every
 * start of the program.
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
      case "GeneratedCubeMapTexture" -> GeneratedCubeNode::new;
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

  /** Returns the constructors of a component that has a package of its own. */
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

  /** Each node gets its own interpolation object, which holds scratch variables. */
  private static NodeMaker interpolating(Supplier<Blend> blend) {
    return (type, name, location) -> new InterpolatorNode(type, name, location, blend.get());
  }

  /** Makes a node with all fields at their defaults. */
  public Node make(NodeType type, @Nullable String name, Location location) {
    NodeMaker maker = maker(type);
    return maker == null ? new Node(type, name, location) : maker.make(type, name, location);
  }

  /**
   * Returns whether this browser supports a node type: its nodes behave, are drawn, give light, or
   * hold data that is read. Nodes of other types only keep their fields.
   */
  public boolean actsOn(NodeType type) {
    return maker(type) != null || PassiveNodes.isRead(type.name());
  }
}
