package org.selectiverenderer.runtime.nodes.pick;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.NodeMaker;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A sensor that says which shapes its own geometry meets (X3D 4.0, X3DPickSensorNode, 38.3.2). Who
 * looks for them tells it; it sorts them and sends what is new: {@code isActive}, {@code
 * pickedGeometry}, then where they were met. One that is disabled while active ends that at once.
 */
public final class PickSensorNode extends Node {
  public static final Map<String, NodeMaker> MAKERS =
      Map.of(
          "LinePickSensor", PickSensorNode::new,
          "PointPickSensor", PickSensorNode::new,
          "PrimitivePickSensor", PickSensorNode::new,
          "VolumePickSensor", PickSensorNode::new);

  /** What a sensor meets shapes with. */
  public enum With {
    LINES,
    POINTS,
    PRIMITIVE,
    HULL
  }

  private final With with;
  private final int enabled;
  private final int isActive;
  private final int pickedGeometry;
  private final int pickedPoint;
  private final int pickedNormal;
  private final int pickedTextureCoordinate;

  public PickSensorNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    with =
        switch (type.name()) {
          case "LinePickSensor" -> With.LINES;
          case "PointPickSensor" -> With.POINTS;
          case "PrimitivePickSensor" -> With.PRIMITIVE;
          default -> With.HULL;
        };
    enabled = type.indexOf("enabled");
    isActive = type.indexOf("isActive");
    pickedGeometry = type.indexOf("pickedGeometry");
    pickedPoint = output("pickedPoint");
    pickedNormal = output("pickedNormal");
    pickedTextureCoordinate = output("pickedTextureCoordinate");
  }

  private int output(String name) {
    return type().field(name).map(FieldDefinition::index).orElse(-1);
  }

  public With with() {
    return with;
  }

  public boolean enabled() {
    return (Boolean) value(enabled);
  }

  /** Whether a field says what it picks with, or what of all it picks. */
  public boolean asks(int field) {
    return field != isActive
        && field != pickedGeometry
        && field != pickedPoint
        && field != pickedNormal
        && field != pickedTextureCoordinate;
  }

  /** The labels of what it picks. */
  public PickLabels labels() {
    return new PickLabels(
        List.of(strings("objectType")), PickLabels.Criterion.of(string("matchCriterion")));
  }

  /** Whether the boxes around shapes are met, and not the shapes themselves. */
  public boolean bounds() {
    return !string("intersectionType").equals("GEOMETRY");
  }

  /** The nodes that it may pick, with all below them. */
  public List<Node> targets() {
    return nodes("pickTarget");
  }

  /** What it meets them with, in its local coordinates. */
  public @Nullable Node geometry() {
    return node("pickingGeometry");
  }

  /** Hears what is met in this frame, in no order. */
  public void report(List<Picked> met, Cascade cascade) {
    List<Picked> picked = chosen(met);
    boolean active = !picked.isEmpty();
    if (active != (Boolean) value(isActive)) {
      emit(isActive, active, cascade);
    }
    List<Node> nodes = picked.stream().map(Picked::node).distinct().toList();
    if (!nodes.equals(nodes("pickedGeometry"))) {
      emit(pickedGeometry, nodes, cascade);
    }
    sendPlaces(pickedTextureCoordinate, picked, Picked.Place::texCoord, cascade);
    sendPlaces(pickedNormal, picked, Picked.Place::normal, cascade);
    sendPlaces(pickedPoint, picked, Picked.Place::point, cascade);
  }

  /** Points have no order of their own: CLOSEST is ANY and ALL_SORTED is ALL (38.4.3). */
  private List<Picked> chosen(List<Picked> met) {
    String order = string("sortOrder");
    boolean all = order.startsWith("ALL");
    boolean sorted = with != With.POINTS && (order.equals("ALL_SORTED") || order.equals("CLOSEST"));
    List<Picked> list =
        sorted ? met.stream().sorted(Comparator.comparingDouble(Picked::distance)).toList() : met;
    return all || list.isEmpty() ? list : list.subList(0, 1);
  }

  private void sendPlaces(
      int field,
      List<Picked> picked,
      Function<Picked.Place, @Nullable Vector3dc> part,
      Cascade cascade) {
    if (field < 0) {
      return;
    }
    List<@Nullable Vector3dc> known =
        picked.stream().flatMap(one -> one.places().stream()).map(part).toList();
    boolean any = known.stream().anyMatch(Objects::nonNull);
    float[] values = new float[any ? 3 * known.size() : 0];
    for (int i = 0; 3 * i < values.length; i++) {
      Vector3dc at = known.get(i) == null ? new Vector3d() : known.get(i);
      values[3 * i] = (float) at.x();
      values[3 * i + 1] = (float) at.y();
      values[3 * i + 2] = (float) at.z();
    }
    if (!Arrays.equals(values, (float[]) value(field))) {
      emit(field, values, cascade);
    }
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    super.receive(field, value, cascade);
    if (field.index() == enabled && !enabled() && (Boolean) value(isActive)) {
      emit(isActive, false, cascade);
    }
  }
}
