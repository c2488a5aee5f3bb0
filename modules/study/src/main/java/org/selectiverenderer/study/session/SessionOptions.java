package org.selectiverenderer.study.session;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * The options of a session, all of which are recorded.
 *
 * @param group name of the group that the experimenter chooses instead of the schedule
 * @param exposure duration of each exposure in seconds instead of the study's, for tests
 * @param unattended whether a simulated participant takes part, for tests
 * @param tracker replaces the study's tracker: none for a session without it, or the one that a
 *     search has found
 * @param software name and version of the program
 */
public record SessionOptions(
    Optional<String> group,
    OptionalDouble exposure,
    boolean unattended,
    Optional<TrackerSpec> tracker,
    String software) {

  /** Makes options with the study's tracker. */
  public SessionOptions(
      Optional<String> group, OptionalDouble exposure, boolean unattended, String software) {
    this(group, exposure, unattended, Optional.empty(), software);
  }

  /** Returns whether the session does without the study's tracker. */
  public boolean withoutTracker() {
    return tracker.filter(TrackerSpec.None.class::isInstance).isPresent();
  }

  /** Returns the quality flags that these options raise. */
  List<SessionFlag> flags() {
    List<SessionFlag> flags = new ArrayList<>();
    if (unattended) {
      flags.add(SessionFlag.SIMULATED);
    }
    if (exposure.isPresent()) {
      flags.add(SessionFlag.SHORTENED);
    }
    if (withoutTracker()) {
      flags.add(SessionFlag.TRACKER_ABSENT);
    }
    return flags;
  }

  /** Returns the options as members of a journal event. */
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
