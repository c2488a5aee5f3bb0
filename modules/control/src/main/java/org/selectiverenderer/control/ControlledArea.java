package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.selectiverenderer.schema.SensorSchemas;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.environmentalsensor.ProximitySensor;

/** An area: a ProximitySensor with the schemas that its metadata names. */
final class ControlledArea {
  /** Receives the events of areas, with the time stamp in seconds. */
  interface Listener {
    void entered(ControlledArea area, double time);

    void left(ControlledArea area, double time);

    /** The metadata has changed; {@link ControlledArea#read()} reads it anew. */
    void metadataChanged(ControlledArea area, double time);
  }

  private final ProximitySensor sensor;
  private final Supplier<String> name;
  private final X3DField enterTime;
  private final X3DField exitTime;
  private final X3DFieldEventListener onEnter;
  private final X3DFieldEventListener onExit;
  private final MetadataWatcher watch;
  private final SchemaCache cache;
  private List<ControlProblem> problems = List.of();
  private Optional<SensorSchemas> schemas = Optional.empty();

  /**
   * Reads an area in its present state.
   *
   * @param cache reads the metadata
   */
  ControlledArea(
      ProximitySensor sensor,
      Supplier<String> name,
      ListenerLock turn,
      SchemaCache cache,
      Listener listener) {
    this.sensor = sensor;
    this.name = name;
    this.cache = cache;
    this.enterTime = sensor.getField("enterTime");
    this.exitTime = sensor.getField("exitTime");
    this.onEnter = event -> turn.take(() -> listener.entered(this, event.getTime()));
    this.onExit = event -> turn.take(() -> listener.left(this, event.getTime()));
    this.watch = new MetadataWatcher(sensor, turn, time -> listener.metadataChanged(this, time));
    enterTime.addX3DEventListener(onEnter);
    exitTime.addX3DEventListener(onExit);
    read();
  }

  /** Reads the metadata anew. */
  void read() {
    List<ControlProblem> found = new ArrayList<>();
    schemas =
        watch
            .read()
            .flatMap(
                metadata ->
                    cache.area(
                        metadata,
                        problem ->
                            found.add(
                                ControlProblem.warning(
                                    name(),
                                    ((SaiMetadata) problem.metadata()).node(),
                                    problem.message()))));
    problems = List.copyOf(found);
  }

  String name() {
    return name.get();
  }

  /**
   * Returns the area's schemas; empty if the metadata does not use the vocabulary, so that the
   * sensor is no area.
   */
  Optional<SensorSchemas> schemas() {
    return schemas;
  }

  /** Returns whether the viewer is in the area, according to the sensor. */
  boolean active() {
    return sensor.getIsActive();
  }

  /** Returns the time of the last entry, in seconds. */
  double lastEntry() {
    return sensor.getEnterTime();
  }

  ProximitySensor sensor() {
    return sensor;
  }

  List<ControlProblem> problems() {
    return problems;
  }

  /** Removes all listeners from the sensor. */
  void close() {
    FieldListeners.remove(enterTime, onEnter);
    FieldListeners.remove(exitTime, onExit);
    watch.close();
  }
}
