package org.selectiverenderer.authoring.geometry;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Welds the points of indexed faces: points that are equal within a tolerance, with equal normals,
 * colours and texture coordinates, become one. What has an index of its own keeps it. Faces are
 * welded only where the picture stays: not where normals are computed from which faces share
 * points.
 *
 * @param changes the changes of the text
 * @param welded how many points are left out
 * @param points how many points there were
 * @param tolerance the largest distance of points that are equal, in the units of the points
 */
record PointWelding(List<TextEdit> changes, int welded, int points, double tolerance) {
  /** The values that points have alongside, each of some numbers. */
  private record Values(NumberTokens numbers, int width) {}

  private static final Map<String, Integer> WIDTHS =
      Map.of("Normal", 3, "Color", 3, "ColorRGBA", 4, "TextureCoordinate", 2);

  private static final int INTERRUPTED_EVERY = 1024;

  private static final Set<String> HARMLESS = Set.of("Coordinate", "IS");

  /**
   * Plans the welding of faces.
   *
   * @param faces an IndexedFaceSet, IndexedTriangleSet or IndexedQuadSet
   * @throws EditRejectedException with what to do, if the picture or another node would change
   */
  static PointWelding of(
      CharSequence text, ElementTree tree, NodeConnections connections, DocumentElement faces) {
    refuseConnected(tree, connections, faces);
    return ofItself(text, faces);
  }

  /**
   * Refuses faces whose points others name, set or read. What else is refused, and how many points
   * are welded, depends on the text of the faces alone.
   */
  static void refuseConnected(
      ElementTree tree, NodeConnections connections, DocumentElement faces) {
    refusePrototypes(faces);
    if (connections.routed(faces)) {
      throw refused(faces, "are set by a ROUTE or from another file, with indices of the points");
    }
    refuseShared(tree, connections, coordinate(faces));
    alongside(faces).forEach(child -> refuseShared(tree, connections, child));
  }

  private static DocumentElement coordinate(DocumentElement faces) {
    return faces.children().stream()
        .filter(child -> child.name().equals("Coordinate"))
        .findFirst()
        .orElseThrow(() -> refused(faces, "have no Coordinate node"));
  }

  /** Returns the children whose values are found by the index of the points. */
  private static List<DocumentElement> alongside(DocumentElement faces) {
    boolean perFace = faces.name().equals("IndexedFaceSet");
    return faces.children().stream()
        .filter(
            child ->
                !HARMLESS.contains(child.name())
                    && !child.name().startsWith("Metadata")
                    && usesPointIndex(faces, child, perFace))
        .toList();
  }

  /** Plans the welding of faces that are not connected with others. */
  static PointWelding ofItself(CharSequence text, DocumentElement faces) {
    boolean perFace = faces.name().equals("IndexedFaceSet");
    refuseComputedNormals(faces, perFace);
    NumberTokens points = NumberTokens.of(text, coordinate(faces), "point");
    int count = points.size() / 3;
    List<Values> alongside =
        alongside(faces).stream().map(child -> values(text, faces, child, count)).toList();
    float[] p = points.floats();
    for (float number : p) {
      if (!Float.isFinite(number)) {
        throw refused(faces, "have a point that is not a number");
      }
    }
    NumberTokens index = NumberTokens.of(text, faces, perFace ? "coordIndex" : "index");
    int[] indices = index.indices();
    double tolerance = WeldingTolerance.of(p, indices, GeometryRepair.faces(faces.name(), indices));
    int[] same = representatives(p, count, tolerance, alongside);
    return changes(faces, index, indices, points, alongside, same, tolerance);
  }

  private static PointWelding changes(
      DocumentElement faces,
      NumberTokens index,
      int[] indices,
      NumberTokens points,
      List<Values> alongside,
      int[] same,
      double tolerance) {
    int[] place = new int[same.length];
    int kept = 0;
    for (int i = 0; i < same.length; i++) {
      place[i] = same[i] == i ? kept++ : place[same[i]];
    }
    List<TextEdit> changes = new ArrayList<>();
    if (kept < same.length) {
      for (int i = 0; i < indices.length; i++) {
        if (indices[i] < -1 || indices[i] >= same.length) {
          throw refused(faces, "have an index without a point");
        }
        if (indices[i] >= 0 && place[indices[i]] != indices[i]) {
          changes.add(index.replace(i, Integer.toString(place[indices[i]])));
        }
      }
      remove(points, 3, same, changes);
      alongside.forEach(values -> remove(values.numbers(), values.width(), same, changes));
    }
    return new PointWelding(changes, same.length - kept, same.length, tolerance);
  }

  /** Removes the values of points that are another's, each run of them at once. */
  private static void remove(NumberTokens from, int width, int[] same, List<TextEdit> changes) {
    for (int i = 0; i < same.length; i++) {
      int end = i;
      while (end < same.length && same[end] != end) {
        end++;
      }
      if (end > i) {
        changes.add(from.remove(width * i, width * end));
        i = end;
      }
    }
  }

