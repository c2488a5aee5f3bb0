package org.selectiverenderer.authoring.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Creates the edits that repair faulty geometry. Each throws {@link EditRejectedException}, with
 * what to do, where a repair would change what the scene shows.
 */
public final class GeometryRepair {
  /** The kinds of repair. */
  public enum Kind {
    /** Gives normals the length 1. */
    NORMALIZE,
    /** Takes out faces that have no area. */
    REMOVE_EMPTY_FACES,
    /** Makes one of points that are equal. */
    WELD,
    /** Does so in all faces of the scene that are not accepted as they are. */
    WELD_ALL
  }

  /** Normals within this of length 1 are left alone. */
  private static final double TOLERANCE = 0.01;

  /** Six digits after the point: normals are no more exact. */
  private static final double DIGITS = 1e6;

  static final Set<String> INDEXED =
      Set.of("IndexedFaceSet", "IndexedTriangleSet", "IndexedQuadSet");

  private final SceneDocument document;

  /** Repairs elements of a document. */
  public GeometryRepair(SceneDocument document) {
    this.document = document;
  }

  /**
   * Returns the repair of what a rule of the validator or the {@link RepeatedPointsCheck} finds;
   * empty where there is none.
   *
   * @param rule id of the rule: {@code SR203}
   */
  public static Optional<Kind> of(String rule, DocumentElement element) {
    return switch (rule) {
      case "SR205" ->
          element.name().equals("Normal") ? Optional.of(Kind.NORMALIZE) : Optional.empty();
      case "SR203" ->
          INDEXED.contains(element.name())
              ? Optional.of(Kind.REMOVE_EMPTY_FACES)
              : Optional.empty();
      case RepeatedPointsCheck.RULE ->
          INDEXED.contains(element.name())
              ? Optional.of(Kind.WELD)
              : element.parent().isEmpty() ? Optional.of(Kind.WELD_ALL) : Optional.empty();
      default -> Optional.empty();
    };
  }

  /** Returns the edit of a repair. */
  public Edit edit(Kind kind, DocumentElement element) {
    return switch (kind) {
      case NORMALIZE -> normalize(element);
      case REMOVE_EMPTY_FACES -> removeEmptyFaces(element);
      case WELD -> weld(element);
      case WELD_ALL -> weldAll();
    };
  }

  private Edit weldAll() {
    ElementTree tree =
        document
            .tree()
            .orElseThrow(() -> new EditRejectedException("The text has a fault; mend it first"));
    String text = document.text().toString();
    NodeConnections connections = new NodeConnections();
    List<TextEdit> changes = new ArrayList<>();
    int welded = 0;
    int meshes = 0;
    for (DocumentElement faces : new WeldableFaces(text, tree).list()) {
      try {
        PointWelding welding = PointWelding.of(text, tree, connections, faces);
        if (welding.welded() > 0) {
          changes.addAll(welding.changes());
          welded += welding.welded();
          meshes++;
        }
      } catch (EditRejectedException e) {
        // These faces stay as they are, and are not listed either.
      }
    }
    if (meshes == 0) {
      throw new EditRejectedException("No points of the scene are equal; there is nothing to do");
    }
    return new Edit("Weld all: %d points of %d meshes".formatted(welded, meshes), changes);
  }

  private Edit weld(DocumentElement faces) {
    PointWelding welding =
        PointWelding.of(
            document.text(),
            document.tree().orElseThrow(() -> refused(faces, "are in a text with a fault")),
            new NodeConnections(),
            faces);
    if (welding.welded() == 0) {
      throw new EditRejectedException(
          "No points of " + faces + " are equal; there is nothing to do");
    }
    return new Edit("Weld %d points of %s".formatted(welding.welded(), faces), welding.changes());
  }

  private Edit normalize(DocumentElement normal) {
    NumberTokens numbers = NumberTokens.of(document.text(), normal, "vector");
    List<TextEdit> changes = new ArrayList<>();
    for (int i = 0; i + 2 < numbers.size(); i += 3) {
      double[] v = {numbers.number(i), numbers.number(i + 1), numbers.number(i + 2)};
      double length = TriangleMath.length(v);
      if (!(length > 0 && Double.isFinite(length)) || Math.abs(length - 1) <= TOLERANCE) {
        continue; // a vector without direction cannot be repaired
      }
      for (int k = 0; k < 3; k++) {
        double value = Math.rint(v[k] / length * DIGITS) / DIGITS + 0.0;
        changes.add(numbers.replace(i + k, DecimalFormatter.shortest(value)));
      }
    }
    if (changes.isEmpty()) {
      throw new EditRejectedException(
          "The normals of " + normal + " have no direction; remove the Normal node instead");
    }
    return new Edit("Normalize normals of " + normal, changes);
  }

