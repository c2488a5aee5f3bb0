package org.selectiverenderer.validation.language;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** SR16x: lists whose numbers depend on each other. */
final class SequenceRules {
  static final Rule KEY_COUNT =
      Rule.warning("SR161", "{field} has {count} values, but {needed} for {keys} keys")
          .because(
              """
              Each key of an interpolator or sequencer has its value (of a CoordinateInterpolator: as \
              many points as every other key). What is missing or too much is read differently by \
              each browser.""")
          .bad("<ScalarInterpolator key='0 0.5 1' keyValue='0 1'/>")
          .good("<ScalarInterpolator key='0 0.5 1' keyValue='0 1 0'/>")
          .see("X3D 4.0, 19.2.3");

  static final Rule KEY_ORDER =
      Rule.warning("SR162", "key goes back from {before} to {after}")
          .because(
              "Keys never decrease; what an interpolator sends for keys out of order is not defined.")
          .bad("<ScalarInterpolator key='0 1 0.5' keyValue='0 1 0'/>")
          .good("<ScalarInterpolator key='0 0.5 1' keyValue='0 1 0'/>")
          .see("X3D 4.0, 19.2.3");

  static final Rule RANGE_ORDER =
      Rule.warning("SR163", "range does not grow from {before} to {after}")
          .because(
              """
              The ranges of an LOD are distances, each greater than the one before it; a level \
              between ranges that do not grow is never shown.""")
          .bad("<LOD range='20 10'><Group/><Group/><Group/></LOD>")
          .good("<LOD range='10 20'><Group/><Group/><Group/></LOD>")
          .see("X3D 4.0, 23.4.3");

  static final List<Rule> ALL = List.of(KEY_COUNT, KEY_ORDER, RANGE_ORDER);

  private SequenceRules() {}
}