  private static void refuseComputedNormals(DocumentElement faces, boolean perFace) {
    boolean given = faces.children().stream().anyMatch(child -> child.name().equals("Normal"));
    boolean flat =
        perFace
            ? number(faces, "creaseAngle") == 0
            : faces.text("normalPerVertex").filter(of -> of.strip().equals("false")).isPresent();
    if (!given && !flat) {
      throw refused(faces, "have no normals, and those computed for them would become smoother");
    }
  }

  private static double number(DocumentElement of, String field) {
    try {
      return of.text(field).map(String::strip).map(Double::parseDouble).orElse(0.0);
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  /** Returns whether a child's values are found by the index of the points. */
  private static boolean usesPointIndex(
      DocumentElement faces, DocumentElement child, boolean perFace) {
    String what =
        switch (child.name()) {
          case "Normal" -> "normal";
          case "Color", "ColorRGBA" -> "color";
          case "TextureCoordinate" -> "texCoord";
          default -> throw refused(faces, "have a " + child.name() + ", which is not welded");
        };
    boolean byFace =
        faces.text(what + "PerVertex").filter(of -> of.strip().equals("false")).isPresent();
    boolean own = perFace && faces.text(what + "Index").filter(of -> !of.isBlank()).isPresent();
    return !byFace && !own;
  }

  private static Values values(
      CharSequence text, DocumentElement faces, DocumentElement child, int count) {
    int width = WIDTHS.getOrDefault(child.name(), 3);
    String field =
        switch (child.name()) {
          case "Normal" -> "vector";
          case "TextureCoordinate" -> "point";
          default -> "color";
        };
    NumberTokens numbers = NumberTokens.of(text, child, field);
    if (numbers.size() < width * count) {
      throw refused(faces, "have fewer values in " + child.name() + " than points");
    }
    return new Values(numbers, width);
  }

  private static void refuseShared(
      ElementTree tree, NodeConnections connections, DocumentElement node) {
    refusePrototypes(node);
    boolean used =
        node.use().isPresent() || node.def().filter(def -> tree.used(def, node)).isPresent();
    if (used || connections.routed(node)) {
      throw new EditRejectedException(
          node
              + " is used by other nodes or routes too, whose indices would change their meaning;"
              + " give the faces a "
              + node.name()
              + " of their own first");
    }
  }

  private static void refusePrototypes(DocumentElement node) {
    if (NodeConnections.prototypes(node)) {
      throw new EditRejectedException(
          node
              + " has values that are fields of the prototype; what instances give them would"
              + " change its meaning, so the faces stay as they are");
    }
  }

  /**
   * A cell of a grid as wide as the tolerance.
   *
   * @param values hash of what points have alongside, so that many points in one place are told
   *     apart soon
   */
  private record Cell(long x, long y, long z, int values) {}

  /** Returns for each point the first one that it equals: itself if there is none before. */
  private static int[] representatives(
      float[] p, int count, double tolerance, List<Values> alongside) {
    List<float[]> values = alongside.stream().map(each -> each.numbers().floats()).toList();
    double width = Math.max(tolerance, Float.MIN_NORMAL);
    Map<Cell, List<Integer>> grid = new HashMap<>();
    int[] same = new int[count];
    for (int i = 0; i < count; i++) {
      if (i % INTERRUPTED_EVERY == 0 && Thread.currentThread().isInterrupted()) {
        throw new CancellationException(); // a check whose text has changed meanwhile
      }
      long x = (long) Math.floor(p[3 * i] / width);
      long y = (long) Math.floor(p[3 * i + 1] / width);
      long z = (long) Math.floor(p[3 * i + 2] / width);
      int hash = hash(alongside, values, i);
      same[i] = i;
      for (int k = 0; k < 27 && same[i] == i; k++) {
        Cell near = new Cell(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1, hash);
        for (int other : grid.getOrDefault(near, List.of())) {
          if (WeldingTolerance.distance(p, i, other) <= tolerance
              && alike(alongside, values, i, other)) {
            same[i] = Math.min(same[i], other);
          }
        }
      }
      if (same[i] == i) {
        grid.computeIfAbsent(new Cell(x, y, z, hash), cell -> new ArrayList<>()).add(i);
      }
    }
    return same;
  }

  private static int hash(List<Values> alongside, List<float[]> values, int point) {
    int hash = 0;
    for (int i = 0; i < values.size(); i++) {
      int width = alongside.get(i).width();
      float[] own = Arrays.copyOfRange(values.get(i), width * point, width * (point + 1));
      hash = 31 * hash + Arrays.hashCode(own);
    }
    return hash;
  }

  private static boolean alike(List<Values> alongside, List<float[]> values, int one, int other) {
    for (int i = 0; i < values.size(); i++) {
      int width = alongside.get(i).width();
      float[] all = values.get(i);
      if (!Arrays.equals(
          all, width * one, width * (one + 1), all, width * other, width * (other + 1))) {
        return false;
      }
    }
    return true;
  }

  private static EditRejectedException refused(DocumentElement faces, String why) {
    return new EditRejectedException(faces + " " + why + "; they stay as they are");
  }
}