  private Edit removeEmptyFaces(DocumentElement faces) {
    CharSequence text = document.text();
    boolean perFace = faces.name().equals("IndexedFaceSet");
    NumberTokens index = NumberTokens.of(text, faces, perFace ? "coordIndex" : "index");
    int[] indices = index.indices();
    float[] points = points(faces);
    List<int[]> all = faces(faces.name(), indices);
    List<Integer> empty = new ArrayList<>();
    for (int i = 0; i < all.size(); i++) {
      if (empty(indices, points, all.get(i))) {
        empty.add(i);
      }
    }
    if (empty.size() == all.size()) {
      throw new EditRejectedException(
          "No face of " + faces + " has an area; delete its Shape instead");
    }
    List<TextEdit> changes = new ArrayList<>();
    empty.forEach(face -> changes.add(removed(index, indices, all.get(face))));
    for (String other : List.of("normal", "color", "texCoord")) {
      along(faces, other, all, empty).forEach(changes::add);
    }
    return new Edit("Remove empty faces of " + faces, changes);
  }

  /** Returns the coordinates of the faces. */
  private float[] points(DocumentElement faces) {
    DocumentElement coordinate =
        faces.children().stream()
            .filter(child -> child.name().equals("Coordinate"))
            .findFirst()
            .orElseThrow(() -> refused(faces, "have no Coordinate node"));
    DocumentElement source =
        coordinate
            .use()
            .flatMap(name -> document.tree().flatMap(tree -> tree.named(name, coordinate)))
            .orElse(coordinate);
    if (NodeConnections.prototypes(source) || new NodeConnections().routed(source)) {
      throw refused(
          faces, "are set by a ROUTE, a prototype or another file, so they may get areas");
    }
    return NumberTokens.of(document.text(), source, "point").floats();
  }

  private static EditRejectedException refused(DocumentElement faces, String why) {
    return new EditRejectedException(
        "The points of " + faces + " " + why + "; change the faces in the source");
  }

  /**
   * Returns the faces of indices: start, end.
   *
   * @param name of the node
   */
  static List<int[]> faces(String name, int[] indices) {
    return name.equals("IndexedFaceSet")
        ? ended(indices)
        : blocks(indices, name.equals("IndexedQuadSet") ? 4 : 3);
  }

  /** Returns the faces of indices that -1 separates: start, end without it. */
  private static List<int[]> ended(int[] indices) {
    List<int[]> faces = new ArrayList<>();
    int from = 0;
    for (int i = 0; i <= indices.length; i++) {
      if (i == indices.length ? i > from : indices[i] == -1) {
        faces.add(new int[] {from, i});
        from = i + 1;
      }
    }
    return faces;
  }

  private static List<int[]> blocks(int[] indices, int size) {
    List<int[]> faces = new ArrayList<>();
    for (int i = 0; i + size <= indices.length; i += size) {
      faces.add(new int[] {i, i + size});
    }
    return faces;
  }

  private static boolean empty(int[] indices, float[] points, int[] face) {
    for (int i = face[0]; i < face[1]; i++) {
      if (indices[i] < 0 || 3L * indices[i] + 2 >= points.length) {
        return false; // another fault, not for this repair
      }
    }
    return face[1] - face[0] < 3 || !TriangleMath.hasArea(points, indices, face[0], face[1]);
  }

  private static TextEdit removed(NumberTokens numbers, int[] indices, int[] face) {
    boolean ends = face[1] < indices.length && indices[face[1]] == -1;
    return numbers.remove(face[0], ends ? face[1] + 1 : face[1]);
  }

  /**
   * Returns the changes of the indices of normals, colours or texture coordinates, from which the
   * same faces are taken out.
   */
  private List<TextEdit> along(
      DocumentElement faces, String what, List<int[]> all, List<Integer> empty) {
    boolean perVertex =
        what.equals("texCoord")
            || faces
                .text(what + "PerVertex")
                .filter(value -> value.strip().equals("false"))
                .isEmpty();
    NumberTokens other = NumberTokens.of(document.text(), faces, what + "Index");
    if (other.size() == 0) {
      boolean given =
          faces.children().stream()
              .anyMatch(child -> child.name().toLowerCase(Locale.ROOT).startsWith(what));
      if (!perVertex && given) {
        throw refused(faces, "have a " + what + " for each face in order");
      }
      return List.of();
    }
    int[] own = other.indices();
    List<TextEdit> changes = new ArrayList<>();
    if (!perVertex) {
      if (own.length != all.size()) {
        throw refused(faces, "have not one " + what + " for each face");
      }
      empty.forEach(face -> changes.add(other.remove(face, face + 1)));
      return changes;
    }
    List<int[]> same = ended(own);
    if (same.size() != all.size()) {
      throw refused(faces, "have another number of faces in " + what + "Index");
    }
    empty.forEach(face -> changes.add(removed(other, own, same.get(face))));
    return changes;
  }
}
