package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SensorSchemas;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.environmentalsensor.ProximitySensor;

/** A ProximitySensor and the schemas that its metadata names. */
final class ControlledArea {
  /** Hears what happens to areas, with the time stamp in seconds. */
  interface Listener {
    void entered(ControlledArea area, double time);

    void left(ControlledArea area, double time);

    /** The metadata is not what it was; {@link ControlledArea#read()} it. */
    void metadataChanged(ControlledArea area, double time);
  }

  private final ProximitySensor sensor;
  private final Supplier<String> name;
  private final X3DField enterTime;
  private final X3DField exitTime;
  private final X3DFieldEventListener onEnter;
  private final X3DFieldEventListener onExit;
  private final MetadataWatch watch;
  private List<ControlProblem> problems = List.of();
  private Optional<SensorSchemas> schemas = Optional.empty();

  ControlledArea(ProximitySensor sensor, Supplier<String> name, Turn turn, Listener listener) {
    this.sensor = sensor;
    this.name = name;
    this.enterTime = sensor.getField("enterTime");
    this.exitTime = sensor.getField("exitTime");
    this.onEnter = event -> turn.take(() -> listener.entered(this, event.getTime()));
    this.onExit = event -> turn.take(() -> listener.left(this, event.getTime()));
    this.watch = new MetadataWatch(sensor, turn, time -> listener.metadataChanged(this, time));
    enterTime.addX3DEventListener(onEnter);
    exitTime.addX3DEventListener(onExit);
    read();
  }

  /** Reads the metadata anew. */
  void read() {
    List<ControlProblem> found = new ArrayList<>();
    SchemaReader reader =
        new SchemaReader(
            problem ->
                found.add(
                    ControlProblem.warning(
                        name(), ((SaiMetadata) problem.metadata()).node(), problem.message())));
    schemas = watch.read().flatMap(reader::sensor);
    problems = List.copyOf(found);
  }

  String name() {
    return name.get();
  }

  /** Empty if the metadata has nothing of the vocabulary: the sensor is not ours. */
  Optional<SensorSchemas> schemas() {
    return schemas;
  }

  /** Whether the viewer is in the area, as the sensor says. */
  boolean active() {
    return sensor.getIsActive();
  }

  /** The time of the last entry, in seconds. */
  double lastEntry() {
    return sensor.getEnterTime();
  }

  ProximitySensor sensor() {
    return sensor;
  }

  List<ControlProblem> problems() {
    return problems;
  }

  /** Leaves the sensor without a listener. */
  void close() {
    FieldRelease.remove(enterTime, onEnter);
    FieldRelease.remove(exitTime, onExit);
    watch.close();
  }
}
