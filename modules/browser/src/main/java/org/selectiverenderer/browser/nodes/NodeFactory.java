package org.selectiverenderer.browser.nodes;

import java.util.Map;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.bindable.BindableNode;
import org.selectiverenderer.browser.nodes.bindable.ViewpointNode;
import org.selectiverenderer.browser.nodes.drag.DragSensorConstructors;
import org.selectiverenderer.browser.nodes.event.EaseInEaseOutNode;
import org.selectiverenderer.browser.nodes.event.EventUtilities;
import org.selectiverenderer.browser.nodes.event.InterpolatorNode;
import org.selectiverenderer.browser.nodes.event.KeyValueInterpolation;
import org.selectiverenderer.browser.nodes.event.SequencerNode;
import org.selectiverenderer.browser.nodes.follow.FollowerNodes;
import org.selectiverenderer.browser.nodes.geospatial.GeospatialNodeConstructors;
import org.selectiverenderer.browser.nodes.group.BillboardNode;
import org.selectiverenderer.browser.nodes.group.CadFaceNode;
import org.selectiverenderer.browser.nodes.group.CollidableNode;
import org.selectiverenderer.browser.nodes.group.CollisionNode;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.nodes.group.LodNode;
import org.selectiverenderer.browser.nodes.group.SwitchNode;
import org.selectiverenderer.browser.nodes.group.TransformNode;
import org.selectiverenderer.browser.nodes.hanim.HAnimHumanoidNode;
import org.selectiverenderer.browser.nodes.hanim.HAnimMotionNode;
import org.selectiverenderer.browser.nodes.hanim.HAnimSegmentNode;
import org.selectiverenderer.browser.nodes.keyboard.KeyDevice;
import org.selectiverenderer.browser.nodes.layout.LayoutNodeConstructors;
import org.selectiverenderer.browser.nodes.network.LoadSensorNode;
import org.selectiverenderer.browser.nodes.particle.ParticleSystemNode;
import org.selectiverenderer.browser.nodes.picking.PickSensorNode;
import org.selectiverenderer.browser.nodes.script.ScriptNode;
import org.selectiverenderer.browser.nodes.sensor.ProximitySensorNode;
import org.selectiverenderer.browser.nodes.sensor.TimeSensorNode;
import org.selectiverenderer.browser.nodes.sensor.TouchSensorNode;
import org.selectiverenderer.browser.nodes.sensor.TransformSensorNode;
import org.selectiverenderer.browser.nodes.sensor.VisibilitySensorNode;
import org.selectiverenderer.browser.nodes.shader.ShaderNodeConstructors;
import org.selectiverenderer.browser.nodes.shape.GeneratedCubeMapTextureNode;
import org.selectiverenderer.browser.nodes.shape.InstancedShapeNode;
import org.selectiverenderer.browser.nodes.sound.SoundNodeConstructors;
import org.selectiverenderer.browser.nodes.spline.SplineInterpolators;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeConstructor;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Makes a node for a node type: an instance of the class that implements the type's behaviour, or a
 * plain node. Constructors are looked up on demand, since creating them all would slow down every
 * start of the program.
 */
public final class NodeFactory {
  private static @Nullable NodeConstructor maker(NodeType type) {
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
      case "HAnimHumanoid" -> HAnimHumanoidNode::new;
      case "HAnimMotion" -> HAnimMotionNode::new;
      case "HAnimSegment" -> HAnimSegmentNode::new;
      case "ParticleSystem" -> ParticleSystemNode::new;
      case "CollidableShape", "CollidableOffset" -> CollidableNode::new;
      case "InstancedShape" -> InstancedShapeNode::new;
      case "GeneratedCubeMapTexture" -> GeneratedCubeMapTextureNode::new;
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
      case "ScalarInterpolator" -> interpolating(() -> KeyValueInterpolation.linear(1));
      case "PositionInterpolator2D", "CoordinateInterpolator2D" ->
          interpolating(() -> KeyValueInterpolation.linear(2));
      case "PositionInterpolator", "CoordinateInterpolator" ->
          interpolating(() -> KeyValueInterpolation.linear(3));
      case "OrientationInterpolator" -> interpolating(KeyValueInterpolation::rotation);
      case "NormalInterpolator" -> interpolating(KeyValueInterpolation::normal);
      case "ColorInterpolator" -> interpolating(KeyValueInterpolation::hsv);
      default -> makers(type.component()).get(type.name());
    };
  }

  /** Returns the constructors of a component that has a package of its own. */
  private static Map<String, NodeConstructor> makers(String component) {
    return switch (component) {
      case "EventUtilities" -> EventUtilities.MAKERS;
      case "Followers" -> FollowerNodes.MAKERS;
      case "Geospatial" -> GeospatialNodeConstructors.MAKERS;
      case "Interpolation", "NURBS" -> SplineInterpolators.MAKERS;
      case "KeyDeviceSensor" -> KeyDevice.MAKERS;
      case "Layout" -> LayoutNodeConstructors.MAKERS;
      case "Picking" -> PickSensorNode.MAKERS;
      case "PointingDeviceSensor" -> DragSensorConstructors.MAKERS;
      case "Shaders" -> ShaderNodeConstructors.MAKERS;
      case "Sound", "Texturing" -> SoundNodeConstructors.MAKERS;
      default -> Map.of();
    };
  }

  /** Each node gets its own interpolation object, which holds scratch variables. */
  private static NodeConstructor interpolating(Supplier<KeyValueInterpolation> blend) {
    return (type, name, location) -> new InterpolatorNode(type, name, location, blend.get());
  }

  /** Makes a node with all fields at their defaults. */
  public Node make(NodeType type, @Nullable String name, SourceLocation location) {
    NodeConstructor maker = maker(type);
    return maker == null ? new Node(type, name, location) : maker.make(type, name, location);
  }

  /**
   * Returns whether this browser supports a node type: its nodes behave, are drawn, give light, or
   * hold data that is read. Nodes of other types only keep their fields.
   */
  public boolean actsOn(NodeType type) {
    return maker(type) != null || PassiveNodeTypes.isRead(type.name());
  }
}
