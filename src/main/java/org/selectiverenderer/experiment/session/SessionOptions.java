package org.selectiverenderer.experiment.session;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.control.Condition;

/**
 * How a session is run. All of it is recorded.
 *
 * @param condition the experimenter's choice instead of the schedule's
 * @param exposure seconds of each exposure instead of the study's, for tests
 * @param unattended whether a simulated participant takes part, for tests
 * @param software name and version of the program
 */
public record SessionOptions(
    Optional<Condition> condition, OptionalDouble exposure, boolean unattended, String software) {

  /** What the journal says of it. */
  Map<String, Object> recorded() {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("software", software);
    values.put(
        "java", System.getProperty("java.version") + " " + System.getProperty("java.vendor"));
    values.put(
        "machine",
        String.join(
            " ",
            System.getProperty("os.name"),
            System.getProperty("os.version"),
            System.getProperty("os.arch"),
            Runtime.getRuntime().availableProcessors() + " processors"));
    values.put("unattended", unattended);
    exposure.ifPresent(seconds -> values.put("exposure_s", seconds));
    return values;
  }
}
