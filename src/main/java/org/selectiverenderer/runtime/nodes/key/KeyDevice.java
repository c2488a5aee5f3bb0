package org.selectiverenderer.runtime.nodes.key;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.NodeMaker;

/**
 * The keyboard of a world (X3D 4.0, 21.2): gives what is typed to the sensor that is active, the
 * one that was enabled last. Belongs to the thread that steps the world; only {@link #type} may be
 * called by others.
 */
public final class KeyDevice {
  /** The key device sensors by the names of their types. */
  public static final Map<String, NodeMaker> MAKERS =
      Map.of("KeySensor", KeySensorNode::new, "StringSensor", StringSensorNode::new);

  private final ConcurrentLinkedQueue<KeyStroke> typed = new ConcurrentLinkedQueue<>();
  private Set<KeyDeviceSensorNode> sensors = Set.of();
  private @Nullable KeyDeviceSensorNode active;

  /** A key went down or up; the sensor hears of it in the next step. Thread-safe. */
  public void type(KeyStroke stroke) {
    typed.add(stroke);
  }

  /**
   * Whether a key is the scene's alone, and so nothing of the program's: what the active sensor
   * listens to, but for function keys and those that only change others.
   */
  public boolean takes(KeyStroke.Key key) {
    boolean shared =
        key instanceof KeyStroke.Modifier
            || key instanceof KeyStroke.Action action && action.function();
    return !shared && active != null && active.wants(key);
  }

  /** Follows the scene with the sensors that it has, in document order. */
  public void follow(List<KeyDeviceSensorNode> now, Cascade cascade) {
    Set<KeyDeviceSensorNode> before = sensors;
    sensors = new LinkedHashSet<>(now);
    for (KeyDeviceSensorNode gone : before) {
      if (!sensors.contains(gone)) {
        gone.join(null);
        if (active == gone) {
          active = null;
          gone.activate(false, cascade);
        }
      }
    }
    for (KeyDeviceSensorNode sensor : sensors) {
      if (!before.contains(sensor)) {
        sensor.join(this);
        enabled(sensor, cascade);
      }
    }
  }

  /** A sensor is enabled or no longer is. */
  void enabled(KeyDeviceSensorNode sensor, Cascade cascade) {
    KeyDeviceSensorNode before = active;
    if (sensor.enabled() && before != sensor) {
      active = sensor;
      if (before != null) {
        before.disable(cascade);
        before.activate(false, cascade);
      }
      sensor.activate(true, cascade);
    } else if (!sensor.enabled() && before == sensor) {
      active = null;
      sensor.activate(false, cascade);
    }
  }

  /** Tells the active sensor what was typed since the last frame. */
  public void frame(Cascade cascade) {
    for (KeyStroke stroke = typed.poll(); stroke != null; stroke = typed.poll()) {
      if (active != null) {
        active.type(stroke, cascade);
      }
    }
  }
}
