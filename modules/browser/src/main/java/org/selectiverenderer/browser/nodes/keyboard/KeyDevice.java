package org.selectiverenderer.browser.nodes.keyboard;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.NodeConstructor;

/**
 * The keyboard of a world (X3D 4.0, 21.2): passes key events to the active sensor, which is the one
 * enabled last. Belongs to the thread that steps the world; only {@link #type} may be called by
 * other threads.
 */
public final class KeyDevice {
  /** The constructors of the key device sensors, by node type name. */
  public static final Map<String, NodeConstructor> MAKERS =
      Map.of("KeySensor", KeySensorNode::new, "StringSensor", StringSensorNode::new);

  private final ConcurrentLinkedQueue<KeyboardEvent> typed = new ConcurrentLinkedQueue<>();
  private Set<KeyDeviceSensorNode> sensors = Set.of();
  private @Nullable KeyDeviceSensorNode active;

  /** Reports that a key went down or up; the sensor receives it in the next step. Thread-safe. */
  public void type(KeyboardEvent stroke) {
    typed.add(stroke);
  }

  /**
   * Returns whether the scene consumes a key, so that the program must not react to it: keys that
   * the active sensor uses, except function and modifier keys.
   */
  public boolean takes(KeyboardEvent.Key key) {
    boolean shared =
        key instanceof KeyboardEvent.Modifier
            || key instanceof KeyboardEvent.Action action && action.function();
    return !shared && active != null && active.wants(key);
  }

  /** Sets the scene's key device sensors, in document order. */
  public void follow(List<KeyDeviceSensorNode> now, EventCascade cascade) {
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

  /** Is called when a sensor has been enabled or disabled. */
  void enabled(KeyDeviceSensorNode sensor, EventCascade cascade) {
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

  /** Passes the key events since the last frame to the active sensor. */
  public void frame(EventCascade cascade) {
    for (KeyboardEvent stroke = typed.poll(); stroke != null; stroke = typed.poll()) {
      if (active != null) {
        active.type(stroke, cascade);
      }
    }
  }
}
