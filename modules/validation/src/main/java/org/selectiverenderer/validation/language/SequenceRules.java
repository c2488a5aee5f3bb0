package org.selectiverenderer.validation.language;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** Declares the rules SR160 to SR169, about sequences of numbers, such as keys and ranges. */
final class SequenceRules {
  static final Rule KEY_COUNT =
      Rule.warning("SR161", "{field} has {count} values, but {needed} for {keys} keys")
          .because(
              """
              Each key of an interpolator or sequencer needs a value (in a \
              CoordinateInterpolator: the same number of points for each key). Browsers \
              differ in how they read missing or extra values.""")
          .bad("<ScalarInterpolator key='0 0.5 1' keyValue='0 1'/>")
          .good("<ScalarInterpolator key='0 0.5 1' keyValue='0 1 0'/>")
          .see("X3D 4.0, 19.2.3");

  static final Rule KEY_ORDER =
      Rule.warning("SR162", "key decreases from {before} to {after}")
          .because(
              "Keys must not decrease; the result of an interpolator with unordered "
                  + "keys is undefined.")
          .bad("<ScalarInterpolator key='0 1 0.5' keyValue='0 1 0'/>")
          .good("<ScalarInterpolator key='0 0.5 1' keyValue='0 1 0'/>")
          .see("X3D 4.0, 19.2.3");

  static final Rule RANGE_ORDER =
      Rule.warning("SR163", "range does not increase from {before} to {after}")
          .because(
              """
              The ranges of an LOD are distances, each greater than the one before. A level \
              between ranges that do not increase is never shown.""")
          .bad("<LOD range='20 10'><Group/><Group/><Group/></LOD>")
          .good("<LOD range='10 20'><Group/><Group/><Group/></LOD>")
          .see("X3D 4.0, 23.4.3");

  static final List<Rule> ALL = List.of(KEY_COUNT, KEY_ORDER, RANGE_ORDER);

  private SequenceRules() {}
}
