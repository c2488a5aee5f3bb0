package org.selectiverenderer.validation.geometry;

import java.util.List;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;

/** SR2xx: geometry. */
public final class GeometryRules {
  static final Rule INDEX_OUT_OF_RANGE =
      Rule.error("SR201", "{field} names point {index}, but there are only {count}")
          .because(
              """
              A face with an index beyond its points cannot be drawn; browsers leave it out or \
              refuse the whole shape.""")
          .bad(
              """
              <Shape><IndexedFaceSet coordIndex='0 1 3 -1'>
                <Coordinate point='0 0 0, 1 0 0, 0 1 0'/>
              </IndexedFaceSet></Shape>""")
          .good(
              """
              <Shape><IndexedFaceSet coordIndex='0 1 2 -1'>
                <Coordinate point='0 0 0, 1 0 0, 0 1 0'/>
              </IndexedFaceSet></Shape>""")
          .see("X3D 4.0, 13.3.6");

  private GeometryRules() {}

  public static RuleGroup group() {
    return new RuleGroup(
        "Geometry", List.of(INDEX_OUT_OF_RANGE), List.of(new IndexCheck()), List.of());
  }
}
