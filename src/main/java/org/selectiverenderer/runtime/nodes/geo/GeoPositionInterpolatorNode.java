package org.selectiverenderer.runtime.nodes.geo;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.geometry.geo.GeoFrame;
import org.selectiverenderer.runtime.nodes.event.KeyFrames;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * GeoPositionInterpolator (X3D 4.0, 25.3.8): interpolates places in their own coordinates, and
 * sends these and the point of the scene.
 */
final class GeoPositionInterpolatorNode extends Node {
  private final int fraction;
  private final int key;
  private final int keyValue;
  private final int geoValueChanged;
  private final int valueChanged;

  GeoPositionInterpolatorNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    fraction = type.indexOf("set_fraction");
    key = type.indexOf("key");
    keyValue = type.indexOf("keyValue");
    geoValueChanged = type.indexOf("geovalue_changed");
    valueChanged = type.indexOf("value_changed");
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    if (field.index() != fraction) {
      super.receive(field, value, cascade);
      return;
    }
    float at = (Float) value;
    float[] keys = (float[]) value(key);
    double[] values = (double[]) value(keyValue);
    int count = Math.min(keys.length, values.length / 3);
    if (count == 0 || Float.isNaN(at)) {
      return;
    }
    int low = KeyFrames.at(keys, count, at);
    boolean between = low < count - 1 && at > keys[low];
    double part = between ? (at - keys[low]) / (keys[low + 1] - keys[low]) : 0;
    double[] place = new double[3];
    for (int i = 0; i < 3; i++) {
      double from = values[3 * low + i];
      place[i] = between ? from + part * (values[3 * low + 3 + i] - from) : from;
    }
    Vector3d scene = GeoFrame.of(this).scene(place[0], place[1], place[2]);
    emit(geoValueChanged, place, cascade);
    emit(valueChanged, new float[] {(float) scene.x, (float) scene.y, (float) scene.z}, cascade);
  }
}
