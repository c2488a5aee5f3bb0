package org.selectiverenderer.doctor.probe;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.factory.InterTrax2PortFinder;
import org.selectiverenderer.tracker.serial.SerialPorts;

/** Checks the serial ports, their permissions, and the tracker of the thesis. */
final class TrackerProbe {
  private static final String PORTS = "serial ports";
  private static final String TRACKER = "InterTrax2";

  private TrackerProbe() {}

  static void ports(Consumer<Diagnosis> found) {
    List<String> names = SerialPorts.names();
    if (names.isEmpty()) {
      found.accept(
          Diagnosis.missing(
              PORTS, "this machine has none", "for a serial tracker plug in its adapter"));
    }
    for (String name : names) {
      Optional<String> denied = SerialPorts.denied(name);
      found.accept(
          denied.isPresent()
              ? Diagnosis.warning(PORTS, denied.get(), "")
              : Diagnosis.ok(PORTS, name + ", accessible"));
    }
  }

  static void unasked(Consumer<Diagnosis> found) {
    found.accept(
        Diagnosis.ok(
            TRACKER,
            "not searched; doctor --ask-ports does, by sending its commands to all ports"));
  }

  static void search(Consumer<Diagnosis> found) throws InterruptedException {
    Optional<TrackerSpec> tracker = InterTrax2PortFinder.found(new TrackerSpec.InterTrax2("auto"));
    found.accept(
        tracker.isPresent()
            ? Diagnosis.ok(TRACKER, "answers at " + ((TrackerSpec.InterTrax2) tracker.get()).port())
            : Diagnosis.missing(
                TRACKER,
                "no serial port answers",
                "connect the tracker and its power, or name its port: track intertrax2:PORT"));
  }
}
