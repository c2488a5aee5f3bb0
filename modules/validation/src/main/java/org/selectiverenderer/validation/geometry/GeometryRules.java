package org.selectiverenderer.validation.geometry;

import java.util.List;
import java.util.concurrent.CancellationException;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;
import org.selectiverenderer.validation.SceneNodeIterator;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Declares the rules SR200 to SR299, about geometry. */
public final class GeometryRules {
  private static final String GOOD = triangle("0 1 2 -1", "0 0 0, 1 0 0, 0 1 0");

  static final Rule INDEX_OUT_OF_RANGE =
      Rule.error("SR201", "{field} names {what} {index}, but there are only {count}")
          .because(
              """
              A face with an index beyond the points cannot be drawn; browsers leave it out \
              or refuse the whole shape. Indices are counted from 0.""")
          .bad(triangle("0 1 3 -1", "0 0 0, 1 0 0, 0 1 0"))
          .good(GOOD)
          .see("X3D 4.0, 13.3.6");

  static final Rule COUNTS =
      Rule.warning("SR202", "{field} has {count} {what}, but {needed} are needed")
          .because(
              """
              There must be as many normals, colours and heights as points, faces or indices \
              that need them. Browsers differ in how they draw the rest.""")
          .bad(
              """
              <Shape><ElevationGrid xDimension='2' zDimension='2' height='0 1 0'/></Shape>""")
          .good(
              """
              <Shape><ElevationGrid xDimension='2' zDimension='2' height='0 1 0 1'/></Shape>""")
          .see("X3D 4.0, 11.2.3 and 13.3");

  static final Rule NO_AREA =
      Rule.warning("SR203", "{count} of {all} faces have no area; the first is face {first}")
          .because(
              """
              A face of fewer than three points, or whose points coincide or lie on a line, shows \
              nothing, but is counted, sent to the graphics card, and has no normal. Faces are \
              counted from 0.""")
          .bad(triangle("0 1 1 -1 0 1 2 -1", "0 0 0, 1 0 0, 0 1 0"))
          .good(GOOD)
          .see("X3D 4.0, 11.2.4");

  static final Rule TOO_FAR =
      Rule.warning(
              "SR204",
              "{field} has {value} as value {index}, too large for single precision: "
                  + "points one unit apart become equal")
          .because(
              """
              Coordinates have about seven digits. Far from the origin neighbouring points \
              become equal. Such values are usually mistakes or in another unit.""")
          .bad(triangle("0 1 2 -1", "0 0 0, 1 0 0, 0 1e8 0"))
          .good(GOOD)
          .see("X3D 4.0, 5.3.5");

  static final Rule NORMAL_LENGTH =
      Rule.warning(
              "SR205",
              "{count} of {all} normals do not have the length 1; the first is normal {first}")
          .because(
              """
              Light is computed with normals of length 1. Others make surfaces too bright or \
              too dark in browsers that do not correct them.""")
          .bad(normals("0 0 2, 0 0 1, 0 0 1"))
          .good(normals("0 0 1, 0 0 1, 0 0 1"))
          .see("X3D 4.0, 11.4.11");

  static final Rule NOTHING =
      Rule.warning("SR206", "the {type} has no {what}, so it shows nothing")
          .because("Geometry without points or faces is a leftover, or its data are missing.")
          .bad("<Shape><IndexedFaceSet><Coordinate point='0 0 0'/></IndexedFaceSet></Shape>")
          .good(GOOD)
          .see("X3D 4.0, 11.2.1");

  static final Rule NON_MANIFOLD =
      Rule.info("SR207", "edges shared by more than two faces: {count}; the first is {edge}")
          .because(
              """
              Surfaces of real objects have two faces at an edge. Where more meet, \
              simplification and radiosity cannot tell inside from outside. Ignore this if \
              it is intended.""")
          .bad(triangle("0 1 2 -1 1 0 3 -1 0 1 4 -1", "0 0 0, 1 0 0, 0 1 0, 0 0 1, 0 -1 0"))
          .good(triangle("0 1 2 -1 1 0 3 -1", "0 0 0, 1 0 0, 0 1 0, 0 0 1"))
          .see("thesis 4.2.1");

  /** What the enricher finds while a scene is edited; {@code validate} has no check of it. */
  static final Rule REPEATED_POINTS =
      Rule.info("SR208", "{count} of {all} points repeat another")
          .because(
              """
              Points of the same place, normal, colour and texture coordinate make a file larger \
              and hide from simplification that faces share an edge. The enricher finds them \
              where welding leaves the picture as it is, and welds them; validate does not look \
              for them, as many programs write them.""")
          .bad(triangle("0 1 2 -1 3 4 5 -1", "0 0 0, 1 0 0, 0 1 0, 0 1 0, 1 0 0, 1 1 0"))
          .good(triangle("0 1 2 -1 2 1 3 -1", "0 0 0, 1 0 0, 0 1 0, 1 1 0"))
          .see("X3D 4.0, 13.3.6");

  private GeometryRules() {}

  /** The rules and their checks. */
  public static RuleGroup group() {
    return new RuleGroup(
        "Geometry",
        List.of(
            INDEX_OUT_OF_RANGE,
            COUNTS,
            NO_AREA,
            TOO_FAR,
            NORMAL_LENGTH,
            NOTHING,
            NON_MANIFOLD,
            REPEATED_POINTS),
        List.of(
            new CompositeCheck(
                List.of(
                    new IndexRangeCheck(),
                    new ValueCountCheck(),
                    new PointAndNormalCheck(),
                    new MeshQualityCheck(),
                    new EmptyGeometryCheck()))),
        List.of());
  }

  private static String triangle(String indices, String points) {
    return """
        <Shape><IndexedFaceSet coordIndex='%s'>
          <Coordinate point='%s'/>
        </IndexedFaceSet></Shape>"""
        .formatted(indices, points);
  }

  private static String normals(String vectors) {
    return """
        <Shape><IndexedFaceSet coordIndex='0 1 2 -1'>
          <Coordinate point='0 0 0, 1 0 0, 0 1 0'/>
          <Normal vector='%s'/>
        </IndexedFaceSet></Shape>"""
        .formatted(vectors);
  }

  /** Runs several checks of geometry in one pass over the nodes of a file. */
  private record CompositeCheck(List<GeometryNodeCheck> parts) implements FileCheck {
    @Override
    public void check(FileContext file, FindingCollector findings) {
      GeometryFindingCollector found = new GeometryFindingCollector(file, findings);
      for (ParsedNode node : SceneNodeIterator.all(file.scene())) {
        if (Thread.currentThread().isInterrupted()) {
          throw new CancellationException("the check was interrupted"); // As between two checks.
        }
        if (node.type().is("X3DGeometryNode") || node.type().is("X3DGeometricPropertyNode")) {
          parts.forEach(part -> part.check(node, found));
        }
      }
    }
  }
}
